// Type arguments that meet their constraints: nothing of this is refused.
using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
interface IShape { double Area { get; } }
class Square : IShape, IComparable<Square> { public double Side; public Square() { Side = 2; } public double Area { get { return Side * Side; } } public int CompareTo(Square o) { return Side.CompareTo(o.Side); } }
struct Dot : IShape, IEquatable<Dot> { public double Area { get { return 0; } } public bool Equals(Dot o) { return true; } }
abstract class Node<T> where T : Node<T> { public T Next; }
class Leaf : Node<Leaf> { }
class Refs<T> where T : class { public T Value; }
class Values<T> where T : struct { public T? Maybe; }
class Makes<T> where T : new() { public T Make() { return new T(); } }
class Sorted<T> where T : IComparable<T> { public static T Max(T a, T b) { return a.CompareTo(b) > 0 ? a : b; } }
class Both<T, U> where T : U where U : IShape { public U Up(T t) { return t; } }
class Derived<T> : Refs<T> where T : class, IShape, new() { public Derived() { Value = new T(); } }
class Holder<K, V> where K : IEquatable<K> where V : IEnumerable { public Dictionary<K, V> All = new Dictionary<K, V>(); }
enum Colour { Red, Green }
delegate int Fold(int a, int b);
class P
{
    static T Pick<T>(T a, T b) where T : IComparable { return a.CompareTo(b) >= 0 ? a : b; }
    static T Null<T>() where T : class { return null; }
    static T? None<T>() where T : struct { return null; }
    static T New<T>() where T : class, new() { return new T(); }
    static double Sum<T>(IEnumerable<T> list) where T : IShape { return list.Sum(x => x.Area); }
    static void Through<T>(T x) where T : class, IShape, new() { Console.Write(new Derived<T>().Value.Area + " " + new Refs<T> { Value = x }.Value.Area + " "); }
    static U Cast<T, U>(T x) where T : U { return x; }
    static void Main()
    {
        Console.WriteLine(new Refs<string> { Value = "a" }.Value + new Refs<int[]>().Value + new Refs<Fold>().Value + new Refs<object>().Value + new Refs<IShape>().Value + new Refs<List<int>>().Value);
        Console.WriteLine(new Values<int>().Maybe == null && new Values<Dot>().Maybe == null && new Values<Colour>().Maybe == null && new Values<decimal>().Maybe == null && new Values<(int, int)>().Maybe == null && new Values<KeyValuePair<int, string>>().Maybe == null);
        Console.WriteLine(new Makes<Square>().Make().Area + " " + new Makes<int>().Make() + " " + new Makes<List<int>>().Make().Count + " " + new Makes<Dot>().Make().Area + " " + (new Makes<object>().Make() != null) + " " + new Makes<Colour>().Make());
        Console.WriteLine(Sorted<int>.Max(1, 2) + " " + Sorted<string>.Max("a", "b") + " " + Sorted<decimal>.Max(1, 2) + " " + Sorted<Square>.Max(new Square(), new Square { Side = 3 }).Side + " " + Sorted<DateTime>.Max(new DateTime(2000, 1, 1), new DateTime(2001, 1, 1)).Year + " " + Sorted<double>.Max(1, 2) + " " + Sorted<char>.Max('a', 'b') + " " + Sorted<bool>.Max(true, false));
        Console.WriteLine(new Both<Square, IShape>().Up(new Square()).Area + " " + new Both<Dot, Dot>().Up(new Dot()).Area);
        var leaf = new Leaf { Next = new Leaf() }; Console.WriteLine(leaf.Next.Next == null);
        var h = new Holder<string, List<int>>(); h.All["a"] = new List<int> { 1 }; var g = new Holder<int, int[]>(); Console.WriteLine(h.All["a"][0] + g.All.Count + new Holder<Guid, string>().All.Count);
        Console.WriteLine(Pick(1, 2) + Pick("a", "b") + Pick(Colour.Red, Colour.Green) + Pick(1.5, 2.5));
        Console.WriteLine((Null<string>() == null) + " " + (None<int>() == null) + " " + New<Square>().Area + " " + Sum(new[] { new Square(), new Square() }) + " " + Sum(new List<IShape> { new Dot(), new Square() }) + " " + Cast<string, object>("x") + Cast<int, int>(3));
        Through(new Square()); Console.WriteLine();
        int? n = 3; Nullable<double> d = null; Console.WriteLine(n + " " + d.HasValue);
    }
}
