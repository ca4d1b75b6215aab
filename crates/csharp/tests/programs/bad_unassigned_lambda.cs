using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P { static void Main() { int x; System.Func<int> f = () => x; x = 1; System.Console.WriteLine(f()); } }
