using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class Program
{
    static void Main()
    {
        int n = 3; const int K = n; Console.WriteLine(K);
    }
}
