using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P { static void Main() { float f = 1.5; } }
