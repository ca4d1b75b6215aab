using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P { static void Main() { int x; int k = 3; switch (k) { case 1: x = 1; break; case 2: x = 2; break; } System.Console.WriteLine(x); } }
