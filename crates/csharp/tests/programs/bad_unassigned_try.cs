using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P { static void Main() { int x; try { x = int.Parse("1"); } catch (System.FormatException) { } System.Console.WriteLine(x); } }
