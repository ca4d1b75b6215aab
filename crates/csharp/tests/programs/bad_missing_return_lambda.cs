using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P { static void Main() { System.Func<int, int> f = x => { if (x > 0) return 1; }; } }
