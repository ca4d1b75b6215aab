using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P { static void Main() { var x = 1, y = 2; } }
