// Texts.
using System.Collections;
using System.Collections.Generic;

namespace System
{
    public enum StringComparison { CurrentCulture, CurrentCultureIgnoreCase, InvariantCulture, InvariantCultureIgnoreCase, Ordinal, OrdinalIgnoreCase }
    [Flags] public enum StringSplitOptions { None = 0, RemoveEmptyEntries = 1 }
    [Native] public sealed class String : IComparable<string>, IEquatable<string>, IComparable, IEnumerable<char>, ICloneable
    {
        public static readonly string Empty = "";
        public extern String(char[] units);
        public extern String(char unit, int count);
        public extern String(char[] units, int start, int length);
        public extern int Length { get; }
        public extern char this[int index] { get; }
        public override string ToString() { return this; }
        public object Clone() { return this; }
        public override bool Equals(object other) { string s = other as string; return s != null && Same(this, s); }
        public bool Equals(string other) { return other != null && Same(this, other); }
        public bool Equals(string other, StringComparison how) { return Equals(this, other, how); }
        public static bool Equals(string a, string b) { return Same(a, b); }
        public static bool Equals(string a, string b, StringComparison how) { return a == null || b == null ? a == null && b == null : Compare(a, b, how) == 0; }
        public override extern int GetHashCode();
        static extern bool Same(string a, string b);
        public static extern bool operator ==(string a, string b);
        public static extern bool operator !=(string a, string b);
        static extern int CultureOrder(string a, string b, bool ignoreCase);
        public static extern int CompareOrdinal(string a, string b);
        public int CompareTo(string other) { return CultureOrder(this, other, false); }
        public int CompareTo(object other) { return CultureOrder(this, (string)other, false); }
        public static int Compare(string a, string b) { return CultureOrder(a, b, false); }
        public static int Compare(string a, string b, bool ignoreCase) { return CultureOrder(a, b, ignoreCase); }
        public static int Compare(string a, string b, StringComparison how)
        {
            switch (how)
            {
                case StringComparison.Ordinal: return CompareOrdinal(a, b);
                case StringComparison.OrdinalIgnoreCase: return CompareOrdinal(a == null ? null : a.ToUpper(), b == null ? null : b.ToUpper());
                case StringComparison.CurrentCultureIgnoreCase: case StringComparison.InvariantCultureIgnoreCase: return CultureOrder(a, b, true);
                default: return CultureOrder(a, b, false);
            }
        }
        static string Part(string s, int start, int length) { return s == null ? null : s.Substring(start, Math.Min(length, s.Length - start)); }
        public static int Compare(string a, int i, string b, int j, int length) { return Compare(Part(a, i, length), Part(b, j, length)); }
        public static int Compare(string a, int i, string b, int j, int length, bool ignoreCase) { return Compare(Part(a, i, length), Part(b, j, length), ignoreCase); }
        public static int Compare(string a, int i, string b, int j, int length, StringComparison how) { return Compare(Part(a, i, length), Part(b, j, length), how); }
        public static int CompareOrdinal(string a, int i, string b, int j, int length) { return CompareOrdinal(Part(a, i, length), Part(b, j, length)); }
        public IEnumerator<char> GetEnumerator() { for (int i = 0; i < Length; i++) yield return this[i]; }
        IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }
        public static bool IsNullOrEmpty(string s) { return s == null || s.Length == 0; }
        public static bool IsNullOrWhiteSpace(string s) { return s == null || s.Trim().Length == 0; }
        public extern string Substring(int start);
        public extern string Substring(int start, int length);
        public extern string ToUpper();
        public extern string ToLower();
        public string ToUpperInvariant() { return ToUpper(); }
        public string ToLowerInvariant() { return ToLower(); }
        public extern string Trim();
        public extern string TrimStart();
        public extern string TrimEnd();
        public string Trim(params char[] c) { return TrimStart(c).TrimEnd(c); }
        public string TrimStart(params char[] c) { if (c == null || c.Length == 0) return TrimStart(); int i = 0; while (i < Length && Array.IndexOf(c, this[i]) >= 0) i++; return Substring(i); }
        public string TrimEnd(params char[] c) { if (c == null || c.Length == 0) return TrimEnd(); int n = Length; while (n > 0 && Array.IndexOf(c, this[n - 1]) >= 0) n--; return Substring(0, n); }
        static extern int Find(string text, string part, int start, int count, bool last);
        public int IndexOf(string part) { return IndexOf(part, 0); }
        public int IndexOf(string part, int start) { if (part == null) throw new ArgumentNullException("value"); if (start < 0 || start > Length) throw new ArgumentOutOfRangeException("startIndex", "Index was out of range. Must be non-negative and less than the size of the collection."); return Find(this, part, start, Length - start, false); }
        public int IndexOf(string part, StringComparison how) { return how == StringComparison.OrdinalIgnoreCase || how == StringComparison.CurrentCultureIgnoreCase || how == StringComparison.InvariantCultureIgnoreCase ? ToUpper().IndexOf(part.ToUpper()) : IndexOf(part); }
        public int IndexOf(char c) { return IndexOf(c, 0); }
        public int IndexOf(char c, int start) { for (int i = start; i < Length; i++) if (this[i] == c) return i; return -1; }
        public int IndexOf(char c, int start, int count) { for (int i = start; i < start + count; i++) if (this[i] == c) return i; return -1; }
        public int IndexOf(string part, int start, int count) { int i = Substring(start, count).IndexOf(part); return i < 0 ? -1 : start + i; }
        public int IndexOf(string part, int start, StringComparison how) { int i = Substring(start).IndexOf(part, how); return i < 0 ? -1 : start + i; }
        public int LastIndexOf(char c, int start) { for (int i = start; i >= 0; i--) if (this[i] == c) return i; return -1; }
        public int LastIndexOf(string part, int start) { return Substring(0, Math.Min(Length, start + 1)).LastIndexOf(part); }
        public int LastIndexOfAny(char[] any) { for (int i = Length - 1; i >= 0; i--) if (Array.IndexOf(any, this[i]) >= 0) return i; return -1; }
        public bool Contains(string part, StringComparison how) { return IndexOf(part, how) >= 0; }
        public bool StartsWith(char c) { return Length > 0 && this[0] == c; }
        public bool EndsWith(char c) { return Length > 0 && this[Length - 1] == c; }
        public int LastIndexOf(char c) { for (int i = Length - 1; i >= 0; i--) if (this[i] == c) return i; return -1; }
        public int LastIndexOf(string part) { if (part == null) throw new ArgumentNullException("value"); return Find(this, part, 0, Length, true); }
        public int IndexOfAny(char[] any) { for (int i = 0; i < Length; i++) if (Array.IndexOf(any, this[i]) >= 0) return i; return -1; }
        public bool Contains(string part) { return IndexOf(part) >= 0; }
        public bool Contains(char c) { return IndexOf(c) >= 0; }
        public bool StartsWith(string part) { if (part == null) throw new ArgumentNullException("value"); return Length >= part.Length && Same(Substring(0, part.Length), part); }
        public bool StartsWith(string part, StringComparison how) { return Length >= part.Length && Compare(Substring(0, part.Length), part, how) == 0; }
        public bool EndsWith(string part) { if (part == null) throw new ArgumentNullException("value"); return Length >= part.Length && Same(Substring(Length - part.Length), part); }
        public bool EndsWith(string part, StringComparison how) { return Length >= part.Length && Compare(Substring(Length - part.Length), part, how) == 0; }
        public extern string Replace(string from, string to);
        public extern string Replace(char from, char to);
        public string Remove(int start) { if (start < 0) throw new ArgumentOutOfRangeException("startIndex", "StartIndex cannot be less than zero."); if (start >= Length) throw new ArgumentOutOfRangeException("startIndex", "startIndex must be less than length of string."); return Substring(0, start); }
        public string Remove(int start, int count) { return Substring(0, start) + Substring(start + count); }
        public string Insert(int at, string text) { if (text == null) throw new ArgumentNullException("value"); if (at < 0 || at > Length) throw new ArgumentOutOfRangeException("startIndex"); return Substring(0, at) + text + Substring(at); }
        public string PadLeft(int width) { return PadLeft(width, ' '); }
        public string PadLeft(int width, char c) { return width <= Length ? this : new string(c, width - Length) + this; }
        public string PadRight(int width) { return PadRight(width, ' '); }
        public string PadRight(int width, char c) { return width <= Length ? this : this + new string(c, width - Length); }
        public extern char[] ToCharArray();
        public char[] ToCharArray(int start, int length) { return Substring(start, length).ToCharArray(); }
        static extern string[] Cut(string text, string[] separators, int count, bool noEmpty);
        public string[] Split(params char[] c) { return Split(c, int.MaxValue, StringSplitOptions.None); }
        public string[] Split(char[] c, StringSplitOptions o) { return Split(c, int.MaxValue, o); }
        public string[] Split(char[] c, int count) { return Split(c, count, StringSplitOptions.None); }
        public string[] Split(char[] c, int count, StringSplitOptions o)
        {
            if (c == null || c.Length == 0) return Cut(this, null, count, o == StringSplitOptions.RemoveEmptyEntries);
            string[] s = new string[c.Length];
            for (int i = 0; i < c.Length; i++) s[i] = c[i].ToString();
            return Cut(this, s, count, o == StringSplitOptions.RemoveEmptyEntries);
        }
        public string[] Split(char c, StringSplitOptions o) { return Split(new char[] { c }, int.MaxValue, o); }
        public string[] Split(string s, StringSplitOptions o = StringSplitOptions.None) { return Split(new string[] { s }, int.MaxValue, o); }
        public string[] Split(string[] s, StringSplitOptions o) { return Cut(this, s, int.MaxValue, o == StringSplitOptions.RemoveEmptyEntries); }
        public string[] Split(string[] s, int count, StringSplitOptions o) { return Cut(this, s, count, o == StringSplitOptions.RemoveEmptyEntries); }
        static extern string Glue(string separator, string[] parts, int start, int count);
        public static string Join(string separator, params string[] parts) { return Glue(separator, parts, 0, parts.Length); }
        public static string Join(string separator, string[] parts, int start, int count) { return Glue(separator, parts, start, count); }
        public static string Join(char separator, params string[] parts) { return Glue(separator.ToString(), parts, 0, parts.Length); }
        public static string Join(char separator, params object[] parts) { return Join(separator.ToString(), parts); }
        public static string Join(string separator, params object[] parts) { return Glue(separator, Texts(parts), 0, parts.Length); }
        public static string Join<T>(string separator, IEnumerable<T> parts)
        {
            var all = new List<string>();
            foreach (T part in parts) all.Add(Library.Text(part));
            return Glue(separator, all.ToArray(), 0, all.Count);
        }
        public static string Concat(params object[] parts) { return Glue("", Texts(parts), 0, parts.Length); }
        public static string Concat(params string[] parts) { return Glue("", parts, 0, parts.Length); }
        public static string Concat<T>(IEnumerable<T> parts) { return Join<T>("", parts); }
        static string[] Texts(object[] parts) { string[] t = new string[parts.Length]; for (int i = 0; i < parts.Length; i++) t[i] = Library.Text(parts[i]); return t; }
        public static string Format(string format, params object[] args)
        {
            if (format == null || args == null) throw new ArgumentNullException(format == null ? "format" : "args");
            var made = new System.Text.StringBuilder();
            int i = 0;
            while (i < format.Length)
            {
                char c = format[i++];
                if (c == '{' || c == '}')
                {
                    if (i < format.Length && format[i] == c) { i++; made.Append(c); continue; }
                    if (c == '}') throw new FormatException("Input string was not in a correct format.");
                    int end = i;
                    while (end < format.Length && format[end] != '}') end++;
                    if (end >= format.Length) throw new FormatException("Input string was not in a correct format.");
                    string hole = format.Substring(i, end - i);
                    i = end + 1;
                    string form = null;
                    int colon = hole.IndexOf(':');
                    if (colon >= 0) { form = hole.Substring(colon + 1); hole = hole.Substring(0, colon); }
                    int width = 0;
                    int comma = hole.IndexOf(',');
                    if (comma >= 0) { if (!int.TryParse(hole.Substring(comma + 1), out width)) throw new FormatException("Input string was not in a correct format."); hole = hole.Substring(0, comma); }
                    int index;
                    if (!int.TryParse(hole, out index)) throw new FormatException("Input string was not in a correct format.");
                    if (index < 0 || index >= args.Length) throw new FormatException("Index (zero based) must be greater than or equal to zero and less than the size of the argument list.");
                    made.Append(__Piece(args[index], width, form));
                }
                else made.Append(c);
            }
            return made.ToString();
        }
        public static string Format(IFormatProvider provider, string format, params object[] args) { return Format(format, args); }
        public static string __Piece(object value, int width, string format)
        {
            string text = Library.Text(value, format);
            return width >= 0 ? text.PadLeft(width) : text.PadRight(-width);
        }
    }
    public class FlagsAttribute { }
    public static class Console
    {
        static extern void Print(string text);
        public static void Write(string s) { if (s != null) Print(s); }
        public static void Write(object o) { Print(Library.Text(o)); }
        public static void Write(bool x) { Print(x.ToString()); }
        public static void Write(char x) { Print(x.ToString()); }
        public static void Write(int x) { Print(x.ToString()); }
        public static void Write(long x) { Print(x.ToString()); }
        public static void Write(double x) { Print(x.ToString()); }
        public static void Write(string format, params object[] args) { Print(string.Format(format, args)); }
        public static void WriteLine() { Print("\n"); }
        public static void WriteLine(string s) { Print(s + "\n"); }
        public static void WriteLine(object o) { Print(Library.Text(o) + "\n"); }
        public static void WriteLine(bool x) { Print(x + "\n"); }
        public static void WriteLine(char x) { Print(x + "\n"); }
        public static void WriteLine(char[] x) { Print(new string(x) + "\n"); }
        public static void WriteLine(int x) { Print(x + "\n"); }
        public static void WriteLine(uint x) { Print(x + "\n"); }
        public static void WriteLine(long x) { Print(x + "\n"); }
        public static void WriteLine(ulong x) { Print(x + "\n"); }
        public static void WriteLine(float x) { Print(x + "\n"); }
        public static void WriteLine(double x) { Print(x + "\n"); }
        public static void WriteLine(string format, params object[] args) { Print(string.Format(format, args) + "\n"); }
    }
    public static class Environment { public static string NewLine { get { return "\n"; } } public static int ProcessorCount { get { return 1; } } }
    public static class GC { public static void Collect() { } }
    public static class Convert
    {
        public static string ToBase64String(byte[] bytes) { if (bytes == null) throw new ArgumentNullException("inArray"); return Base64.Text(bytes, 0, bytes.Length); }
        public static string ToBase64String(byte[] bytes, int offset, int length) { if (bytes == null) throw new ArgumentNullException("inArray"); if (length < 0) throw new ArgumentOutOfRangeException("length"); if (offset < 0 || offset > bytes.Length - length) throw new ArgumentOutOfRangeException("offset"); return Base64.Text(bytes, offset, length); }
        public static byte[] FromBase64String(string text) { if (text == null) throw new ArgumentNullException("s"); return Base64.Bytes(text); }
        public static int ToInt32(double x) { return checked((int)Math.Round(x)); }
        public static int ToInt32(bool x) { return x ? 1 : 0; }
        public static int ToInt32(int x) { return x; }
        public static int ToInt32(long x) { return checked((int)x); }
        public static int ToInt32(char x) { return x; }
        public static int ToInt32(string s) { return s == null ? 0 : int.Parse(s); }
        public static extern int ToInt32(string s, int radix);
        public static int ToInt32(uint x) { return checked((int)x); }
        public static int ToInt32(ulong x) { return checked((int)x); }
        public static int ToInt32(decimal x) { return (int)decimal.Round(x); }
        public static int ToInt32(object o) { if (o == null) return 0; if (o is decimal) return ToInt32((decimal)o); if (o is double) return ToInt32((double)o); if (o is bool) return ToInt32((bool)o); if (o is long) return ToInt32((long)o); if (o is string) return ToInt32((string)o); if (o is char) return (char)o; if (o is float) return ToInt32((double)(float)o); if (o is byte) return (byte)o; if (o is Enum) return Library.PlainHash(o); return (int)o; }
        public static long ToInt64(object o) { if (o == null) return 0; if (o is decimal) return (long)decimal.Round((decimal)o); if (o is double) return checked((long)Math.Round((double)o)); if (o is string) return long.Parse((string)o); if (o is long) return (long)o; return ToInt32(o); }
        public static byte ToByte(object o)
        {
            int n = ToInt32(o);
            if (n < 0 || n > 255) throw new OverflowException("Value was either too large or too small for an unsigned byte.");
            return (byte)n;
        }
        public static decimal ToDecimal(object o)
        {
            if (o == null) return 0;
            if (o is decimal) return (decimal)o;
            if (o is int) return (int)o;
            if (o is double) return (decimal)(double)o;
            if (o is float) return (decimal)(float)o;
            if (o is string) return decimal.Parse((string)o);
            if (o is bool) return (bool)o ? 1 : 0;
            if (o is long) return (long)o;
            if (o is ulong) return (ulong)o;
            if (o is uint) return (uint)o;
            if (o is DateTime || o is char) throw new InvalidCastException();
            return ToInt32(o);
        }
        public static double ToDouble(object o) { if (o == null) return 0; if (o is decimal) return (double)(decimal)o; if (o is double) return (double)o; if (o is float) return (float)o; if (o is string) return double.Parse((string)o); if (o is long) return (long)o; return ToInt32(o); }
        public static float ToSingle(object o) { return (float)ToDouble(o); }
        public static bool ToBoolean(object o) { if (o == null) return false; if (o is bool) return (bool)o; if (o is string) return bool.Parse((string)o); return ToDouble(o) != 0; }
        public static char ToChar(int x) { return checked((char)x); }
        public static string ToString(object o) { return Library.Text(o); }
        public static extern string ToString(int x, int radix);
        public static object ChangeType(object o, Type type) { if (type == typeof(int)) return ToInt32(o); if (type == typeof(double)) return ToDouble(o); if (type == typeof(string)) return ToString(o); if (type == typeof(bool)) return ToBoolean(o); if (type == typeof(decimal)) return ToDecimal(o); throw new InvalidCastException(); }
    }
    public class Random
    {
        private int[] seeds = new int[56];
        private int a, b;
        public Random() : this(Library2.Seed()) { }
        public Random(int seed)
        {
            int j = 161803398 - (seed == int.MinValue ? int.MaxValue : Math.Abs(seed));
            seeds[55] = j;
            int k = 1;
            for (int i = 1; i < 55; i++)
            {
                int at = 21 * i % 55;
                seeds[at] = k;
                k = j - k;
                if (k < 0) k += int.MaxValue;
                j = seeds[at];
            }
            for (int n = 1; n < 5; n++)
                for (int i = 1; i < 56; i++)
                {
                    seeds[i] -= seeds[1 + (i + 30) % 55];
                    if (seeds[i] < 0) seeds[i] += int.MaxValue;
                }
            a = 0;
            b = 21;
        }
        int Draw()
        {
            if (++a >= 56) a = 1;
            if (++b >= 56) b = 1;
            int r = seeds[a] - seeds[b];
            if (r == int.MaxValue) r--;
            if (r < 0) r += int.MaxValue;
            seeds[a] = r;
            return r;
        }
        protected virtual double Sample() { return Draw() * (1.0 / int.MaxValue); }
        public virtual int Next() { return Draw(); }
        public virtual int Next(int max) { if (max < 0) throw new ArgumentOutOfRangeException("maxValue", "'maxValue' must be greater than zero."); return (int)(Sample() * max); }
        public virtual int Next(int min, int max)
        {
            if (min > max) throw new ArgumentOutOfRangeException("minValue", "'minValue' cannot be greater than maxValue.");
            long range = (long)max - min;
            if (range <= int.MaxValue) return (int)(Sample() * range) + min;
            int r = Draw();
            if (Draw() % 2 == 0) r = -r;
            double d = (r + (double)(int.MaxValue - 1)) / (2 * (uint)int.MaxValue - 1);
            return (int)((long)(d * range) + min);
        }
        public virtual double NextDouble() { return Sample(); }
        public virtual void NextBytes(byte[] to) { for (int i = 0; i < to.Length; i++) to[i] = (byte)(Draw() % 256); }
    }
    static class Library2 { static int next = 0; public static int Seed() { return 20230517 + next++; } }
}
namespace System.Text
{
    [Native] public sealed class StringBuilder
    {
        public extern StringBuilder();
        public extern StringBuilder(string text);
        public extern StringBuilder(int capacity);
        public StringBuilder(string text, int capacity) { Put(text); }
        public StringBuilder(int capacity, int most) { }
        public int Capacity { get { return Math.Max(16, Length); } set { } }
        public bool Equals(StringBuilder other) { return other != null && ToString() == other.ToString(); }
        public extern int Length { get; set; }
        public extern char this[int index] { get; set; }
        public override extern string ToString();
        public string ToString(int start, int length) { return ToString().Substring(start, length); }
        extern void Put(string text);
        public extern StringBuilder Append(string s);
        public StringBuilder Append(object o) { Put(Library.Text(o)); return this; }
        public extern StringBuilder Append(char c);
        public StringBuilder Append(char c, int n) { Put(new string(c, n)); return this; }
        public extern StringBuilder Append(int x);
        public StringBuilder Append(double x) { Put(x.ToString()); return this; }
        public StringBuilder Append(bool x) { Put(x.ToString()); return this; }
        public StringBuilder Append(string s, int start, int count) { if (s != null) Put(s.Substring(start, count)); return this; }
        public StringBuilder Append(char[] c) { if (c != null) Put(new string(c)); return this; }
        public StringBuilder Append(char[] c, int start, int count) { Put(new string(c, start, count)); return this; }
        public StringBuilder Append(float x) { Put(x.ToString()); return this; }
        public StringBuilder Append(long x) { Put(x.ToString()); return this; }
        public StringBuilder AppendJoin<T>(string separator, IEnumerable<T> parts) { Put(string.Join(separator, parts)); return this; }
        public StringBuilder AppendLine() { Put("\n"); return this; }
        public StringBuilder AppendLine(string s) { Put(s); Put("\n"); return this; }
        public StringBuilder AppendFormat(string f, params object[] args) { Put(string.Format(f, args)); return this; }
        public extern StringBuilder Insert(int at, string s);
        public StringBuilder Insert(int at, object o) { return Insert(at, Library.Text(o)); }
        public StringBuilder Replace(string a, string b, int start, int count)
        {
            string all = ToString(), changed = all.Substring(start, count).Replace(a, b);
            Clear(); Put(all.Substring(0, start)); Put(changed); Put(all.Substring(start + count));
            return this;
        }
        public void CopyTo(int start, char[] to, int at, int count) { for (int i = 0; i < count; i++) to[at + i] = this[start + i]; }
        public extern StringBuilder Remove(int start, int length);
        public extern StringBuilder Replace(string a, string b);
        public StringBuilder Replace(char a, char b) { return Replace(a.ToString(), b.ToString()); }
        public StringBuilder Clear() { Length = 0; return this; }
    }
}
namespace System.Threading.Tasks
{
    public static class Parallel
    {
        public static void For(int from, int to, System.Action<int> body) { for (int i = from; i < to; i++) body(i); }
        public static void ForEach<T>(IEnumerable<T> source, System.Action<T> body) { foreach (T x in source) body(x); }
        public static void Invoke(params System.Action[] actions) { foreach (System.Action a in actions) a(); }
    }
}
