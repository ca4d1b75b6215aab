using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class A { int x; string x; } class P { static void Main() { } }
