// Dates read from texts, in the invariant culture.
using System.Collections.Generic;
using System.Globalization;
using System.Text;

namespace System.Globalization
{
    [System.Flags] public enum DateTimeStyles { None = 0, AllowLeadingWhite = 1, AllowTrailingWhite = 2, AllowInnerWhite = 4, AllowWhiteSpaces = 7, NoCurrentDateDefault = 8, AdjustToUniversal = 16, AssumeLocal = 32, AssumeUniversal = 64, RoundtripKind = 128 }
}
namespace System
{
    // Reads a text by a pattern of the same letters as DateFormat writes.
    class DateParser
    {
        string text; int at;
        int year = -1, month = -1, day = -1, hour, minute, second, half = -1; long fraction; DateTimeKind kind; bool timed;
        DateParser(string text) { this.text = text; }
        public static Exception Wrong() { return new FormatException("String was not recognized as a valid DateTime."); }
        public static bool Exact(string text, string format, out DateTime d) { return new DateParser(text).Read(format, out d); }
        static readonly string[] Days = { "M/d/yyyy", "M/d/yy", "yyyy-M-d", "yyyy/M/d", "d MMM yyyy", "d MMMM yyyy", "MMM d, yyyy", "MMMM d, yyyy", "MMM d yyyy", "MMMM d yyyy", "d-MMM-yyyy", "dddd, d MMMM yyyy", "dddd, MMMM d, yyyy", "ddd, d MMM yyyy", "yyyy MMMM", "MMMM yyyy", "yyyy-M" };
        static readonly string[] Times = { "H:m", "H:m:s", "H:m:s.FFFFFFF", "h:m tt", "h:m:s tt", "h tt" };
        public static bool Any(string text, out DateTime d)
        {
            text = text.Trim();
            foreach (string day in Days)
            {
                if (Exact(text, day, out d)) return true;
                foreach (string time in Times) if (Exact(text, day + " " + time, out d)) return true;
            }
            foreach (string time in new string[] { "HH:mm", "HH:mm:ss", "HH:mm:ss.FFFFFFF" })
                foreach (string zone in new string[] { "", "Z" })
                    if (Exact(text, "yyyy-MM-dd'T'" + time + (zone == "" ? "" : "'Z'"), out d)) { if (zone != "") d = new DateTime(d.Ticks, DateTimeKind.Local); return true; }
            if (Exact(text, "ddd, dd MMM yyyy HH:mm:ss 'GMT'", out d)) return true;
            foreach (string time in Times) if (Exact(text, time, out d)) { d = DateTime.Today + d.TimeOfDay; return true; }
            d = DateTime.MinValue;
            return false;
        }
        bool Number(int least, int most, out int n)
        {
            int from = at;
            n = 0;
            while (at < text.Length && at - from < most && text[at] >= '0' && text[at] <= '9') n = n * 10 + text[at++] - '0';
            return at - from >= least;
        }
        bool Word(string word)
        {
            if (at + word.Length > text.Length || !string.Equals(text.Substring(at, word.Length), word, StringComparison.OrdinalIgnoreCase)) return false;
            at += word.Length;
            return true;
        }
        bool Literal(char c) { if (at >= text.Length || text[at] != c) return false; at++; return true; }
        bool Name(bool months, bool whole, out int found)
        {
            for (found = 1; found <= (months ? 12 : 7); found++)
            {
                string name = months ? DateFormat.Months[found - 1] : ((DayOfWeek)(found - 1)).ToString();
                if (Word(whole ? name : name.Substring(0, 3))) return true;
            }
            return false;
        }
        bool Fraction(int n, bool trim)
        {
            long scale = 1000000;
            int from = at;
            while (at < text.Length && at - from < n && char.IsDigit(text[at])) { fraction += (text[at++] - '0') * scale; scale /= 10; }
            return trim || at - from == n;
        }
        bool Part(char c, int n)
        {
            int v = 0;
            switch (c)
            {
                case 'y': if (!Number(n < 3 ? n : n, n < 3 ? 2 : Math.Max(n, 4), out year)) return false; if (n < 3) year += year > 49 ? 1900 : 2000; return true;
                case 'M': return n < 3 ? Number(n, 2, out month) : Name(true, n > 3, out month);
                case 'd': return n < 3 ? Number(n, 2, out day) : Name(false, n > 3, out v);
                case 'H': case 'h': timed = true; return Number(n > 1 ? 2 : 1, 2, out hour) && (c == 'H' || hour >= 1 && hour <= 12);
                case 'm': return Number(n > 1 ? 2 : 1, 2, out minute);
                case 's': return Number(n > 1 ? 2 : 1, 2, out second);
                case 'f': case 'F': return Fraction(n, c == 'F');
                case 't': if (Word(n == 1 ? "A" : "AM")) half = 0; else if (Word(n == 1 ? "P" : "PM")) half = 1; else return false; return true;
                case 'K': if (Word("Z")) kind = DateTimeKind.Utc; return true;
            }
            return Same(c, n);
        }
        bool Same(char c, int n) { while (n-- > 0) if (!Literal(c)) return false; return true; }
        bool Read(string format, out DateTime d)
        {
            d = DateTime.MinValue;
            for (int i = 0; i < format.Length; )
            {
                char c = format[i];
                int n = 1;
                if (c == '%') { i++; continue; }
                if (c == '\\' && i + 1 < format.Length) { if (!Literal(format[i + 1])) return false; i += 2; continue; }
                if (c == '\'' || c == '"')
                {
                    int end = format.IndexOf(c, i + 1);
                    if (end < 0) return false;
                    for (i++; i < end; i++) if (!Literal(format[i])) return false;
                    i = end + 1;
                    continue;
                }
                while (i + n < format.Length && format[i + n] == c) n++;
                if (!Part(c, n)) return false;
                i += n;
            }
            if (at != text.Length) return false;
            if (half >= 0) { if (hour < 1 || hour > 12) return false; hour = hour % 12 + 12 * half; }
            if (year < 0 && month < 0 && day < 0 && timed) { year = 1; month = 1; day = 1; }
            if (year < 0) return false;
            if (month < 0) month = 1;
            if (day < 0) day = 1;
            if (year < 1 || year > 9999 || month < 1 || month > 12 || day < 1 || day > DateTime.DaysInMonth(year, month) || hour > 23 || minute > 59 || second > 59) return false;
            d = new DateTime(new DateTime(year, month, day, hour, minute, second).Ticks + fraction, kind);
            return true;
        }
    }
}
