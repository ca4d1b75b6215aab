using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class A { int x = 1; int y = x; } class P { static void Main() { } }
