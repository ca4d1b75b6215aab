using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class A { public int X { get { return 1; } } } class P { static void Main() { new A().X = 2; } }
