using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class A { var x = 1; } class P { static void Main() { } }
