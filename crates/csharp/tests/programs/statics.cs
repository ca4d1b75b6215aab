using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class S { public static int A = Init("A", 1); public static readonly int B = A + 1; public const int K = 10 * 2; static int Init(string n, int v) { Console.WriteLine("init " + n); return v; } static S() { Console.WriteLine("cctor"); } public static int Next() { return A++; } }
class Inst { int a = 5; int b; public static int Total; public Inst() { b = a * 2; Total += b; } public int B { get { return b; } } public int Auto { get; private set; } = 3; public void Up() { Auto++; } static int id = 100; public readonly int Id = id++; }

static class Program
{
    static void Main()
    {
        Console.WriteLine("start"); Console.WriteLine(S.K); Console.WriteLine(S.Next() + S.Next() + " " + S.B); var i = new Inst(); i.Up(); Console.WriteLine(i.B + " " + i.Auto + " " + Inst.Total + " " + i.Id + " " + new Inst().Id);
    }
}
