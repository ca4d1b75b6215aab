using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class A { public A(int x) { } }

static class Program
{
    static void Main()
    {
        new A();
    }
}
