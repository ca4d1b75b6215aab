using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class C { public static List<Func<int, int>> Make() { var l = new List<Func<int, int>>(); for (int i = 0; i < 3; i++) { int a = i; for (int j = 0; j < 2; j++) { int b = j * 10; l.Add(x => { a++; return a + b + x; }); } } return l; } public static Action<string> Logger(List<string> sink, string pre) { int n = 0; return s => sink.Add(pre + n++ + s); } public static Func<T, R> Compose<T, M, R>(Func<T, M> f, Func<M, R> g) { return x => g(f(x)); } }
class Acc { int total; public Action<int> Adder() { return x => { total += x; Action again = () => total++; again(); }; } public int Total { get { return total; } } }

static class Program
{
    static void Main()
    {
        foreach (var f in C.Make()) Console.Write(f(1) + " "); Console.WriteLine(); var sink = new List<string>(); var log = C.Logger(sink, "p"); log("a"); log("b"); Console.WriteLine(string.Join(",", sink)); Console.WriteLine(C.Compose((int x) => x * 2.5, y => "r" + y)(3)); var acc = new Acc(); var add = acc.Adder(); add(5); add(6); Console.WriteLine(acc.Total); Func<int> g = null; { int k = 5; g = () => k++; } Console.WriteLine(g() + g());
    }
}
