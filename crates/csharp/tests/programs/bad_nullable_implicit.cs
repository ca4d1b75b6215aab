using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P { static void Main() { int? n = 5; int x = n; } }
