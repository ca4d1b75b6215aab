using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P { static void Main() { int y = 1; switch (1) { case y: break; } } }
