using System;
using System.Collections.Generic;

struct V
{
    public double X; public double Y;
    public V(double x, double y) { X = x; Y = y; }
    public V(V o) { X = o.Y; Y = o.X; }
    public double Length { get { return Math.Sqrt(X * X + Y * Y); } }
    public V Me { get { return this; } }
    public double this[int i] { get { return i == 0 ? X : Y; } set { if (i == 0) X = value; else Y = value; } }
    public static V operator +(V a, V b) { return new V(a.X + b.X, a.Y + b.Y); }
    public static V operator *(V a, double k) { return new V(a.X * k, a.Y * k); }
    public static V Second(V a, V b) { return b; }
    public static V Pick(bool first, V a, V b) { return first ? a : b; }
    public V Turned() { return new V(-Y, X); }
    public double Grow() { X += 1; return X; }
    public override string ToString() { return X + ";" + Y; }
}

struct Pair { public V A; public V B; public Pair(V a, V b) { B = b; A = a; } public V Sum { get { return A + B; } } }

class Node
{
    public V At { get; set; }
    public int Id { get; private set; }
    public Node Next;
    public Node(int id) { Id = id; }
    public int NextId { get { return Next.Id; } }
    public virtual int Twice() { return Id * 2; }
    public int Four() { return Twice() + Twice(); }
}

class More : Node
{
    public More(int id) : base(id) { }
    public override int Twice() { return Id * 20; }
}

class P
{
    static int made = 0;
    static int Made() { made++; return made; }
    static int Div(int a, int b) { return a / b; }
    static int Even(int n) { return n == 0 ? 1 : Odd(n - 1); }
    static int Odd(int n) { return n == 0 ? 0 : Even(n - 1); }
    static T Same<T>(T x) { return x; }
    static int Sub(int a, int b) { return a - b; }

    static void Main()
    {
        var v = new V(3, 4);
        Console.WriteLine(v.Length + " " + (v + v * 2) + " " + v[0] + " " + v[1]);
        v = v.Turned();
        Console.WriteLine(v);
        v = new V(v);
        Console.WriteLine(v);
        V w = V.Second(v, v);
        w.X = 100;
        Console.WriteLine(v + " | " + w);
        w = V.Pick(true, v, w);
        w.Y = 200;
        Console.WriteLine(v + " | " + w);
        V me = v.Me;
        me.X = 5;
        Console.WriteLine(v + " | " + me);
        // What is changed between two arguments.
        Console.WriteLine(V.Pick(true, v, new V(v.Grow(), 0)) + " after " + v);
        Console.WriteLine(Sub(Made(), Made()) + " " + made);
        int i = 1;
        Console.WriteLine(Sub(i, i = 7) + " " + Sub(i++, i++) + " " + i);

        var list = new List<V> { new V(1, 2), new V(3, 4) };
        V item = list[0];
        item.X = 50;
        Console.WriteLine(list[0].X + " " + list[1].Length + " " + (list[0] + list[1]) + " " + list[0].Turned());
        list[1] = item;
        item.Y = 60;
        Console.WriteLine(list[1]);
        var array = new V[2];
        array[1].X = 9;
        Console.WriteLine(array[1] + array[1] * 2);

        var pair = new Pair(v, w);
        v.X = -1;
        Console.WriteLine(pair.A + " " + pair.B + " " + pair.Sum);
        pair.A.X = 77;
        Console.WriteLine(pair.A + " " + pair.Sum);

        var node = new Node(4) { At = new V(1, 1) };
        V at = node.At;
        at.X = 8;
        Console.WriteLine(node.At + " " + at + " " + node.Four() + " " + new More(4).Four());
        try { Console.WriteLine(node.NextId); } catch (NullReferenceException) { Console.WriteLine("null"); }
        try { Console.WriteLine(Div(1, made - made)); } catch (DivideByZeroException) { Console.WriteLine("zero"); }
        try { Console.WriteLine(list[2].X); } catch (ArgumentOutOfRangeException) { Console.WriteLine("range"); }
        try { list[-1] = v; } catch (ArgumentOutOfRangeException) { Console.WriteLine("range"); }
        try { Console.WriteLine("abc"[3]); } catch (IndexOutOfRangeException) { Console.WriteLine("range"); }
        List<int> none = null;
        try { Console.WriteLine(none.Count); } catch (NullReferenceException) { Console.WriteLine("null"); }
        try { none.Add(1); } catch (NullReferenceException) { Console.WriteLine("null"); }
        Console.WriteLine(Even(10) + " " + Odd(7) + " " + Even(7));
        Console.WriteLine(Same(3) + Same("x") + Same(v));
        Func<V, double> f = q => q.Length + v.X;
        Console.WriteLine(f(new V(6, 8)));
        IList<V> seen = list;
        Console.WriteLine(seen[0].X + " " + seen.Count);
        var changed = new List<int> { 1, 2, 3 };
        try { foreach (int x in changed) changed[0] = x; } catch (InvalidOperationException) { Console.WriteLine("modified"); }
        try { foreach (int x in changed) changed.Add(x); } catch (InvalidOperationException) { Console.WriteLine("modified"); }
        Console.WriteLine(changed.Count);
    }
}
