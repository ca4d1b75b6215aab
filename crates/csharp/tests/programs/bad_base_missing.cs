using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class A { } class B : A { public void F() { base.Nope(); } } class P { static void Main() { } }
