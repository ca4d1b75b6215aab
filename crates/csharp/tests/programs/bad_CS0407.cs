using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P { static int F() { return 1; } static void Main() { System.Func<string> a = F; } }
