using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P { static void Main() { System.Func<System.Collections.Generic.IEnumerable<int>> f = () => { yield return 1; }; } }
