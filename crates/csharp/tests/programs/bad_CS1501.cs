using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P { static void F(int x) { } static void Main() { F(1, 2); } }
