using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class A : B { } class B : A { } class P { static void Main() { } }
