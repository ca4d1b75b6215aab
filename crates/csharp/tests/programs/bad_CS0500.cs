using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

abstract class A { public abstract void F() { } } class P { static void Main() { } }
