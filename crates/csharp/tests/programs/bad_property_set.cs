using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class A { public int Y { get { return 1; } } }

static class Program
{
    static void Main()
    {
        new A().Y = 3;
    }
}
