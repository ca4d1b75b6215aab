// Regular expressions: the search is done in Rust, the rest here.
using System.Collections;
using System.Collections.Generic;

namespace System.Text.RegularExpressions
{
    [Flags] public enum RegexOptions { None = 0, IgnoreCase = 1, Multiline = 2, ExplicitCapture = 4, Compiled = 8, Singleline = 16, IgnorePatternWhitespace = 32, RightToLeft = 64, ECMAScript = 256, CultureInvariant = 512 }
    public delegate string MatchEvaluator(Match match);
    public class Capture
    {
        public int Index { get; protected set; }
        public int Length { get; protected set; }
        public string Value { get; protected set; }
        public override string ToString() { return Value; }
    }
    public class Group : Capture
    {
        public bool Success { get; protected set; }
        public string Name { get; protected set; }
        public Group(string text, string name, int start, int length)
        {
            Name = name; Success = start >= 0; Index = Success ? start : 0; Length = length; Value = Success ? text.Substring(start, length) : "";
        }
    }
    public class GroupCollection : IEnumerable<Group>
    {
        Group[] all; string[] names;
        public GroupCollection(Group[] all, string[] names) { this.all = all; this.names = names; }
        public int Count { get { return all.Length; } }
        public Group this[int i] { get { return i >= 0 && i < all.Length ? all[i] : new Group("", i.ToString(), -1, 0); } }
        public Group this[string name] { get { return this[Array.IndexOf(names, name)]; } }
        public IEnumerator<Group> GetEnumerator() { foreach (Group g in all) yield return g; }
        IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }
    }
    public class Match : Group
    {
        Regex regex; string text; Group[] groups;
        public static Match Empty { get { return new Match(null, "", new int[] { -1, 0 }, 0, new string[] { "0" }); } }
        public Match(Regex regex, string text, int[] spans, int at, string[] names) : base(text, "0", spans[at], spans[at + 1])
        {
            this.regex = regex; this.text = text;
            groups = new Group[names.Length];
            groups[0] = this;
            for (int i = 1; i < names.Length; i++) groups[i] = new Group(text, names[i], spans[at + 2 * i], spans[at + 2 * i + 1]);
            Groups = new GroupCollection(groups, names);
        }
        public GroupCollection Groups { get; private set; }
        public Match NextMatch() { return Success ? regex.Match(text, Length > 0 ? Index + Length : Index + 1) : Empty; }
        public string Result(string replacement)
        {
            var made = new StringBuilder();
            for (int i = 0; i < replacement.Length; i++)
            {
                char c = replacement[i];
                if (c != '$' || i + 1 >= replacement.Length) { made.Append(c); continue; }
                char n = replacement[i + 1];
                if (n == '$') { made.Append('$'); i++; }
                else if (n == '&') { made.Append(Value); i++; }
                else if (n == '`') { made.Append(text.Substring(0, Index)); i++; }
                else if (n == '\'') { made.Append(text.Substring(Index + Length)); i++; }
                else if (n == '_') { made.Append(text); i++; }
                else if (n == '+') { made.Append(groups[groups.Length - 1].Value); i++; }
                else if (n == '{') i = Named(made, replacement, i);
                else if (char.IsDigit(n)) i = Numbered(made, replacement, i);
                else made.Append(c);
            }
            return made.ToString();
        }
        int Named(StringBuilder made, string replacement, int i)
        {
            int end = replacement.IndexOf('}', i);
            string name = end < 0 ? "" : replacement.Substring(i + 2, end - i - 2);
            foreach (Group g in groups) if (g.Name == name) { made.Append(g.Value); return end; }
            made.Append('$');
            return i;
        }
        int Numbered(StringBuilder made, string replacement, int i)
        {
            int n = 0, end = i + 1;
            while (end < replacement.Length && char.IsDigit(replacement[end]) && n < 10000) n = n * 10 + replacement[end++] - '0';
            if (n >= groups.Length) { made.Append('$'); return i; }
            made.Append(groups[n].Value);
            return end - 1;
        }
    }
    public class MatchCollection : IEnumerable<Match>
    {
        List<Match> all;
        public MatchCollection(List<Match> all) { this.all = all; }
        public int Count { get { return all.Count; } }
        public Match this[int i] { get { return all[i]; } }
        public IEnumerator<Match> GetEnumerator() { foreach (Match m in all) yield return m; }
        IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }
    }
    public class Regex
    {
        string pattern; string[] names;
        public RegexOptions Options { get; private set; }
        public Regex(string pattern) : this(pattern, RegexOptions.None) { }
        public Regex(string pattern, RegexOptions options)
        {
            if (pattern == null) throw new ArgumentNullException("pattern");
            this.pattern = pattern; Options = options; names = __Names(pattern, (int)options);
        }
        static extern Int32[] __All(String pattern, Int32 options, String text, Int32 start, Int32 count);
        static extern String[] __Names(String pattern, Int32 options);
        public override string ToString() { return pattern; }
        public string[] GetGroupNames() { return (string[])names.Clone(); }
        public int[] GetGroupNumbers() { int[] n = new int[names.Length]; for (int i = 0; i < n.Length; i++) n[i] = i; return n; }
        public int GroupNumberFromName(string name) { return Array.IndexOf(names, name); }
        public string GroupNameFromNumber(int i) { return i >= 0 && i < names.Length ? names[i] : ""; }
        List<Match> All(string text, int start, int count)
        {
            if (text == null) throw new ArgumentNullException("input");
            if (start < 0 || start > text.Length) throw new ArgumentOutOfRangeException("startat");
            int[] spans = __All(pattern, (int)Options, text, start, count < 0 ? int.MaxValue : count);
            var all = new List<Match>();
            for (int at = 0; at < spans.Length; at += 2 * names.Length) all.Add(new Match(this, text, spans, at, names));
            return all;
        }
        public bool IsMatch(string input) { return Match(input).Success; }
        public bool IsMatch(string input, int start) { return Match(input, start).Success; }
        public Match Match(string input) { return Match(input, 0); }
        public Match Match(string input, int start)
        {
            if (input != null && start == input.Length + 1) return System.Text.RegularExpressions.Match.Empty;
            List<Match> found = All(input, start, 1);
            return found.Count > 0 ? found[0] : System.Text.RegularExpressions.Match.Empty;
        }
        public MatchCollection Matches(string input) { return new MatchCollection(All(input, 0, -1)); }
        public MatchCollection Matches(string input, int start) { return new MatchCollection(All(input, start, -1)); }
        public string Replace(string input, string replacement) { return Replace(input, replacement, -1); }
        public string Replace(string input, string replacement, int count)
        {
            if (replacement == null) throw new ArgumentNullException("replacement");
            return Replace(input, m => m.Result(replacement), count);
        }
        public string Replace(string input, MatchEvaluator evaluator) { return Replace(input, evaluator, -1); }
        public string Replace(string input, MatchEvaluator evaluator, int count)
        {
            if (evaluator == null) throw new ArgumentNullException("evaluator");
            var made = new StringBuilder();
            int at = 0;
            foreach (Match m in All(input, 0, count))
            {
                made.Append(input.Substring(at, m.Index - at)).Append(evaluator(m));
                at = m.Index + m.Length;
            }
            return made.Append(input.Substring(at)).ToString();
        }
        public string[] Split(string input) { return Split(input, 0); }
        public string[] Split(string input, int count)
        {
            var parts = new List<string>();
            int at = 0;
            foreach (Match m in All(input, 0, count <= 0 ? -1 : count - 1))
            {
                parts.Add(input.Substring(at, m.Index - at));
                at = m.Index + m.Length;
                for (int i = 1; i < m.Groups.Count; i++) if (m.Groups[i].Success) parts.Add(m.Groups[i].Value);
            }
            parts.Add(input.Substring(at));
            return parts.ToArray();
        }
        public static bool IsMatch(string input, string pattern) { return new Regex(pattern).IsMatch(input); }
        public static bool IsMatch(string input, string pattern, RegexOptions options) { return new Regex(pattern, options).IsMatch(input); }
        public static Match Match(string input, string pattern) { return new Regex(pattern).Match(input); }
        public static Match Match(string input, string pattern, RegexOptions options) { return new Regex(pattern, options).Match(input); }
        public static MatchCollection Matches(string input, string pattern) { return new Regex(pattern).Matches(input); }
        public static MatchCollection Matches(string input, string pattern, RegexOptions options) { return new Regex(pattern, options).Matches(input); }
        public static string Replace(string input, string pattern, string replacement) { return new Regex(pattern).Replace(input, replacement); }
        public static string Replace(string input, string pattern, string replacement, RegexOptions options) { return new Regex(pattern, options).Replace(input, replacement); }
        public static string Replace(string input, string pattern, MatchEvaluator evaluator) { return new Regex(pattern).Replace(input, evaluator); }
        public static string Replace(string input, string pattern, MatchEvaluator evaluator, RegexOptions options) { return new Regex(pattern, options).Replace(input, evaluator); }
        public static string[] Split(string input, string pattern) { return new Regex(pattern).Split(input); }
        public static string[] Split(string input, string pattern, RegexOptions options) { return new Regex(pattern, options).Split(input); }
        public static string Escape(string text)
        {
            var made = new StringBuilder();
            foreach (char c in text)
            {
                if (c == '\n') made.Append("\\n");
                else if (c == '\r') made.Append("\\r");
                else if (c == '\t') made.Append("\\t");
                else if (c == '\f') made.Append("\\f");
                else { if ("\\*+?|{[()^$.# ".IndexOf(c) >= 0) made.Append('\\'); made.Append(c); }
            }
            return made.ToString();
        }
    }
}
