using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P { const int X; static void Main() { } }
