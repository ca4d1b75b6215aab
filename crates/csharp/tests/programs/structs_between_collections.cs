// Structs that go from one collection into another are copies: what is set in one of them is not seen in the other.
using System; using System.Collections.Generic; using System.Linq;
struct V { public int X, Y; public V(int x, int y) { X = x; Y = y; } public override string ToString() { return X + "," + Y; } }
struct K : IEquatable<K>, IComparable<K> { public int A; public K(int a) { A = a; } public bool Equals(K o) { return A == o.A; } public override int GetHashCode() { return A; } public int CompareTo(K o) { return A.CompareTo(o.A); } public override string ToString() { return "k" + A; } }
class P {
 static V[] New() { return new[] { new V(1, 1), new V(2, 2), new V(3, 3) }; }
 static void W(string n, IEnumerable<V> a, IEnumerable<V> b) { Console.WriteLine(n + " " + string.Join(";", a) + " | " + string.Join(";", b)); }
 static void Main() {
  var a = New(); var l = new List<V>(a); a[0] = new V(9, 9); W("ctor", a, l);
  a = New(); l = a.ToList(); a[0] = new V(9, 9); W("tolist", a, l);
  l = new List<V>(New()); a = l.ToArray(); a[0] = new V(9, 9); W("toarray", a, l);
  a = New(); var b = (V[])a.Clone(); a[0] = new V(9, 9); W("clone", a, b);
  a = New(); b = new V[3]; Array.Copy(a, b, 3); a[0] = new V(9, 9); W("copy", a, b);
  a = New(); b = new V[4]; a.CopyTo(b, 1); a[0] = new V(9, 9); W("copyto", a, b);
  a = New(); Array.Copy(a, 0, a, 1, 2); a[0] = new V(9, 9); W("overlap", a, a);
  l = new List<V>(); a = New(); l.AddRange(a); a[0] = new V(9, 9); W("addrange", a, l);
  l = new List<V>(New()); l.InsertRange(1, a = New()); a[0] = new V(9, 9); W("insertrange", a, l);
  l = new List<V>(New()); b = new V[3]; l.CopyTo(b); b[1] = new V(8, 8); W("list.copyto", b, l);
  a = New(); b = a.Concat(a).ToArray(); b[0] = new V(9, 9); W("concat", a, b);
  a = New(); b = a.Reverse().ToArray(); b[0] = new V(9, 9); W("reverse", a, b);
  a = New(); b = a.Select(v => v).ToArray(); b[0] = new V(9, 9); W("select", a, b);
  a = New(); b = a.OrderBy(v => -v.X).ToArray(); b[0] = new V(9, 9); W("orderby", a, b);
  a = New(); b = a; Array.Resize(ref b, 4); b[0] = new V(9, 9); W("resize", a, b);
  a = New(); Array.Reverse(a); a[0] = new V(9, 9); W("Array.Reverse", a, a);
  a = New(); V x = a[0]; a[0] = a[1]; a[1] = x; a[0] = new V(7, 7); W("swap", a, new[] { x });
  a = Enumerable.Repeat(new V(1, 1), 3).ToArray(); a[0] = new V(9, 9); W("repeat", a, a);
  var q = new Queue<V>(); foreach (var v in New()) q.Enqueue(v); V t = q.Dequeue(); for (int i = 0; i < 6; i++) q.Enqueue(new V(i, i)); W("queue", new[] { t, q.Peek() }, q);
  var s = new Stack<V>(); s.Push(new V(1, 1)); V p = s.Pop(); s.Push(new V(2, 2)); W("stack", new[] { p }, s);
  var d = new Dictionary<string, V>(); d["a"] = new V(1, 1); V da = d["a"]; d["a"] = new V(2, 2); V db; d.TryGetValue("a", out db); d["a"] = new V(3, 3); d.Remove("a"); d["b"] = new V(5, 5); W("dict", new[] { da, db }, d.Values);
  var dk = new Dictionary<K, V>(); K k = new K(1); dk[k] = new V(1, 1); k = new K(2); dk[k] = new V(2, 2); dk.Remove(new K(1)); dk[new K(3)] = new V(3, 3); Console.WriteLine(string.Join(";", dk.Keys) + " " + string.Join(";", dk.Values));
  var sd = new SortedDictionary<K, V>(); for (int i = 5; i > 0; i--) sd[new K(i)] = new V(i, i); var first = sd.First(); sd[new K(1)] = new V(100, 0); Console.WriteLine(first + " " + string.Join(";", sd));
  var hs = new HashSet<K>(); for (int i = 0; i < 20; i++) hs.Add(new K(i % 7)); hs.Remove(new K(3)); hs.Add(new K(9)); Console.WriteLine(string.Join(";", hs));
  var ll = new LinkedList<V>(); var node = ll.AddLast(new V(1, 1)); V nv = node.Value; node.Value = new V(2, 2); W("linked", new[] { nv }, ll);
  var e = ((IEnumerable<V>)New()).GetEnumerator(); e.MoveNext(); V c1 = e.Current; e.MoveNext(); V c2 = e.Current; W("enum", new[] { c1, c2 }, new V[0]);
  var le = new List<V>(New()).GetEnumerator(); le.MoveNext(); c1 = le.Current; le.MoveNext(); W("listenum", new[] { c1, le.Current }, new V[0]);
  var kv = new KeyValuePair<int, V>(1, new V(4, 4)); V kvv = kv.Value; kv = new KeyValuePair<int, V>(2, new V(5, 5)); Console.WriteLine(kvv + " " + kv);
  var tup = Tuple.Create(new V(1, 1), 2); var vt = (new V(1, 1), 2); var vt2 = vt; vt.Item1 = new V(3, 3); Console.WriteLine(tup + " " + vt + " " + vt2);
  a = New(); V max = a.Aggregate((m, v) => v.X > m.X ? v : m); a[2] = new V(0, 0); Console.WriteLine(max);
  a = New(); Array.Sort(a, (m, n) => n.X - m.X); V top = a[0]; a[0] = new V(-1, -1); Console.WriteLine(top + " " + a[0]);
  var acts = new List<Func<V>>(); foreach (var v in New()) acts.Add(() => v); for (int i = 0; i < 2; i++) { V z = new V(i, i); acts.Add(() => z); acts.Add(() => z = new V(z.X + 5, 0)); } Console.WriteLine(string.Join(";", acts.Select(f => f())) + " " + string.Join(";", acts.Select(f => f())));
  V? m1 = new V(1, 1), m2 = m1; m1 = new V(2, 2); V mm = m1.GetValueOrDefault(); m1 = null; Console.WriteLine(m2 + " " + mm + " " + m1.HasValue);
  object o1 = a[1]; a[1] = new V(6, 6); Console.WriteLine(o1 + " " + a[1]);
  V[][] jag = { New(), New() }; jag[0][1] = jag[1][1] = new V(0, 5); jag[0][1].X = 3; Console.WriteLine(jag[1][1] + " " + jag[0][1]);
  var dt = new DateTime[] { new DateTime(2020, 1, 1), new DateTime(2021, 1, 1) }; var dt0 = dt[0]; dt[0] = dt[1].AddDays(1); Console.WriteLine((dt[0] - dt0).TotalDays + " " + (dt[1] - dt[0]).TotalDays + " " + dt[0].Subtract(dt[0] = dt0).TotalDays);
 } }
