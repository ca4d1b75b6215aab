using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P { static void Main() { int x; bool b = System.DateTime.Now.Year > 2000; if (b && int.TryParse("1", out x)) { } else System.Console.WriteLine(x); } }
