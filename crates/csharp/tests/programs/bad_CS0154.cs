using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class A { public int X { set { } } } class P { static void Main() { int y = new A().X; } }
