using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class A { static A operator +(A a, A b) { return a; } } class P { static void Main() { } }
