using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P { static void F(out int x) { x = 1; } static void Main() { F(1); } }
