using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class N { public N Next; public int V; public string S() { return "s" + V; } public int[] Arr; }

static class Program
{
    static void Main()
    {
        N a = new N { V = 1, Next = new N { V = 2, Arr = new[] { 5 } } }; Console.WriteLine(a?.Next?.V + " " + a?.Next?.Next?.V + " " + (a?.Next?.Next == null) + " " + a.Next?.S() + " " + a.Next.Next?.S() + "|" + a.Next?.Arr?[0] + "|" + a.Arr?[0] + "|" + (a.Next?.Next?.S() ?? "none")); Action f = null; f?.Invoke(); f = () => Console.WriteLine("called"); f?.Invoke(); List<int> l = null; Console.WriteLine(l?.Count > 0); Console.WriteLine(l?.Count == null);
    }
}
