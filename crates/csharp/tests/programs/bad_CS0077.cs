using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P { static void Main() { object o = 1; var s = o as int; } }
