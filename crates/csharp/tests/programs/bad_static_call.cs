using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class A { public void F() { } } class P { static void Main() { A.F(); } }
