using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P { static void F(int a) { } static void Main() { F(b: 1); } }
