using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class A { void A() { } } class P { static void Main() { } }
