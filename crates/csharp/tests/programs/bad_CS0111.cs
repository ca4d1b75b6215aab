using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class A { void F(int x) { } void F(int y) { } } class P { static void Main() { } }
