using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

abstract class A { public abstract void F(); }

static class Program
{
    static void Main()
    {
        new A();
    }
}
