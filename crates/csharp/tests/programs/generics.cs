using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class Pair<A, B> { public A First; public B Second; public Pair(A a, B b) { First = a; Second = b; } public Pair<B, A> Flip() { return new Pair<B, A>(Second, First); } public override string ToString() { return First + "/" + Second; } }
class Stack2<T> where T : IComparable<T> { List<T> items = new List<T>(); public static int Made; public Stack2() { Made++; } public void Push(T x) { items.Add(x); } public T Max() { T m = items[0]; foreach (T x in items) if (x.CompareTo(m) > 0) m = x; return m; } public T this[int i] { get { return items[i]; } set { items[i] = value; } } }
static class G { public static T Max<T>(T a, T b) where T : IComparable<T> { return a.CompareTo(b) > 0 ? a : b; } public static T Make<T>() where T : new() { return new T(); } public static List<R> Map<T, R>(IEnumerable<T> s, Func<T, R> f) { var l = new List<R>(); foreach (var x in s) l.Add(f(x)); return l; } public static string Kind<T>(T x) { return typeof(T).Name + " " + (default(T) == null) + " " + (x is int); } }

static class Program
{
    static void Main()
    {
        Console.WriteLine(new Pair<int, string>(1, "a").Flip()); Console.WriteLine(G.Max(3, 7) + " " + G.Max("a", "b") + " " + G.Max(2.5, 1.5)); var s = new Stack2<int>(); s.Push(3); s.Push(9); s[0] = 4; Console.WriteLine(s.Max() + " " + s[0]); new Stack2<string>(); new Stack2<int>(); Console.WriteLine(Stack2<int>.Made + " " + Stack2<string>.Made); Console.WriteLine(G.Make<List<int>>().Count + " " + G.Make<int>()); Console.WriteLine(string.Join(",", G.Map(new[] { 1, 2 }, x => x + 0.5))); Console.WriteLine(G.Kind(1) + " " + G.Kind("s") + " " + G.Kind<object>(5));
    }
}
