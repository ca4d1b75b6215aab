using System;
using System.Collections.Generic;

delegate int Step(int x);
delegate void Change(ref int x);

class Counter
{
    public int Count;
    public string Name;
    public Counter(string name) { Name = name; }
    public void Hit() { Count++; Console.WriteLine(Name + " " + Count); }
    public static void Shared() { Console.WriteLine("shared"); }
}

class Program
{
    static int Add(int x) { Console.WriteLine("add " + x); return x + 1; }
    static int Twice(int x) { Console.WriteLine("twice " + x); return x * 2; }
    static void Inc(ref int x) { x++; }
    static void Dbl(ref int x) { x *= 2; }

    static void Main()
    {
        Step s = Add;
        s += Twice;
        Console.WriteLine(s(5));
        s -= Add;
        Console.WriteLine(s(5));
        s -= Twice;
        Console.WriteLine(s == null);

        Change c = Inc;
        c += Dbl;
        c += Inc;
        int n = 3;
        c(ref n);
        Console.WriteLine(n);
        c -= Inc;
        n = 3;
        c(ref n);
        Console.WriteLine(n);

        var a = new Counter("a");
        var b = new Counter("b");
        Action all = null;
        all += a.Hit;
        all += b.Hit;
        all += Counter.Shared;
        all += a.Hit;
        all();
        all -= a.Hit;
        all();
        Console.WriteLine("--");
        all -= b.Hit;
        all();
        Action x = a.Hit, y = a.Hit, z = b.Hit;
        Console.WriteLine((x == y) + " " + (x == z) + " " + x.Equals(y) + " " + (x != z));
        Console.WriteLine((x + z == y + z) + " " + (x + z == z + x));
        Action pair = x + z;
        Action rest = x + z + x + z + Counter.Shared - pair;
        Console.WriteLine(rest.GetInvocationList().Length);
        rest();
        Console.WriteLine(x - z == x);

        var list = new List<Action>();
        Action loop = null;
        for (int i = 0; i < 3; i++)
        {
            int k = i;
            loop += () => Console.WriteLine("loop " + k);
            list.Add(loop);
        }
        foreach (var l in list) { l(); Console.WriteLine("."); }
        Func<int> last = () => 1;
        last += () => 2;
        last += () => 3;
        Console.WriteLine(last());
        Action failing = () => Console.WriteLine("one");
        failing += () => { throw new InvalidOperationException("two"); };
        failing += () => Console.WriteLine("three");
        try { failing(); } catch (InvalidOperationException e) { Console.WriteLine(e.Message); }
        Action none = null;
        none?.Invoke();
        none -= a.Hit;
        Console.WriteLine(none == null);
    }
}
