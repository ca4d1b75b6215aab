// Numbers and characters.
using System.Globalization;

namespace System
{
    public struct SByte : IComparable<sbyte>, IEquatable<sbyte>, IComparable, IFormattable
    {
        public const sbyte MinValue = -128;
        public const sbyte MaxValue = 127;
        public override extern string ToString();
        public extern string ToString(string format);
        public string ToString(IFormatProvider provider) { return ToString(); }
        public string ToString(string format, IFormatProvider provider) { return ToString(format); }
        public override extern bool Equals(object other);
        public override extern int GetHashCode();
        public bool Equals(sbyte other) { return this == other; }
        public int CompareTo(sbyte other) { return this < other ? -1 : this > other ? 1 : 0; }
        public int CompareTo(object other) { return CompareTo((sbyte)other); }
        public static extern sbyte Parse(string text);
        public static sbyte Parse(string text, IFormatProvider provider) { return Parse(text); }
        public static extern bool TryParse(string text, out sbyte value);
        public static bool TryParse(string text, NumberStyles styles, IFormatProvider provider, out sbyte value) { return TryParse(text, out value); }
    }
    public struct Byte : IComparable<byte>, IEquatable<byte>, IComparable, IFormattable
    {
        public const byte MinValue = 0;
        public const byte MaxValue = 255;
        public override extern string ToString();
        public extern string ToString(string format);
        public string ToString(IFormatProvider provider) { return ToString(); }
        public string ToString(string format, IFormatProvider provider) { return ToString(format); }
        public override extern bool Equals(object other);
        public override extern int GetHashCode();
        public bool Equals(byte other) { return this == other; }
        public int CompareTo(byte other) { return this < other ? -1 : this > other ? 1 : 0; }
        public int CompareTo(object other) { return CompareTo((byte)other); }
        public static extern byte Parse(string text);
        public static byte Parse(string text, IFormatProvider provider) { return Parse(text); }
        public static extern bool TryParse(string text, out byte value);
        public static bool TryParse(string text, NumberStyles styles, IFormatProvider provider, out byte value) { return TryParse(text, out value); }
    }
    public struct Int16 : IComparable<short>, IEquatable<short>, IComparable, IFormattable
    {
        public const short MinValue = -32768;
        public const short MaxValue = 32767;
        public override extern string ToString();
        public extern string ToString(string format);
        public string ToString(IFormatProvider provider) { return ToString(); }
        public string ToString(string format, IFormatProvider provider) { return ToString(format); }
        public override extern bool Equals(object other);
        public override extern int GetHashCode();
        public bool Equals(short other) { return this == other; }
        public int CompareTo(short other) { return this < other ? -1 : this > other ? 1 : 0; }
        public int CompareTo(object other) { return CompareTo((short)other); }
        public static extern short Parse(string text);
        public static short Parse(string text, IFormatProvider provider) { return Parse(text); }
        public static extern bool TryParse(string text, out short value);
        public static bool TryParse(string text, NumberStyles styles, IFormatProvider provider, out short value) { return TryParse(text, out value); }
    }
    public struct UInt16 : IComparable<ushort>, IEquatable<ushort>, IComparable, IFormattable
    {
        public const ushort MinValue = 0;
        public const ushort MaxValue = 65535;
        public override extern string ToString();
        public extern string ToString(string format);
        public string ToString(IFormatProvider provider) { return ToString(); }
        public string ToString(string format, IFormatProvider provider) { return ToString(format); }
        public override extern bool Equals(object other);
        public override extern int GetHashCode();
        public bool Equals(ushort other) { return this == other; }
        public int CompareTo(ushort other) { return this < other ? -1 : this > other ? 1 : 0; }
        public int CompareTo(object other) { return CompareTo((ushort)other); }
        public static extern ushort Parse(string text);
        public static ushort Parse(string text, IFormatProvider provider) { return Parse(text); }
        public static extern bool TryParse(string text, out ushort value);
        public static bool TryParse(string text, NumberStyles styles, IFormatProvider provider, out ushort value) { return TryParse(text, out value); }
    }
    public struct Int32 : IComparable<int>, IEquatable<int>, IComparable, IFormattable
    {
        public const int MinValue = -2147483648;
        public const int MaxValue = 2147483647;
        public override extern string ToString();
        public extern string ToString(string format);
        public string ToString(IFormatProvider provider) { return ToString(); }
        public string ToString(string format, IFormatProvider provider) { return ToString(format); }
        public override extern bool Equals(object other);
        public override extern int GetHashCode();
        public bool Equals(int other) { return this == other; }
        public int CompareTo(int other) { return this < other ? -1 : this > other ? 1 : 0; }
        public int CompareTo(object other) { return CompareTo((int)other); }
        public static extern int Parse(string text);
        public static int Parse(string text, IFormatProvider provider) { return Parse(text); }
        public static extern bool TryParse(string text, out int value);
        public static bool TryParse(string text, NumberStyles styles, IFormatProvider provider, out int value) { return TryParse(text, out value); }
    }
    public struct UInt32 : IComparable<uint>, IEquatable<uint>, IComparable, IFormattable
    {
        public const uint MinValue = 0;
        public const uint MaxValue = 4294967295;
        public override extern string ToString();
        public extern string ToString(string format);
        public string ToString(IFormatProvider provider) { return ToString(); }
        public string ToString(string format, IFormatProvider provider) { return ToString(format); }
        public override extern bool Equals(object other);
        public override extern int GetHashCode();
        public bool Equals(uint other) { return this == other; }
        public int CompareTo(uint other) { return this < other ? -1 : this > other ? 1 : 0; }
        public int CompareTo(object other) { return CompareTo((uint)other); }
        public static extern uint Parse(string text);
        public static uint Parse(string text, IFormatProvider provider) { return Parse(text); }
        public static extern bool TryParse(string text, out uint value);
        public static bool TryParse(string text, NumberStyles styles, IFormatProvider provider, out uint value) { return TryParse(text, out value); }
    }
    public struct Int64 : IComparable<long>, IEquatable<long>, IComparable, IFormattable
    {
        public const long MinValue = -9223372036854775808;
        public const long MaxValue = 9223372036854775807;
        public override extern string ToString();
        public extern string ToString(string format);
        public string ToString(IFormatProvider provider) { return ToString(); }
        public string ToString(string format, IFormatProvider provider) { return ToString(format); }
        public override extern bool Equals(object other);
        public override extern int GetHashCode();
        public bool Equals(long other) { return this == other; }
        public int CompareTo(long other) { return this < other ? -1 : this > other ? 1 : 0; }
        public int CompareTo(object other) { return CompareTo((long)other); }
        public static extern long Parse(string text);
        public static long Parse(string text, IFormatProvider provider) { return Parse(text); }
        public static extern bool TryParse(string text, out long value);
        public static bool TryParse(string text, NumberStyles styles, IFormatProvider provider, out long value) { return TryParse(text, out value); }
    }
    public struct UInt64 : IComparable<ulong>, IEquatable<ulong>, IComparable, IFormattable
    {
        public const ulong MinValue = 0;
        public const ulong MaxValue = 18446744073709551615;
        public override extern string ToString();
        public extern string ToString(string format);
        public string ToString(IFormatProvider provider) { return ToString(); }
        public string ToString(string format, IFormatProvider provider) { return ToString(format); }
        public override extern bool Equals(object other);
        public override extern int GetHashCode();
        public bool Equals(ulong other) { return this == other; }
        public int CompareTo(ulong other) { return this < other ? -1 : this > other ? 1 : 0; }
        public int CompareTo(object other) { return CompareTo((ulong)other); }
        public static extern ulong Parse(string text);
        public static ulong Parse(string text, IFormatProvider provider) { return Parse(text); }
        public static extern bool TryParse(string text, out ulong value);
        public static bool TryParse(string text, NumberStyles styles, IFormatProvider provider, out ulong value) { return TryParse(text, out value); }
    }
    public struct Single : IComparable<float>, IEquatable<float>, IComparable, IFormattable
    {
        public const float MinValue = -3.40282347E+38f;
        public const float MaxValue = 3.40282347E+38f;
        public const float Epsilon = 1.401298E-45f;
        public const float NaN = (float)0 / (float)0;
        public const float PositiveInfinity = (float)1 / (float)0;
        public const float NegativeInfinity = (float)(-1) / (float)0;
        public override extern string ToString();
        public extern string ToString(string format);
        public string ToString(IFormatProvider provider) { return ToString(); }
        public string ToString(string format, IFormatProvider provider) { return ToString(format); }
        public override extern bool Equals(object other);
        public override extern int GetHashCode();
        public bool Equals(float other) { return this == other || IsNaN(this) && IsNaN(other); }
        public int CompareTo(float other) { if (this < other) return -1; if (this > other) return 1; if (this == other) return 0; return IsNaN(this) ? IsNaN(other) ? 0 : -1 : 1; }
        public int CompareTo(object other) { return CompareTo((float)other); }
        public static bool IsNaN(float x) { return x != x; }
        public static bool IsInfinity(float x) { return x == PositiveInfinity || x == NegativeInfinity; }
        public static bool IsPositiveInfinity(float x) { return x == PositiveInfinity; }
        public static bool IsNegativeInfinity(float x) { return x == NegativeInfinity; }
        public static extern float Parse(string text);
        public static float Parse(string text, IFormatProvider provider) { return Parse(text); }
        public static extern bool TryParse(string text, out float value);
        public static bool TryParse(string text, NumberStyles styles, IFormatProvider provider, out float value) { return TryParse(text, out value); }
    }
    public struct Double : IComparable<double>, IEquatable<double>, IComparable, IFormattable
    {
        public const double MinValue = -1.7976931348623157E+308;
        public const double MaxValue = 1.7976931348623157E+308;
        public const double Epsilon = 4.94065645841247E-324;
        public const double NaN = (double)0 / (double)0;
        public const double PositiveInfinity = (double)1 / (double)0;
        public const double NegativeInfinity = (double)(-1) / (double)0;
        public override extern string ToString();
        public extern string ToString(string format);
        public string ToString(IFormatProvider provider) { return ToString(); }
        public string ToString(string format, IFormatProvider provider) { return ToString(format); }
        public override extern bool Equals(object other);
        public override extern int GetHashCode();
        public bool Equals(double other) { return this == other || IsNaN(this) && IsNaN(other); }
        public int CompareTo(double other) { if (this < other) return -1; if (this > other) return 1; if (this == other) return 0; return IsNaN(this) ? IsNaN(other) ? 0 : -1 : 1; }
        public int CompareTo(object other) { return CompareTo((double)other); }
        public static bool IsNaN(double x) { return x != x; }
        public static bool IsInfinity(double x) { return x == PositiveInfinity || x == NegativeInfinity; }
        public static bool IsPositiveInfinity(double x) { return x == PositiveInfinity; }
        public static bool IsNegativeInfinity(double x) { return x == NegativeInfinity; }
        public static extern double Parse(string text);
        public static double Parse(string text, IFormatProvider provider) { return Parse(text); }
        public static extern bool TryParse(string text, out double value);
        public static bool TryParse(string text, NumberStyles styles, IFormatProvider provider, out double value) { return TryParse(text, out value); }
    }
    public struct Char : IComparable<char>, IEquatable<char>, IComparable
    {
        public const char MinValue = '\0';
        public const char MaxValue = '\uffff';
        public override extern string ToString();
        public override extern bool Equals(object other);
        public override extern int GetHashCode();
        public bool Equals(char other) { return this == other; }
        public int CompareTo(char other) { return this - other; }
        public int CompareTo(object other) { return CompareTo((char)other); }
        public static extern bool IsDigit(char c);
        public static extern bool IsNumber(char c);
        public static extern bool IsLetter(char c);
        public static bool IsLetterOrDigit(char c) { return IsLetter(c) || IsDigit(c); }
        public static extern bool IsWhiteSpace(char c);
        public static extern bool IsUpper(char c);
        public static extern bool IsLower(char c);
        public static extern bool IsPunctuation(char c);
        public static extern char ToUpper(char c);
        public static extern char ToLower(char c);
        public static char ToUpperInvariant(char c) { return ToUpper(c); }
        public static char ToLowerInvariant(char c) { return ToLower(c); }
        public static bool IsDigit(string s, int i) { return IsDigit(s[i]); }
        public static double GetNumericValue(char c) { return IsDigit(c) ? c - '0' : -1; }
        public static string ToString(char c) { return c.ToString(); }
        public static char Parse(string s) { if (s == null) throw new ArgumentNullException("s"); if (s.Length != 1) throw new FormatException("String must be exactly one character long."); return s[0]; }
    }
    public enum MidpointRounding { ToEven, AwayFromZero }
    public static class Math
    {
        public const double PI = 3.14159265358979323846;
        public const double E = 2.7182818284590452354;
        public static extern double Sin(double x);
        public static extern double Cos(double x);
        public static extern double Tan(double x);
        public static extern double Asin(double x);
        public static extern double Acos(double x);
        public static extern double Atan(double x);
        public static extern double Sinh(double x);
        public static extern double Cosh(double x);
        public static extern double Tanh(double x);
        public static extern double Exp(double x);
        public static extern double Sqrt(double x);
        public static extern double Log(double x);
        public static extern double Log10(double x);
        public static extern double Floor(double x);
        public static extern double Ceiling(double x);
        public static extern double Truncate(double x);
        public static double Log(double x, double b) { if (b == 1) return double.NaN; if (x != 1 && (b == 0 || b == double.PositiveInfinity)) return double.NaN; return Log(x) / Log(b); }
        public static extern double Atan2(double y, double x);
        public static extern double Pow(double x, double y);
        public static extern double Cbrt(double x);
        public static extern double IEEERemainder(double x, double y);
        public static extern double Round(double x);
        public static extern double Round(double x, int digits);
        public static extern double Round(double x, MidpointRounding mode);
        public static extern double Round(double x, int digits, MidpointRounding mode);
        public static int DivRem(int a, int b, out int rest) { rest = a % b; return a / b; }
        public static long BigMul(int a, int b) { return (long)a * b; }
        public static sbyte Abs(sbyte x) { if (x >= 0) return x; if (x == sbyte.MinValue) throw new OverflowException("Negating the minimum value of a twos complement number is invalid."); return (sbyte)(-x); }
        public static short Abs(short x) { if (x >= 0) return x; if (x == short.MinValue) throw new OverflowException("Negating the minimum value of a twos complement number is invalid."); return (short)(-x); }
        public static int Abs(int x) { if (x >= 0) return x; if (x == int.MinValue) throw new OverflowException("Negating the minimum value of a twos complement number is invalid."); return (int)(-x); }
        public static long Abs(long x) { if (x >= 0) return x; if (x == long.MinValue) throw new OverflowException("Negating the minimum value of a twos complement number is invalid."); return (long)(-x); }
        public static extern double Abs(double x);
        public static float Abs(float x) { return (float)Abs((double)x); }
        public static sbyte Max(sbyte a, sbyte b) { return a >= b ? a : b; }
        public static sbyte Min(sbyte a, sbyte b) { return a <= b ? a : b; }
        public static byte Max(byte a, byte b) { return a >= b ? a : b; }
        public static byte Min(byte a, byte b) { return a <= b ? a : b; }
        public static short Max(short a, short b) { return a >= b ? a : b; }
        public static short Min(short a, short b) { return a <= b ? a : b; }
        public static ushort Max(ushort a, ushort b) { return a >= b ? a : b; }
        public static ushort Min(ushort a, ushort b) { return a <= b ? a : b; }
        public static int Max(int a, int b) { return a >= b ? a : b; }
        public static int Min(int a, int b) { return a <= b ? a : b; }
        public static uint Max(uint a, uint b) { return a >= b ? a : b; }
        public static uint Min(uint a, uint b) { return a <= b ? a : b; }
        public static long Max(long a, long b) { return a >= b ? a : b; }
        public static long Min(long a, long b) { return a <= b ? a : b; }
        public static ulong Max(ulong a, ulong b) { return a >= b ? a : b; }
        public static ulong Min(ulong a, ulong b) { return a <= b ? a : b; }
        public static float Max(float a, float b) { return a > b || float.IsNaN(a) ? a : b; }
        public static float Min(float a, float b) { return a < b || float.IsNaN(a) ? a : b; }
        public static double Max(double a, double b) { return a > b || double.IsNaN(a) ? a : b; }
        public static double Min(double a, double b) { return a < b || double.IsNaN(a) ? a : b; }
        public static decimal Abs(decimal x) { return x < 0 ? -x : x; }
        public static decimal Max(decimal a, decimal b) { return a >= b ? a : b; }
        public static decimal Min(decimal a, decimal b) { return a <= b ? a : b; }
        public static int Sign(decimal x) { return x < 0 ? -1 : x > 0 ? 1 : 0; }
        public static decimal Floor(decimal x) { return decimal.Floor(x); }
        public static decimal Ceiling(decimal x) { return decimal.Ceiling(x); }
        public static decimal Truncate(decimal x) { return decimal.Truncate(x); }
        public static decimal Round(decimal x) { return decimal.Round(x); }
        public static decimal Round(decimal x, int decimals) { return decimal.Round(x, decimals); }
        public static decimal Round(decimal x, MidpointRounding mode) { return decimal.Round(x, mode); }
        public static decimal Round(decimal x, int decimals, MidpointRounding mode) { return decimal.Round(x, decimals, mode); }
        public static int Sign(sbyte x) { return x < 0 ? -1 : x > 0 ? 1 : 0; }
        public static int Sign(short x) { return x < 0 ? -1 : x > 0 ? 1 : 0; }
        public static int Sign(int x) { return x < 0 ? -1 : x > 0 ? 1 : 0; }
        public static int Sign(long x) { return x < 0 ? -1 : x > 0 ? 1 : 0; }
        public static int Sign(float x) { if (x < 0) return -1; if (x > 0) return 1; if (x == 0) return 0; throw new ArithmeticException("Function does not accept floating point Not-a-Number values."); }
        public static int Sign(double x) { if (x < 0) return -1; if (x > 0) return 1; if (x == 0) return 0; throw new ArithmeticException("Function does not accept floating point Not-a-Number values."); }
    }
}
