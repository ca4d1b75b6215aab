using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P { static void F(int a = 1, int b) { } static void Main() { } }
