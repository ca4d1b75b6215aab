using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P { int x; static void Main() { x = 1; } }
