using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class Program
{
    static void Main()
    {
        string s = "Hello, World";
        Console.WriteLine(s.Length + " " + s[4] + " " + s.ToUpper() + " " + s.ToLower() + " " + s.Substring(7) + " " + s.Substring(0, 5));
        Console.WriteLine(s.IndexOf("o") + " " + s.IndexOf('o', 5) + " " + s.LastIndexOf("o") + " " + s.IndexOf("zz") + " " + s.Contains("World") + " " + s.StartsWith("He") + " " + s.EndsWith("ld"));
        Console.WriteLine(s.Replace("l", "L") + " " + s.Replace('o', '0') + " " + s.Remove(5) + " " + s.Remove(0, 7) + " " + s.Insert(5, "!"));
        Console.WriteLine("[" + "  x ".Trim() + "][" + "  x ".TrimStart() + "][" + "  x ".TrimEnd() + "][" + "xxaxx".Trim('x') + "]");
        Console.WriteLine("7".PadLeft(3, '0') + "|" + "7".PadRight(3) + "|" + string.IsNullOrEmpty("") + string.IsNullOrWhiteSpace(" "));
        foreach (string p in "a,b,,c".Split(',')) Console.Write("<" + p + ">"); Console.WriteLine();
        foreach (string p in "a, b;c".Split(new[] { ',', ';', ' ' }, StringSplitOptions.RemoveEmptyEntries)) Console.Write("<" + p + ">"); Console.WriteLine();
        foreach (string p in " a  b ".Split()) Console.Write("<" + p + ">"); Console.WriteLine();
        Console.WriteLine(string.Join("-", new[] { 1, 2, 3 }) + string.Join("", "a", "b") + string.Concat("x", 1, 'c') + new string('z', 3));
        char[] cs = s.ToCharArray(); Array.Reverse(cs); Console.WriteLine(new string(cs)); Console.WriteLine("abc".CompareTo("abd") < 0); Console.WriteLine(string.Compare("a", "B") < 0); Console.WriteLine("a" == "A".ToLower()); Console.WriteLine("tab\tq\"\\ \u0041");
    }
}
