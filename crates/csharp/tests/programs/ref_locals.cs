using System;
struct V { public int X; }
class A { int[] a = {1,2,3}; public ref int this[int i] => ref a[i]; public ref int At(int i) { return ref a[i]; } public ref int First { get { return ref a[0]; } } }
class P {
 static int s = 5; static V v;
 static ref int S() => ref s;
 static ref int Max(ref int a, ref int b) { if (a > b) return ref a; return ref b; }
 static ref T Find<T>(T[] a, Func<T,bool> f) { for (int i=0;i<a.Length;i++) if (f(a[i])) return ref a[i]; throw new Exception("none"); }
 static void Main() {
  int x = 1, y = 2; ref int r = ref x; r = 10; Console.WriteLine(x); r++; Console.WriteLine(x);
  Max(ref x, ref y) = 77; Console.WriteLine(x + " " + y);
  ref int m = ref Max(ref x, ref y); m += 5; Console.WriteLine(x);
  int[] a = {1,2,3}; ref int e = ref a[1]; e *= 10; Console.WriteLine(a[1]);
  Find(a, q => q == 20)++; Console.WriteLine(a[1]);
  S() = 9; Console.WriteLine(s); int copy = S(); S()++; Console.WriteLine(copy + " " + s);
  var o = new A(); o[2] = 30; o.At(0)--; o.First += 100; Console.WriteLine(o[0] + " " + o[1] + " " + o[2]);
  ref V w = ref v; w.X = 4; Console.WriteLine(v.X); V[] vs = new V[2]; ref V q1 = ref vs[1]; q1.X = 8; q1 = new V { X = 3 }; Console.WriteLine(vs[1].X); V c = q1; c.X = 99; Console.WriteLine(vs[1].X);
  ref var z = ref vs[0].X; z = 6; Console.WriteLine(vs[0].X);
  
  ref readonly int ro = ref a[2]; Console.WriteLine(ro);
 }
}
