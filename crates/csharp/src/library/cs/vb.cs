// What programs written in VB call.
using System;
using System.Collections.Generic;
using System.Text;

// What `Err` says of the last fault that `On Error` caught.
public class __VBError
{
    public static readonly __VBError Err = new __VBError();
    int number;
    string description = "", source = "";
    Exception exception;
    public int Number { get { return number; } set { number = value; } }
    public string Description { get { return description; } set { description = value ?? ""; } }
    public string Source { get { return source; } set { source = value ?? ""; } }
    public Exception GetException() { return exception; }
    public void Clear() { number = 0; description = ""; source = ""; exception = null; }
    public void Set(Exception e)
    {
        exception = e;
        __VBRaised raised = e as __VBRaised;
        number = raised != null ? raised.Number : NumberOf(e);
        description = e.Message;
        source = raised != null ? raised.From : "";
    }
    public void Resume(int active)
    {
        if (active == 0) throw new __VBRaised(20, "", "Resume without error.");
        Clear();
    }
    public void Raise(int number) { throw new __VBRaised(number, "", Words(number)); }
    public void Raise(int number, object source) { throw new __VBRaised(number, "" + source, Words(number)); }
    public void Raise(int number, object source, object description) { throw new __VBRaised(number, "" + source, description == null ? Words(number) : "" + description); }
    // The numbers that Visual Basic's run-time library gives to exceptions of .NET.
    static int NumberOf(Exception e)
    {
        if (e is IndexOutOfRangeException) return 9;
        if (e is DivideByZeroException) return 11;
        if (e is OverflowException) return 6;
        if (e is NullReferenceException) return 91;
        if (e is RuntimeBinderException) return e.Message.Contains("null reference") ? 91 : 438;
        if (e is InvalidCastException || e is FormatException) return 13;
        return 5;
    }
    static string Words(int number)
    {
        switch (number)
        {
            case 5: return "Procedure call or argument is not valid.";
            case 6: return "Overflow.";
            case 7: return "Out of memory.";
            case 9: return "Subscript out of range.";
            case 11: return "Division by zero.";
            case 13: return "Type mismatch.";
            case 91: return "Object variable or With block variable not set.";
            default: return "Application-defined or object-defined error.";
        }
    }
}
class __VBRaised : Exception
{
    public readonly int Number;
    public readonly string From;
    public __VBRaised(int number, string from, string message) : base(message) { Number = number; From = from; }
}
public static class __VB
{
    // The default value of a value's type; the value itself is not asked for.
    public static T Default<T>(Func<T> value) { return default(T); }
    // CInt rounds half to even; True is -1.
    public static int Int(int x) { return x; }
    public static int Int(long x) { return checked((int)x); }
    public static int Int(double x) { return Convert.ToInt32(x); }
    public static int Int(bool x) { return x ? -1 : 0; }
    public static int Int(object x) { return x is bool ? Int((bool)x) : x is string ? Convert.ToInt32(Convert.ToDouble(x)) : Convert.ToInt32(x); }
    public static double Dbl(double x) { return x; }
    public static double Dbl(object x) { return x is bool ? Int((bool)x) : Convert.ToDouble(x); }
    public static string Str(string x) { return x; }
    public static string Str(object x) { return x == null ? null : x.ToString(); }
    public static string Join(object a, object b) { return "" + a + b; }
    public static int Whole(int a, int b) { return a / b; }
    public static long Whole(long a, long b) { return a / b; }
    public static long Whole(double a, double b) { return Convert.ToInt64(a) / Convert.ToInt64(b); }
    public static bool Not(bool x) { return !x; }
    public static int Not(int x) { return ~x; }
    public static long Not(long x) { return ~x; }
    public static object Not(object x) { if (x is bool) return !(bool)x; if (x is long) return ~(long)x; return ~Int(x); }
    // `+` of what is known when it runs: two texts are joined, a text beside a number is read as one.
    public static object Plus(object a, object b)
    {
        if (a is string && (b is string || b == null) || b is string && a == null) return "" + a + b;
        if (a is string || b is string) return Dbl(a) + Dbl(b);
        if (a == null) return b == null ? 0 : b;
        if (b == null) return a;
        return __Dynamic.op_Addition(a is bool ? Int(a) : a, b is bool ? Int(b) : b);
    }
    static object Number(object x) { return x is string ? Dbl(x) : x is bool ? Int((bool)x) : x == null ? 0 : x; }
    public static object Minus(object a, object b) { return __Dynamic.op_Subtraction(Number(a), Number(b)); }
    public static object Times(object a, object b) { return __Dynamic.op_Multiply(Number(a), Number(b)); }
    public static object Divide(object a, object b) { return Dbl(Number(a)) / Dbl(Number(b)); }
    public static object Rest(object a, object b) { return __Dynamic.op_Modulus(Number(a), Number(b)); }
    public static void ReDim<T>(ref T[] a, int most) { a = new T[most + 1]; }
    public static void ReDim<T>(ref T[,] a, int most, int last) { a = new T[most + 1, last + 1]; }
    public static void Preserve<T>(ref T[] a, int most) { if (a == null) a = new T[most + 1]; else Array.Resize(ref a, most + 1); }
    public static int UBound(Array a) { return a.Length - 1; }
    public static int UBound(Array a, int rank) { return a.GetUpperBound(rank - 1); }
    public static int LBound(Array a) { return 0; }
    public static int LBound(Array a, int rank) { return 0; }
    public const string vbCrLf = "\r\n", vbNewLine = "\r\n", vbLf = "\n", vbCr = "\r", vbTab = "\t", vbNullString = null, vbNullChar = "\0", vbBack = "\b";
    static string Text(object x) { return x == null ? "" : x.ToString(); }
    public static int Len(object x) { return Text(x).Length; }
    public static string Left(string s, int n) { s = Text(s); return n >= s.Length ? s : s.Substring(0, n); }
    public static string Right(string s, int n) { s = Text(s); return n >= s.Length ? s : s.Substring(s.Length - n); }
    public static string Mid(string s, int start) { return Mid(s, start, Text(s).Length); }
    public static string Mid(string s, int start, int n)
    {
        if (start < 1 || n < 0) throw new ArgumentException("Argument 'Start' must be greater than zero.");
        s = Text(s);
        return start > s.Length ? "" : s.Substring(start - 1, Math.Min(n, s.Length - start + 1));
    }
    public static int InStr(string s, string part) { return InStr(1, s, part); }
    public static int InStr(int start, string s, string part) { s = Text(s); return s.Length == 0 || start > s.Length ? 0 : s.IndexOf(Text(part), start - 1) + 1; }
    public static int InStrRev(string s, string part) { return Text(s).LastIndexOf(Text(part)) + 1; }
    public static string UCase(string s) { return Text(s).ToUpper(); }
    public static string LCase(string s) { return Text(s).ToLower(); }
    public static string Trim(string s) { return Text(s).Trim(' '); }
    public static string LTrim(string s) { return Text(s).TrimStart(' '); }
    public static string RTrim(string s) { return Text(s).TrimEnd(' '); }
    public static string Replace(string s, string from, string to) { return Text(from) == "" ? s : Text(s).Replace(from, Text(to)); }
    public static string[] Split(string s) { return Split(s, " "); }
    public static string[] Split(string s, string by) { return Text(s).Split(new string[] { by }, StringSplitOptions.None); }
    public static string Join(string[] parts, string by) { return string.Join(by, parts); }
    public static string Join(string[] parts) { return string.Join(" ", parts); }
    public static char Chr(int code) { return (char)code; }
    public static char ChrW(int code) { return (char)code; }
    public static int Asc(string s) { if (Text(s) == "") throw new ArgumentException("Length of argument 'String' must be greater than zero."); return s[0]; }
    public static int Asc(char c) { return c; }
    public static int AscW(string s) { return Asc(s); }
    public static int AscW(char c) { return c; }
    public static string Space(int n) { return new string(' ', n); }
    public static string StrDup(int n, string s) { return new string(s[0], n); }
    public static string StrReverse(string s) { char[] c = Text(s).ToCharArray(); Array.Reverse(c); return new string(c); }
    public static int StrComp(string a, string b) { return Math.Sign(string.CompareOrdinal(Text(a), Text(b))); }
    public static bool IsNothing(object x) { return x == null; }
    public static bool IsNumeric(object x) { double d; return x is string ? double.TryParse((string)x, out d) : x is int || x is double || x is long || x is float || x is short || x is byte || x is bool; }
    public static object IIf(bool test, object yes, object no) { return test ? yes : no; }
    public static string Format(object x, string format) { return Library.Text(x, format); }
    public static string Hex(long x) { return x >= int.MinValue && x < 0 ? ((int)x).ToString("X") : x.ToString("X"); }
    public static string Oct(int x) { return Convert.ToString(x, 8); }
    public static double Val(string s)
    {
        var digits = new StringBuilder();
        bool dot = false, power = false;
        foreach (char c in Text(s))
        {
            if (c == ' ' || c == '\t' || c == '\n') continue;
            if (char.IsDigit(c)) digits.Append(c);
            else if (c == '.' && !dot && !power) { dot = true; digits.Append(c); }
            else if ((c == '-' || c == '+') && (digits.Length == 0 || digits[digits.Length - 1] == 'E')) digits.Append(c);
            else if ((c == 'E' || c == 'e') && digits.Length > 0 && !power) { power = true; digits.Append('E'); }
            else break;
        }
        double value;
        string text = digits.ToString();
        while (text.Length > 0 && !double.TryParse(text, out value)) text = text.Substring(0, text.Length - 1);
        return text.Length > 0 ? double.Parse(text) : 0;
    }
    public static double Floor(double x) { return Math.Floor(x); }
    public static int Floor(int x) { return x; }
    public static double Fix(double x) { return x < 0 ? Math.Ceiling(x) : Math.Floor(x); }
    public static double Abs(double x) { return Math.Abs(x); }
    public static int Abs(int x) { return Math.Abs(x); }
    public static int Sgn(double x) { return Math.Sign(x); }
    public static double Sqr(double x) { return Math.Sqrt(x); }
    // `Like`: ? one character, * any, # a digit, [a-z] and [!a-z] one of these or none of them.
    public static bool Like(string s, string pattern) { return Like(Text(s), 0, Text(pattern), 0); }
    static bool Like(string s, int i, string p, int j)
    {
        while (j < p.Length)
        {
            char c = p[j++];
            if (c == '*')
            {
                for (int k = i; k <= s.Length; k++) if (Like(s, k, p, j)) return true;
                return false;
            }
            if (i >= s.Length) return false;
            if (c == '[')
            {
                int end = p.IndexOf(']', j);
                if (end < 0) throw new ArgumentException("Argument 'Pattern' is not a valid value.");
                if (!Among(s[i], p.Substring(j, end - j))) return false;
                j = end + 1;
            }
            else if (c == '#' ? !char.IsDigit(s[i]) : c != '?' && c != s[i]) return false;
            i++;
        }
        return i == s.Length;
    }
    static bool Among(char c, string list)
    {
        bool not = list.StartsWith("!");
        if (not) list = list.Substring(1);
        for (int i = 0; i < list.Length; i++)
        {
            if (i + 2 < list.Length && list[i + 1] == '-') { if (list[i] <= c && c <= list[i + 2]) return !not; i += 2; }
            else if (list[i] == c) return !not;
        }
        return not;
    }
}
