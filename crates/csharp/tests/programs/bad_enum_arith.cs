using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

enum E { A, B } class P { static void Main() { E e = E.A + E.B; } }
