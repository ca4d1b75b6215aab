using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

struct S { S s; } class P { static void Main() { } }
