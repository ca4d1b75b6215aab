using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

struct S { public int A, B; }
class P { static void Main() { S s; s.A = 1; S t = s; System.Console.WriteLine(t.A); } }
