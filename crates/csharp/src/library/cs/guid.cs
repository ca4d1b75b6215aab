// Identifiers of 128 bits (RFC 9562), first half and second half as they are written.
using System.Text;

namespace System
{
    public struct Guid : IComparable, IComparable<Guid>, IEquatable<Guid>, IFormattable
    {
        public static readonly Guid Empty = new Guid();
        private ulong first, second;
        Guid(ulong first, ulong second) { this.first = first; this.second = second; }
        public Guid(string text)
        {
            if (text == null) throw new ArgumentNullException("g");
            Guid read;
            if (!TryParse(text, out read)) throw new FormatException("Guid should contain 32 digits with 4 dashes (xxxxxxxx-xxxx-xxxx-xxxx-xxxxxxxxxxxx).");
            first = read.first; second = read.second;
        }
        // The first three groups stand with their low byte first.
        static readonly int[] Order = { 3, 2, 1, 0, 5, 4, 7, 6, 8, 9, 10, 11, 12, 13, 14, 15 };
        public Guid(byte[] bytes)
        {
            if (bytes == null) throw new ArgumentNullException("b");
            if (bytes.Length != 16) throw new ArgumentException("Byte array for GUID must be exactly 16 bytes long.");
            ulong a = 0, b = 0;
            for (int i = 0; i < 8; i++) { a = a << 8 | bytes[Order[i]]; b = b << 8 | bytes[Order[i + 8]]; }
            first = a; second = b;
        }
        public byte[] ToByteArray()
        {
            var bytes = new byte[16];
            for (int i = 0; i < 8; i++) { bytes[Order[i]] = (byte)(first >> 56 - 8 * i & 255); bytes[Order[i + 8]] = (byte)(second >> 56 - 8 * i & 255); }
            return bytes;
        }
        // As `new Random()`: the same in each run, so that a program always gives the same.
        static Random random = null;
        public static Guid NewGuid()
        {
            if (random == null) random = new Random();
            var bytes = new byte[16];
            random.NextBytes(bytes);
            Guid any = new Guid(bytes);
            return new Guid(any.first & 0xFFFFFFFFFFFF0FFF | 0x4000, any.second & 0x3FFFFFFFFFFFFFFF | 0x8000000000000000);
        }
        public static Guid Parse(string text) { if (text == null) throw new ArgumentNullException("input"); return new Guid(text); }
        public static bool TryParse(string text, out Guid value)
        {
            value = new Guid();
            if (text == null) return false;
            text = text.Trim();
            if (text.Length == 38 && (text[0] == '{' && text[37] == '}' || text[0] == '(' && text[37] == ')')) { text = text.Substring(1, 36); }
            else if (text.Length != 36 && text.Length != 32) return false;
            bool dashes = text.Length == 36;
            ulong a = 0, b = 0;
            int digits = 0;
            for (int i = 0; i < text.Length; i++)
            {
                char c = text[i];
                if (dashes && (i == 8 || i == 13 || i == 18 || i == 23)) { if (c != '-') return false; continue; }
                int digit = c >= '0' && c <= '9' ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10 : c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
                if (digit < 0) return false;
                if (digits++ < 16) a = a << 4 | (uint)digit; else b = b << 4 | (uint)digit;
            }
            value = new Guid(a, b);
            return true;
        }
        public override string ToString() { return ToString("D"); }
        public string ToString(string format, IFormatProvider provider) { return ToString(format); }
        public string ToString(string format)
        {
            string all = first.ToString("x16") + second.ToString("x16");
            if (string.IsNullOrEmpty(format)) format = "D";
            string dashed = all.Substring(0, 8) + "-" + all.Substring(8, 4) + "-" + all.Substring(12, 4) + "-" + all.Substring(16, 4) + "-" + all.Substring(20);
            switch (format.ToUpper())
            {
                case "N": return all;
                case "D": return dashed;
                case "B": return "{" + dashed + "}";
                case "P": return "(" + dashed + ")";
                case "X": throw new NotSupportedException("The format 'X' of Guid is not supported");
            }
            throw new FormatException("Format String can be only \"D\", \"d\", \"N\", \"n\", \"P\", \"p\", \"B\", \"b\", \"X\" or \"x\".");
        }
        public static bool operator ==(Guid a, Guid b) { return a.first == b.first && a.second == b.second; }
        public static bool operator !=(Guid a, Guid b) { return !(a == b); }
        public bool Equals(Guid other) { return this == other; }
        public override bool Equals(object other) { return other is Guid && this == (Guid)other; }
        public override int GetHashCode() { return first.GetHashCode() * 31 + second.GetHashCode(); }
        public int CompareTo(Guid other) { int c = first.CompareTo(other.first); return c != 0 ? c : second.CompareTo(other.second); }
        public int CompareTo(object other) { if (other == null) return 1; if (!(other is Guid)) throw new ArgumentException("Object must be of type GUID."); return CompareTo((Guid)other); }
    }
    // RFC 4648, section 4.
    static class Base64
    {
        const string Digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        const string Invalid = "The input is not a valid Base-64 string as it contains a non-base 64 character, more than two padding characters, or an illegal character among the padding characters.";
        public static string Text(byte[] bytes, int start, int length)
        {
            var text = new StringBuilder();
            for (int i = 0; i < length; i += 3)
            {
                int rest = Math.Min(3, length - i);
                int bits = bytes[start + i] << 16 | (rest > 1 ? bytes[start + i + 1] << 8 : 0) | (rest > 2 ? bytes[start + i + 2] : 0);
                for (int k = 0; k < 4; k++) text.Append(k > rest ? '=' : Digits[bits >> 18 - 6 * k & 63]);
            }
            return text.ToString();
        }
        static int Digit(char c)
        {
            if (c >= 'A' && c <= 'Z') return c - 'A';
            if (c >= 'a' && c <= 'z') return c - 'a' + 26;
            if (c >= '0' && c <= '9') return c - '0' + 52;
            return c == '+' ? 62 : c == '/' ? 63 : -1;
        }
        public static byte[] Bytes(string text)
        {
            var bytes = new System.Collections.Generic.List<byte>();
            int bits = 0, count = 0, padding = 0;
            foreach (char c in text)
            {
                if (c == ' ' || c == '\t' || c == '\r' || c == '\n') continue;
                int digit = c == '=' ? 0 : Digit(c);
                if (c == '=') padding++;
                if (digit < 0 || padding > 0 && c != '=' || padding > 2 || c == '=' && count % 4 < 2) throw new FormatException(Invalid);
                bits = bits << 6 | digit;
                if (++count % 4 != 0) continue;
                for (int k = 0; k < 3 - padding; k++) bytes.Add((byte)(bits >> 16 - 8 * k & 255));
                bits = 0;
            }
            if (count % 4 != 0) throw new FormatException(Invalid);
            return bytes.ToArray();
        }
    }
}
