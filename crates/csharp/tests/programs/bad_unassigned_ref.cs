using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P { static void F(ref int y) { y++; } static void Main() { int x; F(ref x); } }
