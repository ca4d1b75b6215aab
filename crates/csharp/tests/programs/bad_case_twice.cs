using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class Program
{
    static void Main()
    {
        int n = 1; switch (n) { case 1: break; case 1: break; }
    }
}
