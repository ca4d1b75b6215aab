// Structs in fields, elements and variables that lambdas share, which an argument replaces before the method runs.
using System;
struct V { public double X, Y; public V(double x, double y) { X = x; Y = y; }
 public double Sum { get { return X + Y; } set { X = value - Y; } }
 public double this[double i] { get { return X + i; } set { X = value + i; } }
 public double AddD(double d) { X += d; return X; }
 public void Add(V v) { X += v.X; Y += v.Y; }
 public double Dot(V v) { return X * v.X + Y * v.Y; }
 public override string ToString() { return "(" + X + "; " + Y + ")"; } }
struct In { public V At; public int N; }
class H { public V At = new V(1, 2); public In Inner; public V[] Arr = { new V(1,1), new V(2,2) }; public static V S = new V(3,3); public V Auto { get; set; }
  public double Set() { At = new V(50, 60); Inner = new In(); Inner.At = new V(7,7); Arr[0] = new V(70, 80); S = new V(90, 91); return 1; }
  public double Own() { return At.AddD((At = new V(30, 30)).X) + At.Dot(At = new V(2, 1)); }
}
class P {
  static double Two(ref V a, double d) { a.X += d; return a.X; }
  static void Main() {
    H h = new H();
    Console.WriteLine(h.At.AddD((h.At = new V(10, 20)).X) + " " + h.At);
    h.At.Add(h.At = new V(5, 5)); Console.WriteLine(h.At);
    Console.WriteLine(h.At.Dot(h.At = new V(2, 3)) + " " + h.At);
    Console.WriteLine(h.At.AddD(h.Set()) + " " + h.At);
    h = new H(); Console.WriteLine(h.Arr[0].AddD(h.Set()) + " " + h.Arr[0]);
    h = new H(); int i = 0; Console.WriteLine(h.Arr[i].AddD((h.Arr[i++] = new V(4, 4)).Y + i) + " " + h.Arr[0] + h.Arr[1]);
    h = new H(); h.Arr[0].Add(h.Arr[0] = new V(5, 6)); Console.WriteLine(h.Arr[0]);
    h = new H(); Console.WriteLine(H.S.AddD(h.Set()) + " " + H.S);
    h = new H(); h.Inner.At.X = 3; Console.WriteLine(h.Inner.At.AddD(h.Set()) + " " + h.Inner.At);
    h = new H(); h.Inner.At.X = h.Set(); Console.WriteLine(h.Inner.At);
    h = new H(); h.At.X = (h.At = new V(8, 9)).Y; Console.WriteLine(h.At);
    h = new H(); h.At.X += (h.At = new V(8, 9)).Y; Console.WriteLine(h.At);
    h = new H(); h.Arr[1].Y = h.Arr[1].AddD((h.Arr[1] = new V(11, 12)).X); Console.WriteLine(h.Arr[1]);
    h = new H(); h.Arr[0].X = h.Set(); Console.WriteLine(h.Arr[0]);
    h = new H(); h.At.Sum = h.Set(); Console.WriteLine(h.At);
    h = new H(); h.At[h.Set()] = 5; Console.WriteLine(h.At);
    h = new H(); Console.WriteLine(h.At[h.Set()] + " " + h.At);
    h = new H(); h.At.Sum += h.Set(); Console.WriteLine(h.At);
    h = new H(); Console.WriteLine(Two(ref h.At, h.Set()) + " " + h.At);
    h = new H(); Console.WriteLine(Two(ref h.Inner.At, h.Set()) + " " + h.Inner.At);
    h = new H(); Console.WriteLine(h.Own() + " " + h.At);
    V a = new V(1, 1); Func<double> f = () => { a = new V(100, 100); return 1; };
    Console.WriteLine(a.AddD(f()) + " " + a);
    a = new V(1, 1); a.X = f(); Console.WriteLine(a);
    a = new V(1, 1); a.X += f(); Console.WriteLine(a);
    a = new V(1, 1); Console.WriteLine(a.Dot(new V(f(), 1)) + " " + a);
    a = new V(1, 1); Console.WriteLine(Two(ref a, f()) + " " + a);
    V[] arr = { new V(1, 2), new V(3, 4) };
    ref V r = ref arr[0]; 
    Console.WriteLine(r.AddD((arr[0] = new V(20, 20)).X) + " " + r);
    r.X = (arr[0] = new V(6, 6)).X + 1; Console.WriteLine(r);
    V[,] grid = new V[2, 2]; grid[0, 1].Add(grid[0, 1] = new V(3, 3)); Console.WriteLine(grid[0, 1]);
    In box = new In(); box.At.Add(box.At = new V(2, 2)); Console.WriteLine(box.At);
    In two = new In(); two.At.Add((two = new In { At = new V(4, 4) }).At); Console.WriteLine(two.At);
    In[] ins = { new In() }; ins[0].At.Add((ins[0] = new In { At = new V(4, 4) }).At); Console.WriteLine(ins[0].At);
    ref In ri = ref ins[0]; ref V rv = ref ins[0].At; ins[0] = new In { At = new V(1, 9) }; Console.WriteLine(rv + " " + ri.At); rv.X = 5; Console.WriteLine(ins[0].At);
    try { H none = null; none.At.AddD(Say()); } catch (NullReferenceException) { Console.WriteLine("null"); }
    try { arr[5].AddD(Say()); } catch (IndexOutOfRangeException) { Console.WriteLine("range"); }
    try { H none = null; none.At.X = Say(); } catch (NullReferenceException) { Console.WriteLine("null"); }
    try { arr[5].X = Say(); } catch (IndexOutOfRangeException) { Console.WriteLine("range"); }
    try { H none = null; none.Inner.At.X = Say(); } catch (NullReferenceException) { Console.WriteLine("null"); }
    Parts();
    V? maybe = new V(1, 2); Console.WriteLine(maybe.Value.AddD((maybe = new V(5, 5)).Value.X) + " " + maybe);
  }
  static double Swap(ref V a, ref V b, double d) { V t = a; a = b; b = t; b.X += d; return a.Dot(b); }
  static V Put(ref In at, V v) { at = new In { At = v, N = at.N + 1 }; return v; }
  static void Parts()
  {
    In big = new In(), other = new In { At = new V(2, 8) };
    Console.WriteLine(Swap(ref big.At, ref other.At, (big = new In { At = new V(5, 4) }).At.Y) + " " + big.At + " " + other.At);
    ref V part = ref big.At;
    big = new In { At = new V(1, 9) };
    part.X = 5;
    Console.WriteLine(big.At + " " + part);
    big.At.Add(Put(ref big, new V(30, 40)));
    Console.WriteLine(big.At + " " + big.N + " " + part);
    H h = new H();
    V old = h.At, then = h.At = new V(3, 3);
    then.X = 100;
    Console.WriteLine(old + " " + then + " " + h.At);
    In whole = h.Inner;
    In taken = h.Inner = new In { At = new V(6, 6) };
    taken.At.X = 7;
    h.Inner.At.Y = 8;
    Console.WriteLine(whole.At + " " + taken.At + " " + h.Inner.At);
    V[] copies = { h.At, h.Arr[0] };
    h.At = h.Arr[0] = new V(0, 0);
    h.At.X = 1;
    Console.WriteLine(copies[0] + " " + copies[1] + " " + h.At + " " + h.Arr[0]);
    foreach (V v in copies) { copies[0] = copies[1] = new V(77, 77); Console.Write(v + " "); }
    Console.WriteLine();
    Array.Reverse(copies); Array.Resize(ref copies, 3); copies[2] = copies[0]; copies[0].X = 4;
    Console.WriteLine(copies[0] + " " + copies[1] + " " + copies[2]);
  }
  static double Say() { Console.WriteLine("said"); return 1; }
}
