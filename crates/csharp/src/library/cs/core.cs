// The types that the language knows. What is `extern` is done in Rust, under the key of its signature.
using System.Collections;
using System.Collections.Generic;
using System.Globalization;

namespace System
{
    [Native] public class Object
    {
        public extern Object();
        public virtual extern string ToString();
        public virtual extern bool Equals(object other);
        public virtual extern int GetHashCode();
        public extern Type GetType();
        public static bool Equals(object a, object b) { return ReferenceEquals(a, b) || a != null && b != null && a.Equals(b); }
        public static bool ReferenceEquals(object a, object b) { return a == b; }
        protected extern object MemberwiseClone();
    }
    public abstract class ValueType { }
    public abstract class Enum : IComparable
    {
        public override extern string ToString();
        public extern string ToString(string format);
        public extern int CompareTo(object other);
        public extern bool HasFlag(Enum flag);
        public static extern object Parse(Type type, string text);
        public static extern object Parse(Type type, string text, bool ignoreCase);
        public static extern Array GetValues(Type type);
        public static extern string[] GetNames(Type type);
        public static extern string GetName(Type type, object value);
        public static extern Type GetUnderlyingType(Type type);
        public static extern bool IsDefined(Type type, object value);
        public static bool TryParse<T>(string text, out T value) where T : struct { return TryParse<T>(text, false, out value); }
        public static bool TryParse<T>(string text, bool ignoreCase, out T value) where T : struct
        {
            value = default(T);
            try { value = (T)Parse(typeof(T), text, ignoreCase); return true; }
            catch (ArgumentException) { return false; }
        }
    }
    public abstract class Delegate
    {
        public static extern T[] __Join<T>(T a, T b);
        public static extern T[] __Without<T>(T a, T b);
        public static extern bool __Same(object a, object b);
        public override extern bool Equals(object other);
        public override int GetHashCode() { return 1; }
        public extern Delegate[] GetInvocationList();
    }
    public class EventArgs
    {
        public static readonly EventArgs Empty = new EventArgs();
    }
    public delegate void EventHandler(object sender, EventArgs e);
    public delegate void EventHandler<T>(object sender, T e);
    public abstract class AnonymousObject
    {
        public extern string[] __Names();
        public extern object[] __Values();
        public override string ToString()
        {
            string[] names = __Names();
            object[] values = __Values();
            for (int i = 0; i < names.Length; i++) names[i] += " = " + Library.Text(values[i]);
            return names.Length == 0 ? "{ }" : "{ " + string.Join(", ", names) + " }";
        }
        public override extern bool Equals(object other);
        public override extern int GetHashCode();
    }
    [Native] public sealed class Type
    {
        public extern string Name { get; }
        public extern string FullName { get; }
        public override extern string ToString();
        public override extern bool Equals(object other);
        public override extern int GetHashCode();
        public static bool operator ==(Type a, Type b) { return Equals(a, b); }
        public static bool operator !=(Type a, Type b) { return !Equals(a, b); }
    }
    public interface IDisposable { void Dispose(); }
    public interface IComparable { int CompareTo(object other); }
    public interface IComparable<T> { int CompareTo(T other); }
    public interface IEquatable<T> { bool Equals(T other); }
    public interface IFormattable { string ToString(string format, IFormatProvider provider); }
    public interface IFormatProvider { }
    public interface ICloneable { object Clone(); }
    public struct Nullable<T> where T : struct
    {
        public bool HasValue { get { return Library.IsThere(this); } }
        public T Value { get { return (T)(object)Library.Demand(this); } }
        public T GetValueOrDefault() { return Library.IsThere(this) ? (T)(object)this : default(T); }
        public T GetValueOrDefault(T other) { return Library.IsThere(this) ? (T)(object)this : other; }
        public override string ToString() { return Library.IsThere(this) ? ((object)this).ToString() : ""; }
        public override bool Equals(object other) { return Library.IsThere(this) ? other != null && ((object)this).Equals(other) : other == null; }
        public override int GetHashCode() { return Library.IsThere(this) ? ((object)this).GetHashCode() : 0; }
    }
    public static class Library
    {
        public static extern bool IsThere(object value);
        public static object Demand(object value)
        {
            if (!IsThere(value)) throw new InvalidOperationException("Nullable object must have a value.");
            return value;
        }
        public static extern bool IsPlain(object value);
        public static extern string Plain(object value, string format);
        public static extern int StructHash(object value);
        public static extern int PlainHash(object value);
        public static extern bool PlainEquals(object a, object b);
        public static extern int PlainCompare(object a, object b);
        public static string Text(object value)
        {
            return value == null ? "" : value.ToString();
        }
        public static string Text(object value, string format)
        {
            if (value == null) return "";
            if (format == null || format.Length == 0) return value.ToString();
            if (IsPlain(value)) return Plain(value, format);
            IFormattable own = value as IFormattable;
            return own != null ? own.ToString(format, null) : value.ToString();
        }
    }
    public struct Boolean : IComparable<bool>, IEquatable<bool>, IComparable
    {
        public const string TrueString = "True";
        public const string FalseString = "False";
        public override extern string ToString();
        public override extern bool Equals(object other);
        public override extern int GetHashCode();
        public extern bool Equals(bool other);
        public int CompareTo(bool other) { return this == other ? 0 : this ? 1 : -1; }
        public int CompareTo(object other) { return CompareTo((bool)other); }
        public static bool Parse(string text)
        {
            bool value;
            if (text == null) throw new ArgumentNullException("value");
            if (!TryParse(text, out value)) throw new FormatException("String was not recognized as a valid Boolean.");
            return value;
        }
        public static bool TryParse(string text, out bool value)
        {
            string clean = text == null ? "" : text.Trim();
            value = string.Equals(clean, "True", StringComparison.OrdinalIgnoreCase);
            return value || string.Equals(clean, "False", StringComparison.OrdinalIgnoreCase);
        }
    }
    public abstract class Array : IEnumerable, ICloneable
    {
        public extern int Length { get; }
        public long LongLength { get { return Length; } }
        public extern int Rank { get; }
        public extern int GetLength(int dimension);
        public int GetLowerBound(int dimension) { return 0; }
        public int GetUpperBound(int dimension) { return GetLength(dimension) - 1; }
        public extern object GetFlat(int index);
        public extern object Clone();
        public object GetValue(int index) { return GetFlat(index); }
        public extern void SetValue(object value, int index);
        public void CopyTo(Array to, int index) { Copy(this, 0, to, index, Length); }
        public IEnumerator GetEnumerator() { for (int i = 0; i < Length; i++) yield return GetFlat(i); }
        public static void Copy(Array from, Array to, int length) { Copy(from, 0, to, 0, length); }
        public static extern void Copy(Array from, int start, Array to, int at, int length);
        public static extern void Clear(Array array, int start, int length);
        public static extern void Resize<T>(ref T[] array, int length);
        public static extern void Reverse(Array array, int start, int length);
        public static void Reverse(Array array) { Reverse(array, 0, array.Length); }
        public static int IndexOf<T>(T[] array, T value)
        {
            for (int i = 0; i < array.Length; i++) if (EqualityComparer<T>.Same(array[i], value)) return i;
            return -1;
        }
        public static int LastIndexOf<T>(T[] array, T value)
        {
            for (int i = array.Length - 1; i >= 0; i--) if (EqualityComparer<T>.Same(array[i], value)) return i;
            return -1;
        }
        public static T[] Empty<T>() { return new T[0]; }
        public static T Find<T>(T[] array, Predicate<T> match) { foreach (T x in array) if (match(x)) return x; return default(T); }
        public static T[] FindAll<T>(T[] array, Predicate<T> match)
        {
            var found = new List<T>();
            foreach (T x in array) if (match(x)) found.Add(x);
            return found.ToArray();
        }
        public static int FindIndex<T>(T[] array, Predicate<T> match) { for (int i = 0; i < array.Length; i++) if (match(array[i])) return i; return -1; }
        public static bool Exists<T>(T[] array, Predicate<T> match) { foreach (T x in array) if (match(x)) return true; return false; }
        public static bool TrueForAll<T>(T[] array, Predicate<T> match) { foreach (T x in array) if (!match(x)) return false; return true; }
        public static void ForEach<T>(T[] array, Action<T> action) { foreach (T x in array) action(x); }
        public static R[] ConvertAll<T, R>(T[] array, Converter<T, R> convert)
        {
            R[] made = new R[array.Length];
            for (int i = 0; i < array.Length; i++) made[i] = convert(array[i]);
            return made;
        }
        public static void Sort<T>(T[] array) { Sorter<T>.Sort(array, 0, array.Length, null); }
        public static void Sort<T>(T[] array, Comparison<T> compare) { Sorter<T>.Sort(array, 0, array.Length, compare); }
        public static void Sort<T>(T[] array, IComparer<T> comparer) { Sorter<T>.Sort(array, 0, array.Length, comparer == null ? null : new Comparison<T>(comparer.Compare)); }
        public static void Sort<T>(T[] array, int start, int length) { Sorter<T>.Sort(array, start, length, null); }
        public static void Sort<K, V>(K[] keys, V[] values) { Sorter<K>.SortWith(keys, values); }
        public static int BinarySearch<T>(T[] array, T value)
        {
            int low = 0, high = array.Length - 1;
            while (low <= high)
            {
                int middle = low + (high - low) / 2;
                int order = Comparer<T>.Order(array[middle], value);
                if (order == 0) return middle;
                if (order < 0) low = middle + 1; else high = middle - 1;
            }
            return ~low;
        }
    }
    // What an array of one dimension has as a collection: its methods run with the array as the object.
    [Native] public class ArrayImpl<T> : IList<T>, IReadOnlyList<T>
    {
        public int Count { get { return __Length(); } }
        public extern int __Length();
        public extern T __Get(int index);
        public extern void __Set(int index, T value);
        public T this[int index] { get { return __Get(index); } set { __Set(index, value); } }
        public bool IsReadOnly { get { return true; } }
        public IEnumerator<T> GetEnumerator() { int n = __Length(); for (int i = 0; i < n; i++) yield return __Get(i); }
        public int IndexOf(T item) { for (int i = 0; i < __Length(); i++) if (EqualityComparer<T>.Same(__Get(i), item)) return i; return -1; }
        public bool Contains(T item) { return IndexOf(item) >= 0; }
        public void CopyTo(T[] to, int at) { for (int i = 0; i < __Length(); i++) to[at + i] = __Get(i); }
        public void Add(T item) { throw new NotSupportedException("Collection was of a fixed size."); }
        public bool Remove(T item) { throw new NotSupportedException("Collection was of a fixed size."); }
        public void Clear() { throw new NotSupportedException("Collection is read-only."); }
        public void Insert(int index, T item) { throw new NotSupportedException("Collection was of a fixed size."); }
        public void RemoveAt(int index) { throw new NotSupportedException("Collection was of a fixed size."); }
        IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }
    }
    [Native] public class Iterator<T> : IEnumerable<T>, IEnumerator<T>
    {
        public extern bool MoveNext();
        public extern void Dispose();
        public extern T Current { get; }
        object IEnumerator.Current { get { return Current; } }
        public extern IEnumerator<T> GetEnumerator();
        IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }
        public void Reset() { throw new NotSupportedException(); }
    }
    public static class Sorter<T>
    {
        static bool Before(T a, T b, Comparison<T> compare) { return compare == null ? Comparer<T>.Order(a, b) < 0 : compare(a, b) < 0; }
        static void Swap(T[] a, int i, int j) { T kept = a[i]; a[i] = a[j]; a[j] = kept; }
        static void SwapIfGreater(T[] a, Comparison<T> c, int i, int j) { if (i != j && Before(a[j], a[i], c)) Swap(a, i, j); }
        public static void Sort(T[] a, int start, int length, Comparison<T> compare)
        {
            if (length < 2) return;
            if (compare == null && Plain(a, start, length)) return;
            int depth = 0;
            for (int n = length; n > 0; n >>= 1) depth++;
            Intro(a, start, start + length - 1, 2 * (depth - 1) + 2, compare);
        }
        static extern bool Plain(T[] a, int start, int length);
        static void Intro(T[] a, int low, int high, int depth, Comparison<T> c)
        {
            while (high > low)
            {
                int size = high - low + 1;
                if (size <= 16)
                {
                    if (size == 2) { SwapIfGreater(a, c, low, high); return; }
                    if (size == 3)
                    {
                        SwapIfGreater(a, c, low, high - 1);
                        SwapIfGreater(a, c, low, high);
                        SwapIfGreater(a, c, high - 1, high);
                        return;
                    }
                    Insertion(a, low, high, c);
                    return;
                }
                if (depth == 0) { Heap(a, low, high, c); return; }
                depth--;
                int p = Partition(a, low, high, c);
                Intro(a, p + 1, high, depth, c);
                high = p - 1;
            }
        }
        static int Partition(T[] a, int low, int high, Comparison<T> c)
        {
            int middle = low + (high - low) / 2;
            SwapIfGreater(a, c, low, middle);
            SwapIfGreater(a, c, low, high);
            SwapIfGreater(a, c, middle, high);
            T pivot = a[middle];
            Swap(a, middle, high - 1);
            int left = low, right = high - 1;
            while (left < right)
            {
                while (Before(a[++left], pivot, c)) ;
                while (Before(pivot, a[--right], c)) ;
                if (left >= right) break;
                Swap(a, left, right);
            }
            Swap(a, left, high - 1);
            return left;
        }
        static void Insertion(T[] a, int low, int high, Comparison<T> c)
        {
            for (int i = low; i < high; i++)
            {
                int j = i;
                T t = a[i + 1];
                while (j >= low && Before(t, a[j], c)) { a[j + 1] = a[j]; j--; }
                a[j + 1] = t;
            }
        }
        static void Heap(T[] a, int low, int high, Comparison<T> c)
        {
            int n = high - low + 1;
            for (int i = n / 2; i >= 1; i--) Down(a, i, n, low, c);
            for (int i = n; i > 1; i--) { Swap(a, low, low + i - 1); Down(a, 1, i - 1, low, c); }
        }
        static void Down(T[] a, int i, int n, int low, Comparison<T> c)
        {
            T d = a[low + i - 1];
            while (i <= n / 2)
            {
                int child = 2 * i;
                if (child < n && Before(a[low + child - 1], a[low + child], c)) child++;
                if (!Before(d, a[low + child - 1], c)) break;
                a[low + i - 1] = a[low + child - 1];
                i = child;
            }
            a[low + i - 1] = d;
        }
        public static void SortWith<V>(T[] keys, V[] values)
        {
            for (int i = 1; i < keys.Length; i++)
            {
                T k = keys[i]; V v = values[i]; int j = i - 1;
                while (j >= 0 && Comparer<T>.Order(k, keys[j]) < 0) { keys[j + 1] = keys[j]; values[j + 1] = values[j]; j--; }
                keys[j + 1] = k; values[j + 1] = v;
            }
        }
    }
    public delegate void Action();
    public delegate void Action<A>(A a);
    public delegate void Action<A, B>(A a, B b);
    public delegate void Action<A, B, C>(A a, B b, C c);
    public delegate void Action<A, B, C, D>(A a, B b, C c, D d);
    public delegate void Action<A, B, C, D, E>(A a, B b, C c, D d, E e);
    public delegate void Action<A, B, C, D, E, F>(A a, B b, C c, D d, E e, F f);
    public delegate void Action<A, B, C, D, E, F, G>(A a, B b, C c, D d, E e, F f, G g);
    public delegate void Action<A, B, C, D, E, F, G, H>(A a, B b, C c, D d, E e, F f, G g, H h);
    public delegate R Func<R>();
    public delegate R Func<A, R>(A a);
    public delegate R Func<A, B, R>(A a, B b);
    public delegate R Func<A, B, C, R>(A a, B b, C c);
    public delegate R Func<A, B, C, D, R>(A a, B b, C c, D d);
    public delegate R Func<A, B, C, D, E, R>(A a, B b, C c, D d, E e);
    public delegate R Func<A, B, C, D, E, F, R>(A a, B b, C c, D d, E e, F f);
    public delegate R Func<A, B, C, D, E, F, G, R>(A a, B b, C c, D d, E e, F f, G g);
    public delegate R Func<A, B, C, D, E, F, G, H, R>(A a, B b, C c, D d, E e, F f, G g, H h);
    public delegate bool Predicate<T>(T item);
    public delegate int Comparison<T>(T a, T b);
    public delegate R Converter<T, R>(T item);
    public class Exception
    {
        private string _message;
        public Exception InnerException { get; private set; }
        public Exception() { }
        public Exception(string message) { _message = message; }
        public Exception(string message, Exception inner) { _message = message; InnerException = inner; }
        public virtual string Message { get { return _message != null ? _message : "Exception of type '" + GetType().FullName + "' was thrown."; } }
        public string StackTrace { get { return ""; } }
        public string Source { get; set; }
        public Exception GetBaseException() { Exception e = this; while (e.InnerException != null) e = e.InnerException; return e; }
        public override string ToString() { string m = Message; string own = GetType().FullName + (m == "" ? "" : ": " + m); return InnerException == null ? own : own + " ---> " + InnerException; }
    }
    public class SystemException : Exception { public SystemException() : base("System error.") { } public SystemException(string m) : base(m) { } public SystemException(string m, Exception i) : base(m, i) { } }
    public class ApplicationException : Exception { public ApplicationException() : base("Error in the application.") { } public ApplicationException(string m) : base(m) { } public ApplicationException(string m, Exception i) : base(m, i) { } }
    public class ArgumentException : SystemException
    {
        public virtual string ParamName { get; private set; }
        public ArgumentException() : base("Value does not fall within the expected range.") { }
        public ArgumentException(string m) : base(m) { }
        public ArgumentException(string m, Exception i) : base(m, i) { }
        public ArgumentException(string m, string p) : base(m) { ParamName = p; }
        public override string Message { get { return ParamName == null ? base.Message : base.Message + "\nParameter name: " + ParamName; } }
    }
    public class ArgumentNullException : ArgumentException { public ArgumentNullException() : base("Value cannot be null.") { } public ArgumentNullException(string p) : base("Value cannot be null.", p) { } public ArgumentNullException(string p, string m) : base(m, p) { } }
    public class ArgumentOutOfRangeException : ArgumentException { public ArgumentOutOfRangeException() : base("Specified argument was out of the range of valid values.") { } public ArgumentOutOfRangeException(string p) : base("Specified argument was out of the range of valid values.", p) { } public ArgumentOutOfRangeException(string p, string m) : base(m, p) { } }
    public class ArithmeticException : SystemException { public ArithmeticException() : base("Overflow or underflow in the arithmetic operation.") { } public ArithmeticException(string m) : base(m) { } }
    public class DivideByZeroException : ArithmeticException { public DivideByZeroException() : base("Attempted to divide by zero.") { } public DivideByZeroException(string m) : base(m) { } }
    public class OverflowException : ArithmeticException { public OverflowException() : base("Arithmetic operation resulted in an overflow.") { } public OverflowException(string m) : base(m) { } }
    public class IndexOutOfRangeException : SystemException { public IndexOutOfRangeException() : base("Index was outside the bounds of the array.") { } public IndexOutOfRangeException(string m) : base(m) { } }
    public class InvalidCastException : SystemException { public InvalidCastException() : base("Specified cast is not valid.") { } public InvalidCastException(string m) : base(m) { } }
    public class ArrayTypeMismatchException : SystemException { public ArrayTypeMismatchException() : base("Attempted to access an element as a type incompatible with the array.") { } public ArrayTypeMismatchException(string m) : base(m) { } }
    public class InvalidOperationException : SystemException { public InvalidOperationException() : base("Operation is not valid due to the current state of the object.") { } public InvalidOperationException(string m) : base(m) { } public InvalidOperationException(string m, Exception i) : base(m, i) { } }
    public class NotImplementedException : SystemException { public NotImplementedException() : base("The method or operation is not implemented.") { } public NotImplementedException(string m) : base(m) { } }
    public class NotSupportedException : SystemException { public NotSupportedException() : base("Specified method is not supported.") { } public NotSupportedException(string m) : base(m) { } }
    public class NullReferenceException : SystemException { public NullReferenceException() : base("Object reference not set to an instance of an object.") { } public NullReferenceException(string m) : base(m) { } }
    public class FormatException : SystemException { public FormatException() : base("One of the identified items was in an invalid format.") { } public FormatException(string m) : base(m) { } }
    public class SwitchExpressionException : InvalidOperationException { public SwitchExpressionException() : base("Non-exhaustive switch expression failed to match its input.") { } }
    public class RuntimeBinderException : Exception { public RuntimeBinderException() { } public RuntimeBinderException(string m) : base(m) { } }
    public class TimeoutException : SystemException { public TimeoutException() { } public TimeoutException(string m) : base(m) { } }
}
namespace System.Globalization
{
    public class CultureInfo : System.IFormatProvider
    {
        public static CultureInfo InvariantCulture { get { return new CultureInfo(); } }
        public static CultureInfo CurrentCulture { get { return new CultureInfo(); } }
        public CultureInfo() { }
        public CultureInfo(string name) { }
    }
    [System.Flags] public enum NumberStyles { None = 0, Integer = 7, Float = 167, Number = 111, Any = 511, HexNumber = 515, AllowDecimalPoint = 32, AllowExponent = 128, AllowThousands = 64, AllowLeadingSign = 4, AllowLeadingWhite = 1, AllowTrailingWhite = 2 }
}
namespace System.Collections
{
    public interface IEnumerable { IEnumerator GetEnumerator(); }
    public interface IEnumerator { object Current { get; } bool MoveNext(); void Reset(); }
    public interface ICollection : IEnumerable { int Count { get; } }
    public interface IList : ICollection
    {
        object this[int index] { get; set; }
        int Add(object item);
        void Clear();
        bool Contains(object item);
        int IndexOf(object item);
        void Insert(int index, object item);
        void Remove(object item);
        void RemoveAt(int index);
    }
    public class ArrayList : IList
    {
        private List<object> items = new List<object>();
        public ArrayList() { }
        public ArrayList(int capacity) { }
        public ArrayList(IEnumerable source) { AddRange(source); }
        public int Count { get { return items.Count; } }
        public object this[int index] { get { return items[index]; } set { items[index] = value; } }
        public int Add(object item) { items.Add(item); return items.Count - 1; }
        public void AddRange(IEnumerable source) { foreach (object x in source) items.Add(x); }
        public void Clear() { items.Clear(); }
        public bool Contains(object item) { return items.Contains(item); }
        public int IndexOf(object item) { return items.IndexOf(item); }
        public void Insert(int index, object item) { items.Insert(index, item); }
        public void Remove(object item) { items.Remove(item); }
        public void RemoveAt(int index) { items.RemoveAt(index); }
        public void Reverse() { items.Reverse(); }
        public void Sort() { items.Sort(); }
        public object[] ToArray() { return items.ToArray(); }
        public IEnumerator GetEnumerator() { return items.GetEnumerator(); }
    }
}
