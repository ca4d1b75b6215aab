using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class A { public static int X = Trace("A.X", 1); public static int Y = 11; static A() { Console.WriteLine("A()"); } public static int Trace(string s, int v) { Console.WriteLine(s); return v; } }
class B { public int F = A.Trace("B.F", 2); public B() { Console.WriteLine("B()"); } }
class C : B { int g = A.Trace("C.g", 3); public C() : this(5) { Console.WriteLine("C()"); } C(int q) { Console.WriteLine("C(int)"); } }
class G<T> { public static int Count; public static string Name = typeof(T).Name; public G() { Count++; } }
class Order { public static int P = Q + 1; public static int Q = 5; public const int K = L * 2; public const int L = 21; public static readonly DateTime D = new DateTime(2000, 1, 1); }
abstract class V { protected V() { Init(); } protected abstract void Init(); } class W : V { string s = "set"; protected override void Init() { Console.WriteLine(s); s = "init"; } public string S { get { return s; } } }
class P { static int m = A.Trace("P.m", 0); static void Main() { Console.WriteLine("main"); Console.WriteLine(A.Y); new C(); new G<int>(); new G<int>(); new G<string>(); Console.WriteLine(G<int>.Count + " " + G<string>.Count + " " + G<int>.Name + G<string>.Name + G<double>.Name); Console.WriteLine(Order.P + " " + Order.Q + " " + Order.K + " " + Order.D.Year); Console.WriteLine(new W().S); } }
