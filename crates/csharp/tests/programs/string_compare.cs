using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class Program
{
    static void Main()
    {
        string[] w = { "a", "A", "b", "B", "aa", "ab", "Ab", "AB", "", "a b", "a-b", "a_b", "1", "10", "2", "é", "e", "f", "z", "Z", "~", "!" }; foreach (var x in w) { foreach (var y in w) Console.Write(Math.Sign(string.Compare(x, y)) + " "); Console.WriteLine(); } foreach (var x in w) { foreach (var y in w) Console.Write(Math.Sign(string.CompareOrdinal(x, y)) + " "); Console.WriteLine(); } Console.WriteLine(string.Equals("a", "A", StringComparison.OrdinalIgnoreCase) + " " + string.Compare("a", "A", true));
    }
}
