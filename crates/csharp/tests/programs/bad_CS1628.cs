using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P { static void F(ref int x) { System.Action a = () => x = 1; } static void Main() { } }
