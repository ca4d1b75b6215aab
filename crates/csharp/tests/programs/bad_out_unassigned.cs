using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P { static void F(out int y) { if (System.DateTime.Now.Year > 2000) y = 1; } static void Main() { int x; F(out x); } }
