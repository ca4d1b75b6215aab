using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class A { public virtual void F() { } } class B : A { protected override void F() { } } class P { static void Main() { } }
