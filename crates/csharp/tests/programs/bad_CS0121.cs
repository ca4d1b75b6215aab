using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P { static void F(int x, double y) { } static void F(double x, int y) { } static void Main() { F(1, 1); } }
