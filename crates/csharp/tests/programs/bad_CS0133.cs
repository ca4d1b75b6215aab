using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P { static int y = 1; const int X = y; static void Main() { } }
