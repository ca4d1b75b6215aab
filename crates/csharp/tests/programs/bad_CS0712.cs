using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class A { } class P { static void Main() { new A(); } }
