using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P { static bool F(out int y) { if (System.DateTime.Now.Year > 2000) return false; y = 1; return true; } static void Main() { int x; F(out x); } }
