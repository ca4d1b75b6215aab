using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

interface I { int X { get; } } class A : I { public int X; } class P { static void Main() { } }
