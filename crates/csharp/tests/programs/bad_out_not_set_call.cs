using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P { static void F(out int a, int b) { a = b; } static void Main() { int x; F(out x, x); } }
