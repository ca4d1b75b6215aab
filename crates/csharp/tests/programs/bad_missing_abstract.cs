using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

abstract class A { public abstract void F(); } class B : A { }

static class Program
{
    static void Main()
    {
        new B().F();
    }
}
