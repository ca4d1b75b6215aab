using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P { static void Main() { switch (1) { case 1: System.Console.WriteLine(); case 2: break; } } }
