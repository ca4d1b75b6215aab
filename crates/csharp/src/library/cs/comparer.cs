// How texts are compared, as a value.
using System.Collections.Generic;

namespace System
{
    public abstract class StringComparer : IComparer<string>, IEqualityComparer<string>
    {
        public static StringComparer Ordinal { get { return new TextComparer(StringComparison.Ordinal, false); } }
        public static StringComparer OrdinalIgnoreCase { get { return new TextComparer(StringComparison.OrdinalIgnoreCase, true); } }
        public static StringComparer InvariantCulture { get { return new TextComparer(StringComparison.InvariantCulture, false); } }
        public static StringComparer InvariantCultureIgnoreCase { get { return new TextComparer(StringComparison.InvariantCultureIgnoreCase, true); } }
        public static StringComparer CurrentCulture { get { return InvariantCulture; } }
        public static StringComparer CurrentCultureIgnoreCase { get { return InvariantCultureIgnoreCase; } }
        public abstract int Compare(string a, string b);
        public abstract bool Equals(string a, string b);
        public abstract int GetHashCode(string text);
    }
    class TextComparer : StringComparer
    {
        StringComparison how;
        bool ignoreCase;
        public TextComparer(StringComparison how, bool ignoreCase) { this.how = how; this.ignoreCase = ignoreCase; }
        public override int Compare(string a, string b) { return a == null || b == null ? a == b ? 0 : a == null ? -1 : 1 : string.Compare(a, b, how); }
        public override bool Equals(string a, string b) { return string.Equals(a, b, how); }
        public override int GetHashCode(string text) { if (text == null) throw new ArgumentNullException("obj"); return ignoreCase ? text.ToUpperInvariant().GetHashCode() : text.GetHashCode(); }
    }
}
