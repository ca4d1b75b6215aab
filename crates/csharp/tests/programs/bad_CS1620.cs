using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P { static void F(ref int x) { } static void Main() { int y = 1; F(y); } }
