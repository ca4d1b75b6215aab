using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class Program
{
    static void Main()
    {
        var names = new[] { "x", "y" }; int[] keys = { 2, 1 }; Array.Sort(keys, names); Console.WriteLine(string.Join("", names)); Console.WriteLine(Environment.NewLine.Length);
    }
}
