using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

sealed class A { } class B : A { } class P { static void Main() { } }
