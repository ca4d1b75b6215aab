using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class A { int x; } class P { static void Main() { } }
