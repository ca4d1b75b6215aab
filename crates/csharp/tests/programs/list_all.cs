using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P
{
    static void Main()
    {
        var l = new List<int> { 3, 1, 2 }; l.Add(5); l.AddRange(new[] { 4, 4 }); l.Insert(1, 9); l.InsertRange(0, new[] { 7, 7 }); Console.WriteLine(string.Join(",", l) + " " + l.Count + " " + l.IndexOf(4) + l.LastIndexOf(4) + l.Contains(9) + l.IndexOf(100)); l.Remove(7); l.RemoveAt(0); l.RemoveRange(1, 2); Console.WriteLine(string.Join(",", l)); l.Sort(); Console.WriteLine(string.Join(",", l) + l.BinarySearch(4) + " " + l.BinarySearch(100)); l.Reverse(); Console.WriteLine(string.Join(",", l)); l.Sort((a, b) => b.CompareTo(a)); Console.WriteLine(string.Join(",", l.GetRange(1, 2)) + l.Find(x => x < 4) + l.FindIndex(x => x == 2) + string.Join("/", l.FindAll(x => x % 2 == 0)) + l.Exists(x => x == 2) + l.TrueForAll(x => x > 0) + l.FindLast(x => x > 2)); l.Capacity = 100; l.TrimExcess(); Console.WriteLine(l.ToArray().Length + string.Join(",", l.ConvertAll(x => "n" + x))); var copy = new List<int>(l); copy[0] = -1; Console.WriteLine(l[0]); int[] target = new int[10]; l.CopyTo(target, 2); Console.WriteLine(string.Join(",", target)); l.RemoveAll(x => x == 4); Console.WriteLine(l.Count); l.Clear(); Console.WriteLine(l.Count); try { l.RemoveAt(0); } catch (ArgumentOutOfRangeException) { Console.WriteLine("oor"); } try { foreach (int x in copy) copy.Add(1); } catch (InvalidOperationException e) { Console.WriteLine(e.Message); } IList<int> il = copy; il.Add(8); IEnumerable<int> en = il; Console.WriteLine(en.Last() + " " + il.IsReadOnly); var ro = copy.AsReadOnly(); Console.WriteLine(ro.Count); var nested = new List<List<int>> { new List<int> { 1 }, new List<int>() }; nested[1].Add(5); Console.WriteLine(nested[1][0] + nested.Sum(x => x.Count)); var words = new List<string> { "bb", "a", "ccc" }; words.Sort((x, y) => x.Length - y.Length); Console.WriteLine(string.Join(",", words)); words.Sort(StringComparer.Ordinal); Console.WriteLine(string.Join(",", words)); object o = words; Console.WriteLine(o is IEnumerable<string>); Console.WriteLine(o is System.Collections.IList); Console.WriteLine(words.GetType() == typeof(List<string>)); words.ForEach(Console.WriteLine);
    }
}
