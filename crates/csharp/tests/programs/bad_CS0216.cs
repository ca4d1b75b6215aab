using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class A { public static bool operator ==(A a, A b) { return true; } } class P { static void Main() { } }
