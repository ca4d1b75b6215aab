using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class Program
{
    static void Main()
    {
        var h = new HashSet<int> { 3, 1, 3 }; Console.WriteLine(h.Count + " " + h.Add(1) + " " + h.Add(7) + " " + h.Contains(3)); h.UnionWith(new[] { 9, 10 }); h.Remove(1); Console.WriteLine(string.Join(",", h)); h.IntersectWith(new[] { 3, 9, 11 }); Console.WriteLine(string.Join(",", h.OrderBy(x => x)));
        var q = new Queue<string>(); q.Enqueue("a"); q.Enqueue("b"); q.Enqueue("c"); Console.WriteLine(q.Dequeue() + q.Peek() + q.Count); foreach (var x in q) Console.Write(x); Console.WriteLine(); var s = new Stack<int>(); s.Push(1); s.Push(2); s.Push(3); Console.WriteLine(s.Pop() + " " + s.Peek() + " " + string.Join(",", s)); try { new Stack<int>().Pop(); } catch (InvalidOperationException e) { Console.WriteLine(e.Message); } var sd = new SortedDictionary<string, int> { { "b", 2 }, { "a", 1 }, { "C", 3 } }; foreach (var p in sd) Console.Write(p.Key + p.Value + " "); Console.WriteLine(); var ll = new LinkedList<int>(); ll.AddLast(2); ll.AddFirst(1); ll.AddLast(3); ll.Remove(2); foreach (var x in ll) Console.Write(x + " "); Console.WriteLine(ll.First.Value + " " + ll.Last.Value + " " + ll.Count);
    }
}
