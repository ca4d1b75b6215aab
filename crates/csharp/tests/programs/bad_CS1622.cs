using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P { static System.Collections.Generic.IEnumerable<int> F() { yield return 1; return null; } static void Main() { } }
