using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

interface I { void F(); } class B : I { } class P { static void Main() { } }
