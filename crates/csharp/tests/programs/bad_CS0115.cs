using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class A { public override void F() { } } class P { static void Main() { } }
