using System;
using System.Collections.Generic;
class P {
    static (int, string, double, bool, char) Five() { return (1, "b", 2.5, true, 'e'); }
    static void Main() {
        var f = Five(); Console.WriteLine(f + " " + f.Item5);
        var (a, b, c, d, e, g) = (1, 2, 3, 4, 5, 6); Console.WriteLine(a + b + c + d + e + g);
        (int x, int y, int z, int u, int v, int w, int t) s = (1, 2, 3, 4, 5, 6, 7); s.t = 70; Console.WriteLine(s + " " + s.u + " " + s.Item7);
        var l = Tuple.Create(1, "two", 3.0, 'f', true, 6L, "seven"); Console.WriteLine(l + " " + l.Item7 + " " + l.Equals(Tuple.Create(1, "two", 3.0, 'f', true, 6L, "seven")));
        var q = Tuple.Create(1, 2, 3, 4); var r = new Tuple<int, int, int, int, int>(1, 2, 3, 4, 5); Console.WriteLine(q + " " + r + " " + Tuple.Create(1, 2, 3, 4, 5, 6));
        Console.WriteLine((1, 2, 3, 4, 5).Equals((1, 2, 3, 4, 6)) + " " + (1, 2, 3, 4).CompareTo((1, 2, 3, 5)));
        var set = new HashSet<(int, int, int, int)>(); set.Add((1, 2, 3, 4)); set.Add((1, 2, 3, 4)); set.Add((4, 3, 2, 1)); Console.WriteLine(set.Count);
        var list = new List<(int, int, int, int, string)> { (2, 0, 0, 0, "b"), (1, 9, 0, 0, "a"), (1, 9, 0, 0, null) }; list.Sort(); foreach (var i in list) Console.WriteLine(i);
        var dict = new Dictionary<Tuple<int, int, int>, string>(); dict[Tuple.Create(1, 2, 3)] = "found"; Console.WriteLine(dict[Tuple.Create(1, 2, 3)]);
        var pairs = new List<Tuple<int, string>> { Tuple.Create(2, "x"), Tuple.Create(1, "y") }; pairs.Sort(); Console.WriteLine(pairs[0]);
        Func<int, int, int, int, int, int, int> six = (i, j, k, m, n, o) => i + j + k + m + n + o; Console.WriteLine(six(1, 2, 3, 4, 5, 6));
        Action<int, int, int, int, int, int> act = (i, j, k, m, n, o) => Console.WriteLine(i * o); act(2, 0, 0, 0, 0, 9);
        var vt = ValueTuple.Create(1, 2, 3, 4, 5, 6, 7); Console.WriteLine(vt.Item6);
    }
}
