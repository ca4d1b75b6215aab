using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P { static void Main() { int x; for (int i = 0; i < 3; i++) x = i; System.Console.WriteLine(x); } }
