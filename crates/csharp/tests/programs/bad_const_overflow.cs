using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class Program
{
    static void Main()
    {
        byte b = 256; Console.WriteLine(b);
    }
}
