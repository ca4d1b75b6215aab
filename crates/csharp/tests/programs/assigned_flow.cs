using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

struct S { public int A, B; public override string ToString() { return A + "/" + B; } }
class P {
 static bool Get(out int v) { v = 5; return true; }
 static int F(int n) { int r; if (n > 0) r = 1; else if (n < 0) r = -1; else return 0; return r; }
 static int G(int n) { int r; switch (n) { case 1: r = 10; break; case 2: r = 20; break; default: throw new ArgumentException(); } return r; }
 static int H(int n) { int r; while (true) { if (n > 10) { r = n; break; } n++; } return r; }
 static int I() { int r; try { r = 1; } finally { Console.WriteLine("f"); } return r; }
 static int J() { int r; try { Console.WriteLine("t"); } finally { r = 2; } return r; }
 static int K(bool a) { int v; return a && Get(out v) ? v : -1; }
 static int L(bool a) { int v; if (!a || !Get(out v)) return -1; return v; }
 static int M() { int v; do { v = 3; } while (v < 3); return v; }
 static int N() { int v; if (true) v = 1; return v; }
 static int O() { int v; for (;;) { v = 9; break; } return v; }
 static void Q(out int a, out string b) { a = 1; b = "x"; }
 static int R(bool c) { int x; bool ok = c ? Get(out x) : Get(out x); return x; }
 static int T() { int v; try { v = 1; } catch (Exception) { return 0; } return v; }
 static int U() { int a, b = 2, c; a = c = b; return a + c; }
 static int V(object o) { int n; if (o is int) n = (int)o; else n = 0; return n; }
 static int W() { int v; { v = 4; } goto end; end: return v; }
 static void Main() { Console.WriteLine(F(1) + F(-1) + F(0) + G(2) + H(3) + I() + J() + K(true) + K(false) + L(true) + M() + N() + O()); S s; s.A = 1; s.B = 2; Console.WriteLine(s); S t = s; Console.WriteLine(t.A); int x; string y; Q(out x, out y); Console.WriteLine(x + y); int z; Action f = () => { z = 5; Console.WriteLine(z); }; f(); int w; Func<int> g = () => { int q; q = 1; return q; }; w = g(); Console.WriteLine(w + R(true) + T() + U() + V(3) + W()); int[] arr; arr = new int[2]; arr[0]++; Console.WriteLine(arr[0]); int lastly; foreach (int i in arr) { lastly = i; Console.Write(lastly); } Console.WriteLine(); }
}
