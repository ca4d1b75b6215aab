using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

struct S : object { } class P { static void Main() { } }
