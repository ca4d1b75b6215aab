// Decimals.
using System.Globalization;

namespace System
{
    public struct Decimal : IComparable<decimal>, IEquatable<decimal>, IComparable, IFormattable
    {
        public const decimal Zero = 0m;
        public const decimal One = 1m;
        public const decimal MinusOne = -1m;
        public const decimal MaxValue = 79228162514264337593543950335m;
        public const decimal MinValue = -79228162514264337593543950335m;
        public extern Decimal(int value);
        public extern Decimal(uint value);
        public extern Decimal(long value);
        public extern Decimal(ulong value);
        public extern Decimal(float value);
        public extern Decimal(double value);
        public extern Decimal(int low, int mid, int high, bool isNegative, byte scale);
        public override extern string ToString();
        public extern string ToString(string format);
        public string ToString(IFormatProvider provider) { return ToString(); }
        public string ToString(string format, IFormatProvider provider) { return ToString(format); }
        public override extern bool Equals(object other);
        public override extern int GetHashCode();
        public bool Equals(decimal other) { return this == other; }
        public int CompareTo(decimal other) { return this < other ? -1 : this > other ? 1 : 0; }
        public int CompareTo(object other) { return other == null ? 1 : CompareTo((decimal)other); }
        static extern decimal Read(string text, bool exponents);
        static extern bool TryRead(string text, bool exponents, out decimal value);
        public static decimal Parse(string s) { return Read(s, false); }
        public static decimal Parse(string s, IFormatProvider provider) { return Read(s, false); }
        public static decimal Parse(string s, NumberStyles style) { return Read(s, (style & NumberStyles.AllowExponent) != 0); }
        public static decimal Parse(string s, NumberStyles style, IFormatProvider provider) { return Parse(s, style); }
        public static bool TryParse(string s, out decimal result) { return TryRead(s, false, out result); }
        public static bool TryParse(string s, NumberStyles style, IFormatProvider provider, out decimal result) { return TryRead(s, (style & NumberStyles.AllowExponent) != 0, out result); }
        static extern decimal Round(decimal d, int decimals, bool away);
        public static decimal Round(decimal d) { return Round(d, 0, false); }
        public static decimal Round(decimal d, int decimals) { return Round(d, decimals, false); }
        public static decimal Round(decimal d, MidpointRounding mode) { return Round(d, 0, mode == MidpointRounding.AwayFromZero); }
        public static decimal Round(decimal d, int decimals, MidpointRounding mode) { return Round(d, decimals, mode == MidpointRounding.AwayFromZero); }
        public static extern decimal Truncate(decimal d);
        public static extern decimal Floor(decimal d);
        public static extern decimal Ceiling(decimal d);
        public static extern int[] GetBits(decimal d);
        public static decimal Add(decimal a, decimal b) { return a + b; }
        public static decimal Subtract(decimal a, decimal b) { return a - b; }
        public static decimal Multiply(decimal a, decimal b) { return a * b; }
        public static decimal Divide(decimal a, decimal b) { return a / b; }
        public static decimal Remainder(decimal a, decimal b) { return a % b; }
        public static decimal Negate(decimal d) { return -d; }
        public static int Compare(decimal a, decimal b) { return a.CompareTo(b); }
        public static bool Equals(decimal a, decimal b) { return a == b; }
        public static double ToDouble(decimal d) { return (double)d; }
        public static float ToSingle(decimal d) { return (float)d; }
        public static byte ToByte(decimal d) { return (byte)d; }
        public static short ToInt16(decimal d) { return (short)d; }
        public static int ToInt32(decimal d) { return (int)d; }
        public static uint ToUInt32(decimal d) { return (uint)d; }
        public static long ToInt64(decimal d) { return (long)d; }
        public static ulong ToUInt64(decimal d) { return (ulong)d; }
    }
}
