using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P
{
    static void Main()
    {
        var l = new LinkedList<string>(); var n = l.AddLast("b"); l.AddFirst("a"); l.AddAfter(n, "c"); l.AddBefore(n, "ab"); foreach (var s in l) Console.Write(s + " "); Console.WriteLine(l.Count + l.First.Value + l.Last.Value + n.Previous.Value + n.Next.Value); l.Remove(n); Console.WriteLine(l.Contains("b") + " " + l.Find("c").Previous.Value); for (var x = l.Last; x != null; x = x.Previous) Console.Write(x.Value); Console.WriteLine(); l.RemoveFirst(); l.Clear(); Console.WriteLine(l.Count + (l.First == null ? "n" : "x")); var q = new Queue<int>(); for (int i = 0; i < 5; i++) q.Enqueue(i); q.Dequeue(); q.Enqueue(9); Console.WriteLine(string.Join(",", q) + q.Contains(9) + q.ToArray().Length); try { new Queue<int>().Dequeue(); } catch (InvalidOperationException e) { Console.WriteLine(e.Message); } var st = new Stack<char>("abc"); Console.WriteLine(string.Join(",", st) + st.Pop() + st.Peek() + st.Count + string.Concat(st.ToArray())); try { new Stack<int>().Peek(); } catch (InvalidOperationException e) { Console.WriteLine(e.Message); } var h = new HashSet<string>(StringComparer.OrdinalIgnoreCase) { "a", "A", "b" }; Console.WriteLine(h.Count + " " + h.Contains("B")); var h2 = new HashSet<int> { 1, 2, 3 }; h2.UnionWith(new[] { 3, 4 }); h2.IntersectWith(new[] { 2, 3, 4, 5 }); h2.ExceptWith(new[] { 3 }); Console.WriteLine(string.Join(",", h2) + h2.IsSubsetOf(new[] { 2, 4, 6 }) + h2.Overlaps(new[] { 4 }) + h2.SetEquals(new[] { 4, 2 })); h2.SymmetricExceptWith(new[] { 2, 7 }); Console.WriteLine(string.Join(",", h2.OrderBy(z => z)) + h2.RemoveWhere(z => z > 5)); var ss = new SortedSet<string> { "b", "a", "c" }; Console.WriteLine(string.Join("", ss) + ss.Min + string.Join("", ss.Reverse()) + string.Join("", ss.GetViewBetween("a", "b"))); var sl = new SortedList<string, int> { { "z", 1 }, { "y", 2 } }; foreach (var kv in sl) Console.Write(kv.Key + kv.Value); Console.WriteLine(sl.IndexOfKey("z") + sl.ContainsKey("q").ToString());
    }
}
