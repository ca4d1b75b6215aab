using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class Node<T> { public T Value; public Node<T> Next; } class Chain<T> { Node<T> head; int n; public int Count { get { return n; } } public void Push(T v) { head = new Node<T> { Value = v, Next = head }; n++; } public IEnumerable<T> All() { for (var x = head; x != null; x = x.Next) yield return x.Value; } public void Reverse() { Node<T> r = null; while (head != null) { var t = head.Next; head.Next = r; r = head; head = t; } head = r; } }

static class Program
{
    static void Main()
    {
        var c = new Chain<string>(); foreach (var s in "a b c d".Split(' ')) c.Push(s); Console.WriteLine(string.Join(",", c.All()) + c.Count); c.Reverse(); Console.WriteLine(string.Join(",", c.All()));
    }
}
