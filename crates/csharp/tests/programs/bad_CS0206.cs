using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class A { public int X { get; set; } } class P { static void F(ref int x) { } static void Main() { var a = new A(); F(ref a.X); } }
