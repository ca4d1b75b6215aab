using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class A { } class P { static void Main() { var a = new A(); var s = a as string; } }
