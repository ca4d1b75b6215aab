using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P { static void Main() { ulong x = 99999999999999999999; } }
