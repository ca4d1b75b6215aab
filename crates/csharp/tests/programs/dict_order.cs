using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P
{
    static void Main()
    {
        var d = new Dictionary<string, int>(); foreach (string s in "one two three four five six seven eight nine ten".Split(' ')) d[s] = s.Length; foreach (var p in d) Console.Write(p.Key + " "); Console.WriteLine(); d.Remove("three"); d.Remove("one"); d["x"] = 1; d["y"] = 2; d["z"] = 3; foreach (var k in d.Keys) Console.Write(k + " "); Console.WriteLine(); d.Clear(); d["a"] = 1; Console.WriteLine(d.Count); var h = new HashSet<int> { 5, 3, 9, 1 }; h.Remove(3); h.Add(7); h.Add(8); Console.WriteLine(string.Join(",", h)); for (int i = 0; i < 20; i++) h.Add(i * 7 % 13); Console.WriteLine(string.Join(",", h)); var sd = new SortedDictionary<string, int> { { "b", 2 }, { "a", 1 }, { "C", 3 } }; foreach (var p in sd) Console.Write(p + " "); Console.WriteLine(); var sl = new SortedList<int, string> { { 3, "c" }, { 1, "a" } }; Console.WriteLine(sl.Keys[0] + sl.Values[1] + sl.IndexOfKey(3)); var ss = new SortedSet<int> { 5, 1, 3 }; Console.WriteLine(string.Join(",", ss) + ss.Min + ss.Max); int v; Console.WriteLine(d.TryGetValue("a", out v) + " " + v + d.TryGetValue("q", out v) + v + d.ContainsKey("a") + d.ContainsValue(1)); try { d.Add("a", 2); } catch (ArgumentException e) { Console.WriteLine(e.Message); } try { foreach (var p in d) d["n"] = 1; } catch (InvalidOperationException) { Console.WriteLine("changed"); } var ci = new Dictionary<string, int>(StringComparer.OrdinalIgnoreCase) { ["Key"] = 1 }; ci["KEY"]++; Console.WriteLine(ci["key"] + " " + ci.Count); var tup = new Dictionary<Tuple<int, int>, string> { { Tuple.Create(1, 2), "t" } }; Console.WriteLine(tup[Tuple.Create(1, 2)]); var ll = new LinkedList<int>(new[] { 1, 2, 3 }); ll.AddFirst(0); ll.AddAfter(ll.Find(2), 25); ll.Remove(1); ll.RemoveLast(); Console.WriteLine(string.Join(",", ll) + ll.First.Value + ll.Last.Value + ll.First.Next.Value); var q = new Queue<int>(new[] { 1, 2 }); q.Enqueue(3); Console.WriteLine(q.Dequeue() + q.Peek() + q.Count); var st = new Stack<int>(new[] { 1, 2 }); st.Push(3); Console.WriteLine(string.Join(",", st) + st.Pop() + st.Peek());
    }
}
