using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P { static void Main() { const int X = 1; X = 2; } }
