using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P { static void F(out int y) { System.Console.WriteLine(y); y = 1; } static void Main() { int x; F(out x); } }
