using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class Program
{
    static void Main()
    {
        var l = new List<int> { 5, 3, 8 }; l.Add(1); l.Insert(0, 9); l.Remove(3); l.RemoveAt(1); Console.WriteLine(string.Join(",", l)); l.AddRange(new[] { 4, 4, 2 }); l.Sort(); Console.WriteLine(string.Join(",", l)); l.Reverse(); Console.WriteLine(l.IndexOf(4) + " " + l.LastIndexOf(4) + " " + l.Contains(8) + " " + l.Count);
        l.Sort((a, b) => b.CompareTo(a)); Console.WriteLine(string.Join(",", l)); Console.WriteLine(l.Find(x => x < 5) + " " + l.FindIndex(x => x == 4) + " " + l.FindAll(x => x % 2 == 0).Count + " " + l.Exists(x => x > 100) + " " + l.RemoveAll(x => x == 4) + " " + l.Count);
        Console.WriteLine(string.Join(",", l.GetRange(1, 2)) + " " + string.Join(",", l.ConvertAll(x => x * 1.5))); l.ForEach(x => Console.Write(x + ".")); Console.WriteLine(); try { Console.WriteLine(l[10]); } catch (ArgumentOutOfRangeException e) { Console.WriteLine("range"); }
        try { foreach (int x in l) l.Add(x); } catch (InvalidOperationException e) { Console.WriteLine(e.Message); } l.Clear(); Console.WriteLine(l.Count); var m = new List<int>(new[] { 1, 2 }); Console.WriteLine(m.Count); m[0]++; m[1] += 10; Console.WriteLine(m[0] + " " + m[1]); l.InsertRange(0, m); Console.WriteLine(l.Count); Console.WriteLine(string.Join("|", m.ToArray()));
    }
}
