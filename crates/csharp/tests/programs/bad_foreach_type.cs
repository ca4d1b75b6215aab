using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P { static void Main() { foreach (string s in new int[1]) { } } }
