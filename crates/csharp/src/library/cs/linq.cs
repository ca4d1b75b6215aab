// LINQ to objects: lazy where .NET is.
using System.Collections;
using System.Collections.Generic;

namespace System.Linq
{
    public interface IGrouping<K, T> : IEnumerable<T> { K Key { get; } }
    class Group<K, T> : IGrouping<K, T>
    {
        public List<T> Items = new List<T>();
        public K Key { get; private set; }
        public Group(K key) { Key = key; }
        public IEnumerator<T> GetEnumerator() { return Items.GetEnumerator(); }
        IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }
    }
    public class Lookup<K, T> : IEnumerable<IGrouping<K, T>>
    {
        List<IGrouping<K, T>> groups = new List<IGrouping<K, T>>(); Dictionary<K, Group<K, T>> by = new Dictionary<K, Group<K, T>>(); Group<K, T> none;
        public void Put(K key, T item)
        {
            Group<K, T> g;
            if ((object)key == null) { if (none == null) { none = new Group<K, T>(key); groups.Add(none); } g = none; }
            else if (!by.TryGetValue(key, out g)) { g = new Group<K, T>(key); by.Add(key, g); groups.Add(g); }
            g.Items.Add(item);
        }
        public int Count { get { return groups.Count; } }
        public bool Contains(K key) { return by.ContainsKey(key); }
        public IEnumerable<T> this[K key] { get { Group<K, T> g; return by.TryGetValue(key, out g) ? g.Items : new List<T>(); } }
        public IEnumerator<IGrouping<K, T>> GetEnumerator() { return groups.GetEnumerator(); }
        IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }
    }
    public interface IOrderedEnumerable<T> : IEnumerable<T> { IOrderedEnumerable<T> Then(Comparison<T> next); }
    class Ordered<T> : IOrderedEnumerable<T>
    {
        IEnumerable<T> source; Comparison<T> compare;
        public Ordered(IEnumerable<T> source, Comparison<T> compare) { this.source = source; this.compare = compare; }
        public IOrderedEnumerable<T> Then(Comparison<T> next) { Comparison<T> first = compare; return new Ordered<T>(source, (a, b) => { int o = first(a, b); return o != 0 ? o : next(a, b); }); }
        static void Merge(T[] a, T[] t, int low, int high, Comparison<T> c)
        {
            if (high - low < 2) return;
            int m = (low + high) / 2;
            Merge(a, t, low, m, c); Merge(a, t, m, high, c);
            int i = low, j = m, k = low;
            while (i < m && j < high) { if (c(a[j], a[i]) < 0) t[k++] = a[j++]; else t[k++] = a[i++]; }
            while (i < m) t[k++] = a[i++];
            while (j < high) t[k++] = a[j++];
            for (k = low; k < high; k++) a[k] = t[k];
        }
        public IEnumerator<T> GetEnumerator() { T[] a = source.ToArray(); Merge(a, new T[a.Length], 0, a.Length, compare); foreach (T x in a) yield return x; }
        IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }
    }
    public static class Enumerable
    {
        static void Check(object s) { if (s == null) throw new ArgumentNullException("source"); }
        static Exception None() { return new InvalidOperationException("Sequence contains no elements"); }
        static Exception NoMatch() { return new InvalidOperationException("Sequence contains no matching element"); }
        public static IEnumerable<int> Range(int start, int count) { if (count < 0) throw new ArgumentOutOfRangeException("count"); return RangeOf(start, count); }
        static IEnumerable<int> RangeOf(int start, int count) { for (int i = 0; i < count; i++) yield return start + i; }
        public static IEnumerable<T> Repeat<T>(T x, int count) { if (count < 0) throw new ArgumentOutOfRangeException("count"); return RepeatOf(x, count); }
        static IEnumerable<T> RepeatOf<T>(T x, int count) { for (int i = 0; i < count; i++) yield return x; }
        public static IEnumerable<T> Empty<T>() { return new T[0]; }
        public static IEnumerable<T> Where<T>(this IEnumerable<T> s, Func<T, bool> f) { Check(s); return WhereOf(s, f); }
        static IEnumerable<T> WhereOf<T>(IEnumerable<T> s, Func<T, bool> f) { foreach (T x in s) if (f(x)) yield return x; }
        public static IEnumerable<T> Where<T>(this IEnumerable<T> s, Func<T, int, bool> f) { int i = 0; foreach (T x in s) if (f(x, i++)) yield return x; }
        public static IEnumerable<R> Select<T, R>(this IEnumerable<T> s, Func<T, R> f) { Check(s); return SelectOf(s, f); }
        static IEnumerable<R> SelectOf<T, R>(IEnumerable<T> s, Func<T, R> f) { foreach (T x in s) yield return f(x); }
        public static IEnumerable<R> Select<T, R>(this IEnumerable<T> s, Func<T, int, R> f) { int i = 0; foreach (T x in s) yield return f(x, i++); }
        public static IEnumerable<R> SelectMany<T, R>(this IEnumerable<T> s, Func<T, IEnumerable<R>> f) { foreach (T x in s) foreach (R y in f(x)) yield return y; }
        public static IEnumerable<R> SelectMany<T, M, R>(this IEnumerable<T> s, Func<T, IEnumerable<M>> f, Func<T, M, R> g) { foreach (T x in s) foreach (M y in f(x)) yield return g(x, y); }
        public static IEnumerable<T> Take<T>(this IEnumerable<T> s, int n) { if (n > 0) foreach (T x in s) { yield return x; if (--n == 0) break; } }
        public static IEnumerable<T> Skip<T>(this IEnumerable<T> s, int n) { foreach (T x in s) { if (n > 0) n--; else yield return x; } }
        public static IEnumerable<T> TakeWhile<T>(this IEnumerable<T> s, Func<T, bool> f) { foreach (T x in s) { if (!f(x)) break; yield return x; } }
        public static IEnumerable<T> SkipWhile<T>(this IEnumerable<T> s, Func<T, bool> f) { bool on = false; foreach (T x in s) { if (!on && !f(x)) on = true; if (on) yield return x; } }
        public static IEnumerable<T> Concat<T>(this IEnumerable<T> a, IEnumerable<T> b) { foreach (T x in a) yield return x; foreach (T x in b) yield return x; }
        public static IEnumerable<T> Append<T>(this IEnumerable<T> a, T b) { foreach (T x in a) yield return x; yield return b; }
        public static IEnumerable<T> Prepend<T>(this IEnumerable<T> a, T b) { yield return b; foreach (T x in a) yield return x; }
        public static IEnumerable<R> Zip<A, B, R>(this IEnumerable<A> a, IEnumerable<B> b, Func<A, B, R> f) { using (var i = a.GetEnumerator()) using (var j = b.GetEnumerator()) while (i.MoveNext() && j.MoveNext()) yield return f(i.Current, j.Current); }
        public static IEnumerable<T> Reverse<T>(this IEnumerable<T> s) { T[] a = s.ToArray(); for (int i = a.Length - 1; i >= 0; i--) yield return a[i]; }
        public static IEnumerable<T> Distinct<T>(this IEnumerable<T> s) { var seen = new HashSet<T>(); foreach (T x in s) if (seen.Add(x)) yield return x; }
        public static IEnumerable<T> Union<T>(this IEnumerable<T> a, IEnumerable<T> b) { return a.Concat(b).Distinct(); }
        public static IEnumerable<T> Intersect<T>(this IEnumerable<T> a, IEnumerable<T> b) { var keep = new HashSet<T>(b); foreach (T x in a) if (keep.Remove(x)) yield return x; }
        public static IEnumerable<T> Except<T>(this IEnumerable<T> a, IEnumerable<T> b) { var gone = new HashSet<T>(b); foreach (T x in a) if (gone.Add(x)) yield return x; }
        public static IEnumerable<T> DefaultIfEmpty<T>(this IEnumerable<T> s) { return s.DefaultIfEmpty(default(T)); }
        public static IEnumerable<T> DefaultIfEmpty<T>(this IEnumerable<T> s, T d) { bool any = false; foreach (T x in s) { any = true; yield return x; } if (!any) yield return d; }
        public static IEnumerable<R> Cast<R>(this IEnumerable s) { foreach (object x in s) yield return (R)x; }
        public static IEnumerable<R> OfType<R>(this IEnumerable s) { foreach (object x in s) if (x is R) yield return (R)x; }
        public static IEnumerable<T> AsEnumerable<T>(this IEnumerable<T> s) { return s; }
        public static List<T> ToList<T>(this IEnumerable<T> s) { Check(s); var a = new List<T>(); foreach (T x in s) a.Add(x); return a; }
        public static T[] ToArray<T>(this IEnumerable<T> s) { Check(s); List<T> l = s as List<T>; return l != null ? l.ToArray() : s.ToList().ToArray(); }
        public static HashSet<T> ToHashSet<T>(this IEnumerable<T> s) { return new HashSet<T>(s); }
        public static Dictionary<K, T> ToDictionary<T, K>(this IEnumerable<T> s, Func<T, K> k) { var d = new Dictionary<K, T>(); foreach (T x in s) d.Add(k(x), x); return d; }
        public static Dictionary<K, V> ToDictionary<T, K, V>(this IEnumerable<T> s, Func<T, K> k, Func<T, V> v) { var d = new Dictionary<K, V>(); foreach (T x in s) d.Add(k(x), v(x)); return d; }
        public static Lookup<K, T> ToLookup<T, K>(this IEnumerable<T> s, Func<T, K> k) { var l = new Lookup<K, T>(); foreach (T x in s) l.Put(k(x), x); return l; }
        public static Lookup<K, V> ToLookup<T, K, V>(this IEnumerable<T> s, Func<T, K> k, Func<T, V> v) { var l = new Lookup<K, V>(); foreach (T x in s) l.Put(k(x), v(x)); return l; }
        public static IEnumerable<IGrouping<K, T>> GroupBy<T, K>(this IEnumerable<T> s, Func<T, K> k) { foreach (var g in s.ToLookup(k)) yield return g; }
        public static IEnumerable<IGrouping<K, V>> GroupBy<T, K, V>(this IEnumerable<T> s, Func<T, K> k, Func<T, V> v) { var l = new Lookup<K, V>(); foreach (T x in s) l.Put(k(x), v(x)); foreach (var g in l) yield return g; }
        public static IEnumerable<R> GroupBy<T, K, R>(this IEnumerable<T> s, Func<T, K> k, Func<K, IEnumerable<T>, R> r) { foreach (var g in s.ToLookup(k)) yield return r(g.Key, g); }
        public static IEnumerable<R> Join<A, B, K, R>(this IEnumerable<A> a, IEnumerable<B> b, Func<A, K> ka, Func<B, K> kb, Func<A, B, R> f) { var l = b.ToLookup(kb); foreach (A x in a) foreach (B y in l[ka(x)]) yield return f(x, y); }
        public static IEnumerable<R> GroupJoin<A, B, K, R>(this IEnumerable<A> a, IEnumerable<B> b, Func<A, K> ka, Func<B, K> kb, Func<A, IEnumerable<B>, R> f) { var l = b.ToLookup(kb); foreach (A x in a) yield return f(x, l[ka(x)]); }
        public static IOrderedEnumerable<T> OrderBy<T, K>(this IEnumerable<T> s, Func<T, K> k) { Check(s); return new Ordered<T>(s, (a, b) => Comparer<K>.Order(k(a), k(b))); }
        public static IOrderedEnumerable<T> OrderBy<T, K>(this IEnumerable<T> s, Func<T, K> k, IComparer<K> c) { return new Ordered<T>(s, (a, b) => c.Compare(k(a), k(b))); }
        public static IOrderedEnumerable<T> OrderByDescending<T, K>(this IEnumerable<T> s, Func<T, K> k) { return new Ordered<T>(s, (a, b) => Comparer<K>.Order(k(b), k(a))); }
        public static IOrderedEnumerable<T> ThenBy<T, K>(this IOrderedEnumerable<T> s, Func<T, K> k) { return s.Then((a, b) => Comparer<K>.Order(k(a), k(b))); }
        public static IOrderedEnumerable<T> ThenByDescending<T, K>(this IOrderedEnumerable<T> s, Func<T, K> k) { return s.Then((a, b) => Comparer<K>.Order(k(b), k(a))); }
        public static bool Any<T>(this IEnumerable<T> s) { Check(s); foreach (T x in s) return true; return false; }
        public static bool Any<T>(this IEnumerable<T> s, Func<T, bool> f) { foreach (T x in s) if (f(x)) return true; return false; }
        public static bool All<T>(this IEnumerable<T> s, Func<T, bool> f) { foreach (T x in s) if (!f(x)) return false; return true; }
        public static int Count<T>(this IEnumerable<T> s) { Check(s); List<T> l = s as List<T>; if (l != null) return l.Count; int n = 0; foreach (T x in s) n++; return n; }
        public static int Count<T>(this IEnumerable<T> s, Func<T, bool> f) { int n = 0; foreach (T x in s) if (f(x)) n++; return n; }
        public static bool Contains<T>(this IEnumerable<T> s, T v) { foreach (T x in s) if (EqualityComparer<T>.Same(x, v)) return true; return false; }
        public static bool SequenceEqual<T>(this IEnumerable<T> a, IEnumerable<T> b) { using (var i = a.GetEnumerator()) using (var j = b.GetEnumerator()) { while (i.MoveNext()) if (!j.MoveNext() || !EqualityComparer<T>.Same(i.Current, j.Current)) return false; return !j.MoveNext(); } }
        public static T First<T>(this IEnumerable<T> s) { Check(s); foreach (T x in s) return x; throw None(); }
        public static T First<T>(this IEnumerable<T> s, Func<T, bool> f) { foreach (T x in s) if (f(x)) return x; throw NoMatch(); }
        public static T FirstOrDefault<T>(this IEnumerable<T> s) { foreach (T x in s) return x; return default(T); }
        public static T FirstOrDefault<T>(this IEnumerable<T> s, Func<T, bool> f) { foreach (T x in s) if (f(x)) return x; return default(T); }
        public static T Last<T>(this IEnumerable<T> s) { Check(s); bool any = false; T l = default(T); foreach (T x in s) { l = x; any = true; } if (!any) throw None(); return l; }
        public static T Last<T>(this IEnumerable<T> s, Func<T, bool> f) { bool any = false; T l = default(T); foreach (T x in s) if (f(x)) { l = x; any = true; } if (!any) throw NoMatch(); return l; }
        public static T LastOrDefault<T>(this IEnumerable<T> s) { T l = default(T); foreach (T x in s) l = x; return l; }
        public static T LastOrDefault<T>(this IEnumerable<T> s, Func<T, bool> f) { T l = default(T); foreach (T x in s) if (f(x)) l = x; return l; }
        public static T Single<T>(this IEnumerable<T> s) { int n = 0; T l = default(T); foreach (T x in s) { l = x; if (++n > 1) throw new InvalidOperationException("Sequence contains more than one element"); } if (n == 0) throw None(); return l; }
        public static T Single<T>(this IEnumerable<T> s, Func<T, bool> f) { int n = 0; T l = default(T); foreach (T x in s) if (f(x)) { l = x; n++; } if (n == 0) throw NoMatch(); if (n > 1) throw new InvalidOperationException("Sequence contains more than one matching element"); return l; }
        public static T SingleOrDefault<T>(this IEnumerable<T> s) { int n = 0; T l = default(T); foreach (T x in s) { l = x; if (++n > 1) throw new InvalidOperationException("Sequence contains more than one element"); } return l; }
        public static T SingleOrDefault<T>(this IEnumerable<T> s, Func<T, bool> f) { int n = 0; T l = default(T); foreach (T x in s) if (f(x)) { l = x; n++; } if (n > 1) throw new InvalidOperationException("Sequence contains more than one matching element"); return l; }
        public static long LongCount<T>(this IEnumerable<T> s) { return s.Count(); }
        public static long LongCount<T>(this IEnumerable<T> s, Func<T, bool> f) { return s.Count(f); }
        public static IEnumerable<T> TakeLast<T>(this IEnumerable<T> s, int n) { T[] a = s.ToArray(); for (int i = Math.Max(0, a.Length - n); i < a.Length; i++) yield return a[i]; }
        public static IEnumerable<T> SkipLast<T>(this IEnumerable<T> s, int n) { T[] a = s.ToArray(); for (int i = 0; i < a.Length - Math.Max(n, 0); i++) yield return a[i]; }
        public static IEnumerable<T[]> Chunk<T>(this IEnumerable<T> s, int n)
        {
            if (n < 1) throw new ArgumentOutOfRangeException("size");
            var part = new List<T>();
            foreach (T x in s) { part.Add(x); if (part.Count == n) { yield return part.ToArray(); part.Clear(); } }
            if (part.Count > 0) yield return part.ToArray();
        }
        public static IEnumerable<T> DistinctBy<T, K>(this IEnumerable<T> s, Func<T, K> k) { var seen = new HashSet<K>(); foreach (T x in s) if (seen.Add(k(x))) yield return x; }
        public static T MaxBy<T, K>(this IEnumerable<T> s, Func<T, K> k) { return s.Aggregate((a, b) => Comparer<K>.Order(k(b), k(a)) > 0 ? b : a); }
        public static T MinBy<T, K>(this IEnumerable<T> s, Func<T, K> k) { return s.Aggregate((a, b) => Comparer<K>.Order(k(b), k(a)) < 0 ? b : a); }
        public static IEnumerable<(A First, B Second)> Zip<A, B>(this IEnumerable<A> a, IEnumerable<B> b) { using (var i = a.GetEnumerator()) using (var j = b.GetEnumerator()) while (i.MoveNext() && j.MoveNext()) yield return (i.Current, j.Current); }
        public static IOrderedEnumerable<T> OrderByDescending<T, K>(this IEnumerable<T> s, Func<T, K> k, IComparer<K> c) { return new Ordered<T>(s, (a, b) => c.Compare(k(b), k(a))); }
        public static IOrderedEnumerable<T> ThenBy<T, K>(this IOrderedEnumerable<T> s, Func<T, K> k, IComparer<K> c) { return s.Then((a, b) => c.Compare(k(a), k(b))); }
        public static IOrderedEnumerable<T> ThenByDescending<T, K>(this IOrderedEnumerable<T> s, Func<T, K> k, IComparer<K> c) { return s.Then((a, b) => c.Compare(k(b), k(a))); }
        public static T ElementAt<T>(this IEnumerable<T> s, int i) { int n = i; if (i >= 0) foreach (T x in s) if (n-- == 0) return x; throw new ArgumentOutOfRangeException("index"); }
        public static T ElementAtOrDefault<T>(this IEnumerable<T> s, int i) { if (i >= 0) foreach (T x in s) if (i-- == 0) return x; return default(T); }
        public static T Aggregate<T>(this IEnumerable<T> s, Func<T, T, T> f) { bool any = false; T a = default(T); foreach (T x in s) { a = any ? f(a, x) : x; any = true; } if (!any) throw None(); return a; }
        public static A Aggregate<T, A>(this IEnumerable<T> s, A seed, Func<A, T, A> f) { foreach (T x in s) seed = f(seed, x); return seed; }
        public static R Aggregate<T, A, R>(this IEnumerable<T> s, A seed, Func<A, T, A> f, Func<A, R> r) { foreach (T x in s) seed = f(seed, x); return r(seed); }
        public static int Sum(this IEnumerable<int> s) { long t = 0; foreach (int x in s) t = checked(t + x); return checked((int)t); }
        public static int Sum<T>(this IEnumerable<T> s, Func<T, int> f) { return s.Select(f).Sum(); }
        public static double Average(this IEnumerable<int> s) { long t = 0; long n = 0; foreach (int x in s) { t += x; n++; } if (n == 0) throw None(); return (double)((double)t / n); }
        public static double Average<T>(this IEnumerable<T> s, Func<T, int> f) { return s.Select(f).Average(); }
        public static int Max(this IEnumerable<int> s) { bool any = false; int m = 0; foreach (int x in s) { if (!any || x > m) m = x; any = true; } if (!any) throw None(); return m; }
        public static int Max<T>(this IEnumerable<T> s, Func<T, int> f) { return s.Select(f).Max(); }
        public static int Min(this IEnumerable<int> s) { bool any = false; int m = 0; foreach (int x in s) { if (!any || x < m) m = x; any = true; } if (!any) throw None(); return m; }
        public static int Min<T>(this IEnumerable<T> s, Func<T, int> f) { return s.Select(f).Min(); }
        public static long Sum(this IEnumerable<long> s) { long t = 0; foreach (long x in s) t = checked(t + x); return (long)t; }
        public static long Sum<T>(this IEnumerable<T> s, Func<T, long> f) { return s.Select(f).Sum(); }
        public static double Average(this IEnumerable<long> s) { long t = 0; long n = 0; foreach (long x in s) { t += x; n++; } if (n == 0) throw None(); return (double)((double)t / n); }
        public static double Average<T>(this IEnumerable<T> s, Func<T, long> f) { return s.Select(f).Average(); }
        public static long Max(this IEnumerable<long> s) { bool any = false; long m = 0; foreach (long x in s) { if (!any || x > m) m = x; any = true; } if (!any) throw None(); return m; }
        public static long Max<T>(this IEnumerable<T> s, Func<T, long> f) { return s.Select(f).Max(); }
        public static long Min(this IEnumerable<long> s) { bool any = false; long m = 0; foreach (long x in s) { if (!any || x < m) m = x; any = true; } if (!any) throw None(); return m; }
        public static long Min<T>(this IEnumerable<T> s, Func<T, long> f) { return s.Select(f).Min(); }
        public static double Sum(this IEnumerable<double> s) { double t = 0; foreach (double x in s) t = checked(t + x); return (double)t; }
        public static double Sum<T>(this IEnumerable<T> s, Func<T, double> f) { return s.Select(f).Sum(); }
        public static double Average(this IEnumerable<double> s) { double t = 0; long n = 0; foreach (double x in s) { t += x; n++; } if (n == 0) throw None(); return (double)((double)t / n); }
        public static double Average<T>(this IEnumerable<T> s, Func<T, double> f) { return s.Select(f).Average(); }
        public static double Max(this IEnumerable<double> s) { bool any = false; double m = 0; foreach (double x in s) { if (!any || x > m || double.IsNaN(m)) m = x; any = true; } if (!any) throw None(); return m; }
        public static double Max<T>(this IEnumerable<T> s, Func<T, double> f) { return s.Select(f).Max(); }
        public static double Min(this IEnumerable<double> s) { bool any = false; double m = 0; foreach (double x in s) { if (!any || x < m || double.IsNaN(x)) m = x; any = true; } if (!any) throw None(); return m; }
        public static double Min<T>(this IEnumerable<T> s, Func<T, double> f) { return s.Select(f).Min(); }
        public static float Sum(this IEnumerable<float> s) { double t = 0; foreach (float x in s) t = checked(t + x); return (float)t; }
        public static float Sum<T>(this IEnumerable<T> s, Func<T, float> f) { return s.Select(f).Sum(); }
        public static float Average(this IEnumerable<float> s) { double t = 0; long n = 0; foreach (float x in s) { t += x; n++; } if (n == 0) throw None(); return (float)((double)t / n); }
        public static float Average<T>(this IEnumerable<T> s, Func<T, float> f) { return s.Select(f).Average(); }
        public static float Max(this IEnumerable<float> s) { bool any = false; float m = 0; foreach (float x in s) { if (!any || x > m || float.IsNaN(m)) m = x; any = true; } if (!any) throw None(); return m; }
        public static float Max<T>(this IEnumerable<T> s, Func<T, float> f) { return s.Select(f).Max(); }
        public static float Min(this IEnumerable<float> s) { bool any = false; float m = 0; foreach (float x in s) { if (!any || x < m || float.IsNaN(x)) m = x; any = true; } if (!any) throw None(); return m; }
        public static float Min<T>(this IEnumerable<T> s, Func<T, float> f) { return s.Select(f).Min(); }
        public static int? Sum(this IEnumerable<int?> s) { long t = 0; foreach (int? x in s) if (x != null) t = checked(t + x.Value); return checked((int)t); }
        public static int? Sum<T>(this IEnumerable<T> s, Func<T, int?> f) { return s.Select(f).Sum(); }
        public static double? Average(this IEnumerable<int?> s) { long t = 0; long n = 0; foreach (int? x in s) if (x != null) { t += x.Value; n++; } if (n == 0) return null; return (double)((double)t / n); }
        public static double? Average<T>(this IEnumerable<T> s, Func<T, int?> f) { return s.Select(f).Average(); }
        public static long? Sum(this IEnumerable<long?> s) { long t = 0; foreach (long? x in s) if (x != null) t = checked(t + x.Value); return checked((long)t); }
        public static long? Sum<T>(this IEnumerable<T> s, Func<T, long?> f) { return s.Select(f).Sum(); }
        public static double? Average(this IEnumerable<long?> s) { long t = 0; long n = 0; foreach (long? x in s) if (x != null) { t += x.Value; n++; } if (n == 0) return null; return (double)((double)t / n); }
        public static double? Average<T>(this IEnumerable<T> s, Func<T, long?> f) { return s.Select(f).Average(); }
        public static double? Sum(this IEnumerable<double?> s) { double t = 0; foreach (double? x in s) if (x != null) t = checked(t + x.Value); return checked((double)t); }
        public static double? Sum<T>(this IEnumerable<T> s, Func<T, double?> f) { return s.Select(f).Sum(); }
        public static double? Average(this IEnumerable<double?> s) { double t = 0; long n = 0; foreach (double? x in s) if (x != null) { t += x.Value; n++; } if (n == 0) return null; return (double)((double)t / n); }
        public static double? Average<T>(this IEnumerable<T> s, Func<T, double?> f) { return s.Select(f).Average(); }
        public static float? Sum(this IEnumerable<float?> s) { double t = 0; foreach (float? x in s) if (x != null) t = checked(t + x.Value); return checked((float)t); }
        public static float? Sum<T>(this IEnumerable<T> s, Func<T, float?> f) { return s.Select(f).Sum(); }
        public static float? Average(this IEnumerable<float?> s) { double t = 0; long n = 0; foreach (float? x in s) if (x != null) { t += x.Value; n++; } if (n == 0) return null; return (float)((double)t / n); }
        public static float? Average<T>(this IEnumerable<T> s, Func<T, float?> f) { return s.Select(f).Average(); }
        public static decimal Sum(this IEnumerable<decimal> s) { decimal t = 0; foreach (decimal x in s) t += x; return t; }
        public static decimal Sum<T>(this IEnumerable<T> s, Func<T, decimal> f) { return s.Select(f).Sum(); }
        public static decimal Average(this IEnumerable<decimal> s) { decimal t = 0; long n = 0; foreach (decimal x in s) { t += x; n++; } if (n == 0) throw None(); return t / n; }
        public static decimal Average<T>(this IEnumerable<T> s, Func<T, decimal> f) { return s.Select(f).Average(); }
        public static decimal? Sum(this IEnumerable<decimal?> s) { decimal t = 0; foreach (decimal? x in s) if (x != null) t += x.Value; return t; }
        public static decimal? Sum<T>(this IEnumerable<T> s, Func<T, decimal?> f) { return s.Select(f).Sum(); }
        public static decimal? Average(this IEnumerable<decimal?> s) { decimal t = 0; long n = 0; foreach (decimal? x in s) if (x != null) { t += x.Value; n++; } if (n == 0) return null; return t / n; }
        public static decimal? Average<T>(this IEnumerable<T> s, Func<T, decimal?> f) { return s.Select(f).Average(); }
        public static decimal Max(this IEnumerable<decimal> s) { bool any = false; decimal m = 0; foreach (decimal x in s) { if (!any || x > m) m = x; any = true; } if (!any) throw None(); return m; }
        public static decimal Max<T>(this IEnumerable<T> s, Func<T, decimal> f) { return s.Select(f).Max(); }
        public static decimal Min(this IEnumerable<decimal> s) { bool any = false; decimal m = 0; foreach (decimal x in s) { if (!any || x < m) m = x; any = true; } if (!any) throw None(); return m; }
        public static decimal Min<T>(this IEnumerable<T> s, Func<T, decimal> f) { return s.Select(f).Min(); }
        public static T Max<T>(this IEnumerable<T> s) { bool any = false; T m = default(T); foreach (T x in s) { if ((object)x == null) continue; if (!any || Comparer<T>.Order(x, m) > 0) m = x; any = true; } if (!any && (object)default(T) != null) throw None(); return m; }
        public static R Max<T, R>(this IEnumerable<T> s, Func<T, R> f) { return s.Select(f).Max(); }
        public static T Min<T>(this IEnumerable<T> s) { bool any = false; T m = default(T); foreach (T x in s) { if ((object)x == null) continue; if (!any || Comparer<T>.Order(x, m) < 0) m = x; any = true; } if (!any && (object)default(T) != null) throw None(); return m; }
        public static R Min<T, R>(this IEnumerable<T> s, Func<T, R> f) { return s.Select(f).Min(); }
    }
}
