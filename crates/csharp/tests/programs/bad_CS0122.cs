using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class A { private int X; } class P { static void Main() { new A().X = 2; } }
