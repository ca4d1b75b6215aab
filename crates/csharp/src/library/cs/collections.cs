// Collections.
using System.Collections;

namespace System.Collections.Generic
{
    public interface IEnumerable<T> : IEnumerable { IEnumerator<T> GetEnumerator(); }
    public interface IEnumerator<T> : IEnumerator, IDisposable { T Current { get; } }
    public interface ICollection<T> : IEnumerable<T> { int Count { get; } bool IsReadOnly { get; } void Add(T item); void Clear(); bool Contains(T item); void CopyTo(T[] to, int at); bool Remove(T item); }
    public interface IList<T> : ICollection<T> { T this[int index] { get; set; } int IndexOf(T item); void Insert(int index, T item); void RemoveAt(int index); }
    public interface IReadOnlyCollection<T> : IEnumerable<T> { int Count { get; } }
    public interface IReadOnlyList<T> : IReadOnlyCollection<T> { T this[int index] { get; } }
    public interface ISet<T> : ICollection<T> { }
    public interface IDictionary<K, V> : ICollection<KeyValuePair<K, V>> { V this[K key] { get; set; } bool ContainsKey(K key); void Add(K key, V value); bool Remove(K key); bool TryGetValue(K key, out V value); }
    public interface IComparer<T> { int Compare(T a, T b); }
    public interface IEqualityComparer<T> { bool Equals(T a, T b); int GetHashCode(T item); }
    public class KeyNotFoundException : SystemException { public KeyNotFoundException() : base("The given key was not present in the dictionary.") { } public KeyNotFoundException(string m) : base(m) { } }
    public abstract class EqualityComparer<T> : IEqualityComparer<T>
    {
        public abstract bool Equals(T a, T b);
        public abstract int GetHashCode(T item);
        public static EqualityComparer<T> Default { get { return new DefaultEquality<T>(); } }
        public static bool Same(T a, T b)
        {
            object x = a, y = b;
            if (x == null || y == null) return x == null && y == null;
            if (Library.IsPlain(x)) return Library.PlainEquals(x, y);
            IEquatable<T> own = x as IEquatable<T>;
            return own != null ? own.Equals(b) : x.Equals(y);
        }
        public static int Hash(T item) { object x = item; return x == null ? 0 : Library.IsPlain(x) ? Library.PlainHash(x) : x.GetHashCode(); }
    }
    class DefaultEquality<T> : EqualityComparer<T>
    {
        public override bool Equals(T a, T b) { return Same(a, b); }
        public override int GetHashCode(T item) { return Hash(item); }
    }
    public abstract class Comparer<T> : IComparer<T>
    {
        public abstract int Compare(T a, T b);
        public static Comparer<T> Default { get { return new DefaultOrder<T>(); } }
        public static Comparer<T> Create(Comparison<T> compare) { return new OrderBy<T>(compare); }
        public static int Order(T a, T b)
        {
            object x = a, y = b;
            if (x == null) return y == null ? 0 : -1;
            if (y == null) return 1;
            if (Library.IsPlain(x)) return Library.PlainCompare(x, y);
            IComparable<T> own = x as IComparable<T>;
            if (own != null) return own.CompareTo(b);
            IComparable old = x as IComparable;
            if (old != null) return old.CompareTo(y);
            throw new ArgumentException("At least one object must implement IComparable.");
        }
    }
    class DefaultOrder<T> : Comparer<T> { public override int Compare(T a, T b) { return Order(a, b); } }
    class OrderBy<T> : Comparer<T> { Comparison<T> c; public OrderBy(Comparison<T> c) { this.c = c; } public override int Compare(T a, T b) { return c(a, b); } }
    public struct KeyValuePair<K, V>
    {
        public K Key { get; private set; }
        public V Value { get; private set; }
        public KeyValuePair(K key, V value) { Key = key; Value = value; }
        public override string ToString() { return "[" + Key + ", " + Value + "]"; }
        public void Deconstruct(out K key, out V value) { key = Key; value = Value; }
    }
    [Native] public class List<T> : IList<T>, IReadOnlyList<T>, IList
    {
        object IList.this[int index] { get { return this[index]; } set { this[index] = (T)value; } }
        int IList.Add(object item) { Add((T)item); return Count - 1; }
        bool IList.Contains(object item) { return item is T && Contains((T)item); }
        int IList.IndexOf(object item) { return item is T ? IndexOf((T)item) : -1; }
        void IList.Insert(int index, object item) { Insert(index, (T)item); }
        void IList.Remove(object item) { if (item is T) Remove((T)item); }
        public extern List();
        public extern List(int capacity);
        public List(IEnumerable<T> items) { AddRange(items); }
        public extern int Count { get; }
        public int Capacity { get { return Count; } set { } }
        public bool IsReadOnly { get { return false; } }
        public extern T this[int index] { get; set; }
        public extern void Add(T item);
        public extern int __Version();
        public extern bool __More(int index, int version);
        public extern void Clear();
        public extern void Insert(int index, T item);
        public extern void RemoveAt(int index);
        public extern void RemoveRange(int index, int count);
        public extern List<T> GetRange(int index, int count);
        public extern void Reverse(int index, int count);
        public void Reverse() { Reverse(0, Count); }
        public extern T[] ToArray();
        extern void __Take(T[] array);
        public void TrimExcess() { }
        public void AddRange(IEnumerable<T> items) { InsertRange(Count, items); }
        public void InsertRange(int index, IEnumerable<T> items)
        {
            if (items == null) throw new ArgumentNullException("collection");
            if (index < 0 || index > Count) throw new ArgumentOutOfRangeException("index", "Index must be within the bounds of the List.");
            List<T> list = items as List<T>;
            if (list != null) { foreach (T x in list.ToArray()) Insert(index++, x); return; }
            if (index == Count) { foreach (T x in items) Add(x); return; }
            foreach (T x in items) Insert(index++, x);
        }
        public IEnumerator<T> GetEnumerator()
        {
            int version = __Version();
            for (int i = 0; __More(i, version); i++) yield return this[i];
        }
        IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }
        public int IndexOf(T item) { for (int i = 0; i < Count; i++) if (EqualityComparer<T>.Same(this[i], item)) return i; return -1; }
        public int IndexOf(T item, int start) { for (int i = start; i < Count; i++) if (EqualityComparer<T>.Same(this[i], item)) return i; return -1; }
        public int LastIndexOf(T item) { for (int i = Count - 1; i >= 0; i--) if (EqualityComparer<T>.Same(this[i], item)) return i; return -1; }
        public bool Contains(T item) { return IndexOf(item) >= 0; }
        public bool Remove(T item) { int i = IndexOf(item); if (i < 0) return false; RemoveAt(i); return true; }
        public void CopyTo(T[] to) { CopyTo(to, 0); }
        public void CopyTo(T[] to, int at) { for (int i = 0; i < Count; i++) to[at + i] = this[i]; }
        public T Find(Predicate<T> match) { for (int i = 0; i < Count; i++) if (match(this[i])) return this[i]; return default(T); }
        public T FindLast(Predicate<T> match) { for (int i = Count - 1; i >= 0; i--) if (match(this[i])) return this[i]; return default(T); }
        public int FindIndex(Predicate<T> match) { for (int i = 0; i < Count; i++) if (match(this[i])) return i; return -1; }
        public int FindIndex(int start, Predicate<T> match) { for (int i = start; i < Count; i++) if (match(this[i])) return i; return -1; }
        public int FindLastIndex(Predicate<T> match) { for (int i = Count - 1; i >= 0; i--) if (match(this[i])) return i; return -1; }
        public List<T> FindAll(Predicate<T> match) { var found = new List<T>(); for (int i = 0; i < Count; i++) if (match(this[i])) found.Add(this[i]); return found; }
        public bool Exists(Predicate<T> match) { return FindIndex(match) >= 0; }
        public bool TrueForAll(Predicate<T> match) { for (int i = 0; i < Count; i++) if (!match(this[i])) return false; return true; }
        public void ForEach(Action<T> action) { foreach (T x in this) action(x); }
        public List<R> ConvertAll<R>(Converter<T, R> convert) { var made = new List<R>(); for (int i = 0; i < Count; i++) made.Add(convert(this[i])); return made; }
        public int RemoveAll(Predicate<T> match)
        {
            var kept = new List<T>();
            for (int i = 0; i < Count; i++) if (!match(this[i])) kept.Add(this[i]);
            int gone = Count - kept.Count;
            __Take(kept.ToArray());
            return gone;
        }
        void Order(int index, int count, Comparison<T> compare) { T[] a = ToArray(); Sorter<T>.Sort(a, index, count, compare); __Take(a); }
        public void Sort() { Order(0, Count, null); }
        public void Sort(Comparison<T> compare) { Order(0, Count, compare); }
        public void Sort(IComparer<T> comparer) { Order(0, Count, comparer == null ? null : new Comparison<T>(comparer.Compare)); }
        public void Sort(int index, int count, IComparer<T> comparer) { Order(index, count, comparer == null ? null : new Comparison<T>(comparer.Compare)); }
        public int BinarySearch(T item) { return Array.BinarySearch(ToArray(), item); }
        public IReadOnlyList<T> AsReadOnly() { return this; }
    }
    public class Dictionary<K, V> : IDictionary<K, V>
    {
        int[] buckets; int[] hashes; int[] nexts; K[] keys; V[] values;
        int count, free, freeCount, version;
        IEqualityComparer<K> comparer;
        public Dictionary() { free = -1; }
        public Dictionary(int capacity) { free = -1; }
        public Dictionary(IEqualityComparer<K> comparer) { free = -1; this.comparer = comparer; }
        public Dictionary(IDictionary<K, V> other) { free = -1; foreach (var pair in other) Add(pair.Key, pair.Value); }
        public int Count { get { return count - freeCount; } }
        public bool IsReadOnly { get { return false; } }
        int HashOf(K key) { return (comparer == null ? EqualityComparer<K>.Hash(key) : comparer.GetHashCode(key)) & 0x7FFFFFFF; }
        bool Same(K a, K b) { return comparer == null ? EqualityComparer<K>.Same(a, b) : comparer.Equals(a, b); }
        int Find(K key)
        {
            if ((object)key == null) throw new ArgumentNullException("key");
            if (buckets == null) return -1;
            int hash = HashOf(key);
            for (int i = buckets[hash % buckets.Length] - 1; i >= 0; i = nexts[i])
                if (hashes[i] == hash && Same(keys[i], key)) return i;
            return -1;
        }
        void Grow()
        {
            int size = buckets == null ? 3 : Library3.Prime(count * 2);
            Array.Resize(ref hashes, size); Array.Resize(ref nexts, size); Array.Resize(ref keys, size); Array.Resize(ref values, size);
            buckets = new int[size];
            for (int i = 0; i < count; i++)
                if (hashes[i] >= 0) { int b = hashes[i] % size; nexts[i] = buckets[b] - 1; buckets[b] = i + 1; }
        }
        void Put(K key, V value, bool add)
        {
            int found = Find(key);
            if (found >= 0)
            {
                if (add) throw new ArgumentException("An item with the same key has already been added. Key: " + key);
                values[found] = value; version++; return;
            }
            int hash = HashOf(key);
            int at;
            if (freeCount > 0) { at = free; free = nexts[at]; freeCount--; }
            else { if (buckets == null || count == buckets.Length) Grow(); at = count++; }
            int bucket = hash % buckets.Length;
            hashes[at] = hash; keys[at] = key; values[at] = value; nexts[at] = buckets[bucket] - 1; buckets[bucket] = at + 1;
            version++;
        }
        public V this[K key]
        {
            get { int i = Find(key); if (i < 0) throw new KeyNotFoundException("The given key '" + key + "' was not present in the dictionary."); return values[i]; }
            set { Put(key, value, false); }
        }
        public void Add(K key, V value) { Put(key, value, true); }
        public void Add(KeyValuePair<K, V> pair) { Put(pair.Key, pair.Value, true); }
        public bool ContainsKey(K key) { return Find(key) >= 0; }
        public bool ContainsValue(V value) { for (int i = 0; i < count; i++) if (hashes[i] >= 0 && EqualityComparer<V>.Same(values[i], value)) return true; return false; }
        public bool Contains(KeyValuePair<K, V> pair) { int i = Find(pair.Key); return i >= 0 && EqualityComparer<V>.Same(values[i], pair.Value); }
        public bool TryGetValue(K key, out V value) { int i = Find(key); value = i < 0 ? default(V) : values[i]; return i >= 0; }
        public bool Remove(KeyValuePair<K, V> pair) { return Contains(pair) && Remove(pair.Key); }
        public bool Remove(K key)
        {
            int found = Find(key);
            if (found < 0) return false;
            int bucket = hashes[found] % buckets.Length;
            int at = buckets[bucket] - 1, last = -1;
            while (at != found) { last = at; at = nexts[at]; }
            if (last < 0) buckets[bucket] = nexts[at] + 1; else nexts[last] = nexts[at];
            hashes[at] = -1; keys[at] = default(K); values[at] = default(V); nexts[at] = free; free = at; freeCount++; version++;
            return true;
        }
        public void Clear() { buckets = null; hashes = null; nexts = null; keys = null; values = null; count = 0; free = -1; freeCount = 0; version++; }
        public void CopyTo(KeyValuePair<K, V>[] to, int at) { foreach (var pair in this) to[at++] = pair; }
        void Check(int seen) { if (seen != version) throw new InvalidOperationException("Collection was modified; enumeration operation may not execute."); }
        public IEnumerator<KeyValuePair<K, V>> GetEnumerator()
        {
            int seen = version;
            for (int i = 0; i < count; i++) { if (hashes[i] >= 0) { yield return new KeyValuePair<K, V>(keys[i], values[i]); Check(seen); } }
        }
        IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }
        IEnumerable<K> AllKeys() { int seen = version; for (int i = 0; i < count; i++) if (hashes[i] >= 0) { yield return keys[i]; Check(seen); } }
        IEnumerable<V> AllValues() { int seen = version; for (int i = 0; i < count; i++) if (hashes[i] >= 0) { yield return values[i]; Check(seen); } }
        public KeyCollection Keys { get { return new KeyCollection(this); } }
        public ValueCollection Values { get { return new ValueCollection(this); } }
        public class KeyCollection : IReadOnlyCollection<K> { Dictionary<K, V> d; public KeyCollection(Dictionary<K, V> d) { this.d = d; } public int Count { get { return d.Count; } } public IEnumerator<K> GetEnumerator() { return d.AllKeys().GetEnumerator(); } IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); } }
        public class ValueCollection : IReadOnlyCollection<V> { Dictionary<K, V> d; public ValueCollection(Dictionary<K, V> d) { this.d = d; } public int Count { get { return d.Count; } } public IEnumerator<V> GetEnumerator() { return d.AllValues().GetEnumerator(); } IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); } }
    }
    static class Library3
    {
        public static int Prime(int least) { for (int i = least | 1; ; i += 2) { bool prime = true; for (int d = 3; d * d <= i; d += 2) if (i % d == 0) { prime = false; break; } if (prime && i > 2) return i; } }
    }
    public class HashSet<T> : ISet<T>, IReadOnlyCollection<T>
    {
        Dictionary<T, bool> items;
        public HashSet() { items = new Dictionary<T, bool>(); }
        public HashSet(IEnumerable<T> from) : this() { foreach (T x in from) Add(x); }
        public HashSet(IEqualityComparer<T> comparer) { items = new Dictionary<T, bool>(comparer); }
        public int Count { get { return items.Count; } }
        public bool IsReadOnly { get { return false; } }
        public bool Add(T x) { if (items.ContainsKey(x)) return false; items.Add(x, true); return true; }
        void ICollection<T>.Add(T x) { Add(x); }
        public bool Contains(T x) { return items.ContainsKey(x); }
        public bool Remove(T x) { return items.Remove(x); }
        public void Clear() { items.Clear(); }
        public void CopyTo(T[] to, int at) { foreach (T x in this) to[at++] = x; }
        public void UnionWith(IEnumerable<T> other) { foreach (T x in other) Add(x); }
        public void ExceptWith(IEnumerable<T> other) { foreach (T x in other) Remove(x); }
        public void IntersectWith(IEnumerable<T> other) { var keep = new HashSet<T>(other); RemoveWhere(x => !keep.Contains(x)); }
        public void SymmetricExceptWith(IEnumerable<T> other) { foreach (T x in new HashSet<T>(other)) if (!Remove(x)) Add(x); }
        public int RemoveWhere(Predicate<T> match) { var gone = new List<T>(); foreach (T x in this) if (match(x)) gone.Add(x); foreach (T x in gone) Remove(x); return gone.Count; }
        public bool IsSubsetOf(IEnumerable<T> other) { var o = new HashSet<T>(other); foreach (T x in this) if (!o.Contains(x)) return false; return true; }
        public bool IsSupersetOf(IEnumerable<T> other) { foreach (T x in other) if (!Contains(x)) return false; return true; }
        public bool Overlaps(IEnumerable<T> other) { foreach (T x in other) if (Contains(x)) return true; return false; }
        public bool SetEquals(IEnumerable<T> other) { var o = new HashSet<T>(other); return o.Count == Count && IsSubsetOf(o); }
        public IEnumerator<T> GetEnumerator() { return items.Keys.GetEnumerator(); }
        IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }
    }
    public class Queue<T> : IReadOnlyCollection<T>
    {
        T[] items = new T[4]; int head, size, version;
        public Queue() { }
        public Queue(int capacity) { }
        public Queue(IEnumerable<T> from) { foreach (T x in from) Enqueue(x); }
        public int Count { get { return size; } }
        public void Enqueue(T x)
        {
            if (size == items.Length) { T[] more = new T[size * 2]; for (int i = 0; i < size; i++) more[i] = items[(head + i) % size]; items = more; head = 0; }
            items[(head + size) % items.Length] = x; size++; version++;
        }
        public T Dequeue() { if (size == 0) throw new InvalidOperationException("Queue empty."); T x = items[head]; items[head] = default(T); head = (head + 1) % items.Length; size--; version++; return x; }
        public T Peek() { if (size == 0) throw new InvalidOperationException("Queue empty."); return items[head]; }
        public bool Contains(T x) { foreach (T y in this) if (EqualityComparer<T>.Same(x, y)) return true; return false; }
        public void Clear() { items = new T[4]; head = 0; size = 0; version++; }
        public T[] ToArray() { T[] a = new T[size]; for (int i = 0; i < size; i++) a[i] = items[(head + i) % items.Length]; return a; }
        public IEnumerator<T> GetEnumerator() { int seen = version; for (int i = 0; i < size; i++) { if (seen != version) throw new InvalidOperationException("Collection was modified; enumeration operation may not execute."); yield return items[(head + i) % items.Length]; } }
        IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }
    }
    public class Stack<T> : IReadOnlyCollection<T>
    {
        List<T> items = new List<T>();
        public Stack() { }
        public Stack(int capacity) { }
        public Stack(IEnumerable<T> from) { foreach (T x in from) Push(x); }
        public int Count { get { return items.Count; } }
        public void Push(T x) { items.Add(x); }
        public T Pop() { T x = Peek(); items.RemoveAt(items.Count - 1); return x; }
        public T Peek() { if (items.Count == 0) throw new InvalidOperationException("Stack empty."); return items[items.Count - 1]; }
        public bool Contains(T x) { return items.Contains(x); }
        public void Clear() { items.Clear(); }
        public T[] ToArray() { T[] a = items.ToArray(); Array.Reverse(a); return a; }
        public IEnumerator<T> GetEnumerator() { int v = items.__Version(); for (int i = items.Count - 1; i >= 0; i--) { items.__More(0, v); yield return items[i]; } }
        IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }
    }
    public class LinkedListNode<T> { public T Value { get; set; } public LinkedListNode<T> Next { get; internal set; } public LinkedListNode<T> Previous { get; internal set; } public LinkedListNode(T value) { Value = value; } }
    public class LinkedList<T> : IReadOnlyCollection<T>
    {
        public LinkedListNode<T> First { get; private set; }
        public LinkedListNode<T> Last { get; private set; }
        public int Count { get; private set; }
        public LinkedList() { }
        public LinkedList(IEnumerable<T> from) { foreach (T x in from) AddLast(x); }
        public LinkedListNode<T> AddLast(T x) { var n = new LinkedListNode<T>(x); n.Previous = Last; if (Last == null) First = n; else Last.Next = n; Last = n; Count++; return n; }
        public LinkedListNode<T> AddFirst(T x) { var n = new LinkedListNode<T>(x); n.Next = First; if (First == null) Last = n; else First.Previous = n; First = n; Count++; return n; }
        public LinkedListNode<T> AddAfter(LinkedListNode<T> at, T x) { if (at == Last) return AddLast(x); var n = new LinkedListNode<T>(x); n.Previous = at; n.Next = at.Next; at.Next.Previous = n; at.Next = n; Count++; return n; }
        public LinkedListNode<T> AddBefore(LinkedListNode<T> at, T x) { if (at == First) return AddFirst(x); return AddAfter(at.Previous, x); }
        public LinkedListNode<T> Find(T x) { for (var n = First; n != null; n = n.Next) if (EqualityComparer<T>.Same(n.Value, x)) return n; return null; }
        public void Remove(LinkedListNode<T> n) { if (n.Previous == null) First = n.Next; else n.Previous.Next = n.Next; if (n.Next == null) Last = n.Previous; else n.Next.Previous = n.Previous; Count--; }
        public bool Remove(T x) { var n = Find(x); if (n == null) return false; Remove(n); return true; }
        public void RemoveFirst() { if (First == null) throw new InvalidOperationException("The LinkedList is empty."); Remove(First); }
        public void RemoveLast() { if (Last == null) throw new InvalidOperationException("The LinkedList is empty."); Remove(Last); }
        public bool Contains(T x) { return Find(x) != null; }
        public void Clear() { First = null; Last = null; Count = 0; }
        public IEnumerator<T> GetEnumerator() { for (var n = First; n != null; n = n.Next) yield return n.Value; }
        IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }
    }
    public class SortedDictionary<K, V> : IReadOnlyCollection<KeyValuePair<K, V>>
    {
        List<K> keys = new List<K>(); List<V> values = new List<V>(); IComparer<K> comparer;
        public SortedDictionary() { }
        public SortedDictionary(IComparer<K> comparer) { this.comparer = comparer; }
        public SortedDictionary(IDictionary<K, V> from) { foreach (var p in from) Add(p.Key, p.Value); }
        public int Count { get { return keys.Count; } }
        public IReadOnlyList<K> Keys { get { return keys; } }
        public IReadOnlyList<V> Values { get { return values; } }
        int Find(K key)
        {
            if ((object)key == null) throw new ArgumentNullException("key");
            int low = 0, high = keys.Count - 1;
            while (low <= high) { int m = (low + high) / 2; int o = comparer == null ? Comparer<K>.Order(keys[m], key) : comparer.Compare(keys[m], key); if (o == 0) return m; if (o < 0) low = m + 1; else high = m - 1; }
            return ~low;
        }
        public void Add(K key, V value) { int i = Find(key); if (i >= 0) throw new ArgumentException("An item with the same key has already been added."); keys.Insert(~i, key); values.Insert(~i, value); }
        public V this[K key] { get { int i = Find(key); if (i < 0) throw new KeyNotFoundException(); return values[i]; } set { int i = Find(key); if (i >= 0) values[i] = value; else { keys.Insert(~i, key); values.Insert(~i, value); } } }
        public bool ContainsKey(K key) { return Find(key) >= 0; }
        public bool TryGetValue(K key, out V value) { int i = Find(key); value = i < 0 ? default(V) : values[i]; return i >= 0; }
        public bool Remove(K key) { int i = Find(key); if (i < 0) return false; keys.RemoveAt(i); values.RemoveAt(i); return true; }
        public int IndexOfKey(K key) { int i = Find(key); return i < 0 ? -1 : i; }
        public void Clear() { keys.Clear(); values.Clear(); }
        public IEnumerator<KeyValuePair<K, V>> GetEnumerator() { int v = keys.__Version(); for (int i = 0; keys.__More(i, v); i++) yield return new KeyValuePair<K, V>(keys[i], values[i]); }
        IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }
    }
    public class SortedList<K, V> : SortedDictionary<K, V> { public SortedList() { } public SortedList(IComparer<K> c) : base(c) { } }
    public class SortedSet<T> : IReadOnlyCollection<T>
    {
        SortedDictionary<T, bool> items;
        public SortedSet() { items = new SortedDictionary<T, bool>(); }
        public SortedSet(IEnumerable<T> from) : this() { foreach (T x in from) Add(x); }
        public int Count { get { return items.Count; } }
        public bool Add(T x) { if (items.ContainsKey(x)) return false; items.Add(x, true); return true; }
        public bool Contains(T x) { return items.ContainsKey(x); }
        public bool Remove(T x) { return items.Remove(x); }
        public void Clear() { items.Clear(); }
        public SortedSet<T> GetViewBetween(T low, T high) { var view = new SortedSet<T>(); foreach (T x in this) if (Comparer<T>.Order(x, low) >= 0 && Comparer<T>.Order(x, high) <= 0) view.Add(x); return view; }
        public T Min { get { return items.Keys[0]; } }
        public T Max { get { return items.Keys[items.Count - 1]; } }
        public IEnumerator<T> GetEnumerator() { return items.Keys.GetEnumerator(); }
        IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }
    }
}
