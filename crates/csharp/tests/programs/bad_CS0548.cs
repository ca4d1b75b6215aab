using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class A { public int X { } } class P { static void Main() { } }
