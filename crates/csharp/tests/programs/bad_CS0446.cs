using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P { static void F() { } static void Main() { foreach (var x in F) { } } }
