using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

interface I { void F(); } class C : I { }

static class Program
{
    static void Main()
    {
        new C();
    }
}
