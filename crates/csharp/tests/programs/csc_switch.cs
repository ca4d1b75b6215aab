using System;
using System.Collections.Generic;

class Point
{
    public int X, Y;
    public void Deconstruct(out int x, out int y) { x = X; y = Y; }
}

static class Program
{
    static string Kind(object o)
    {
        switch (o)
        {
            case int n when n < 0: return "negative";
            case int n: return "int " + n;
            case string s: return "text " + s.Length;
            case null: return "null";
            case Point { X: 0 } p: return "on axis " + p.Y;
            default: return o.GetType().Name;
        }
    }

    static void Main()
    {
        foreach (object o in new object[] { -3, 4, "abc", null, new Point { Y = 9 }, new Point { X = 1 }, 2.5 })
            Console.WriteLine(Kind(o));
        for (int i = 0; i < 4; i++)
            Console.Write(i switch { 0 => "zero", 1 or 2 => "few", _ when i > 2 => "many", _ => "none" } + " ");
        Console.WriteLine();
        var (x, y) = new Point { X = 5, Y = 6 };
        Console.WriteLine(x + y);
        var list = new List<(int k, string v)> { (1, "a"), (2, "b") };
        foreach (var (k, v) in list) Console.Write(k + v + " ");
        Console.WriteLine(new Point() is var q && q.X == 0);
        int[] data = null;
        data ??= new[] { 7 };
        Console.WriteLine(data[0] is > 5 and < 10);
        using var done = new Done();
        Console.WriteLine("before");
    }

    class Done : IDisposable { public void Dispose() { Console.WriteLine("disposed"); } }
}
