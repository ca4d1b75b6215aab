using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P { static System.Collections.Generic.IEnumerable<int> F() { try { yield return 1; } catch { } } static void Main() { } }
