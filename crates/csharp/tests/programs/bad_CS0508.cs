using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class A { public virtual int F() { return 1; } } class B : A { public override string F() { return ""; } } class P { static void Main() { } }
