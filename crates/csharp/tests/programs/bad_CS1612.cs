using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

struct S { public int X; } class A { public S P { get; set; } } class P { static void Main() { var a = new A(); a.P.X = 1; } }
