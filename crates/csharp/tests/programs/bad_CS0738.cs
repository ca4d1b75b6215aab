using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

interface I { int F(); } class A : I { public string F() { return ""; } } class P { static void Main() { } }
