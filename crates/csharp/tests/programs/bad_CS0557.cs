using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class A { public static implicit operator int(A a) { return 1; } public static explicit operator int(A a) { return 1; } } class P { static void Main() { } }
