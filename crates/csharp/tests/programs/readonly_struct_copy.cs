using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

struct C { int n; public int N { get { return n; } } public void Inc() { n++; } public int Next() { return ++n; } }
class H { public readonly C R; public C F; public static readonly C S = new C(); public H() { R.Inc(); R.Inc(); } public void M() { R.Inc(); F.Inc(); S.Inc(); } }
class P { static void Use(in C c) { c.Inc(); Console.WriteLine(c.N); } static void Main() { var h = new H(); h.M(); h.R.Inc(); h.F.Inc(); H.S.Inc(); Console.WriteLine(h.R.N + " " + h.F.N + " " + H.S.N + " " + h.R.Next() + h.R.Next() + h.F.Next()); C[] a = new C[2]; foreach (C c in a) { c.Inc(); Console.Write(c.N); } a[0].Inc(); Console.WriteLine(a[0].N); C l = new C(); l.Inc(); l.Inc(); Console.WriteLine(l.N); C[] b = a; b[0].Inc(); Console.WriteLine(a[0].N); var list = new List<C> { l }; list[0].Inc(); Console.WriteLine(list[0].N); C copy = h.F; copy.Inc(); Console.WriteLine(h.F.N + " " + copy.N); Func<C> get = () => h.F; get().Inc(); Console.WriteLine(h.F.N); } }
