using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P { static int F() { try { } finally { return 1; } } static void Main() { } }
