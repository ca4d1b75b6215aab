using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P { static void F(params int[] a, int b) { } static void Main() { } }
