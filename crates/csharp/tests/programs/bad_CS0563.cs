using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class A { public static int operator +(int a, int b) { return 1; } } class P { static void Main() { } }
