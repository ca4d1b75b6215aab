using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P { static void Main() { int x = 1; System.Action a = () => { int x = 2; }; } }
