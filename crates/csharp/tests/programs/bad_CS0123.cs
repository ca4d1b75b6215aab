using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P { static void F(string s) { } static void Main() { System.Action<int> a = F; } }
