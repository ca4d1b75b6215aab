// Dates and spans of time, in ticks of 100 ns as in .NET. The host's clock is the only one; its zone is UTC.
using System.Globalization;
using System.Text;

namespace System
{
    public enum DayOfWeek { Sunday, Monday, Tuesday, Wednesday, Thursday, Friday, Saturday }
    public enum DateTimeKind { Unspecified, Utc, Local }
    static class Clock { public static extern long Ticks(); }
    public struct TimeSpan : IComparable, IComparable<TimeSpan>, IEquatable<TimeSpan>, IFormattable
    {
        public const long TicksPerMillisecond = 10000, TicksPerSecond = 10000000, TicksPerMinute = 600000000, TicksPerHour = 36000000000, TicksPerDay = 864000000000;
        public static readonly TimeSpan Zero = new TimeSpan(0);
        public static readonly TimeSpan MinValue = new TimeSpan(long.MinValue);
        public static readonly TimeSpan MaxValue = new TimeSpan(long.MaxValue);
        private long ticks;
        public TimeSpan(long ticks) { this.ticks = ticks; }
        public TimeSpan(int hours, int minutes, int seconds) { ticks = Whole(0, hours, minutes, seconds, 0); }
        public TimeSpan(int days, int hours, int minutes, int seconds) { ticks = Whole(days, hours, minutes, seconds, 0); }
        public TimeSpan(int days, int hours, int minutes, int seconds, int milliseconds) { ticks = Whole(days, hours, minutes, seconds, milliseconds); }
        static long Whole(long d, long h, long m, long s, long ms)
        {
            long all = (d * 86400 + h * 3600 + m * 60 + s) * 1000 + ms;
            if (all > long.MaxValue / 10000 || all < long.MinValue / 10000) throw new ArgumentOutOfRangeException(null, TooLong);
            return all * 10000;
        }
        const string TooLong = "TimeSpan overflowed because the duration is too long.";
        // The .NET Framework rounds to whole milliseconds.
        static TimeSpan Of(double value, double scale)
        {
            if (double.IsNaN(value)) throw new ArgumentException("TimeSpan does not accept floating point Not-a-Number values.");
            double ms = value * scale + (value >= 0 ? 0.5 : -0.5);
            if (ms > long.MaxValue / 10000 || ms < long.MinValue / 10000) throw new OverflowException(TooLong);
            return new TimeSpan((long)ms * 10000);
        }
        public static TimeSpan FromDays(double x) { return Of(x, 86400000); }
        public static TimeSpan FromHours(double x) { return Of(x, 3600000); }
        public static TimeSpan FromMinutes(double x) { return Of(x, 60000); }
        public static TimeSpan FromSeconds(double x) { return Of(x, 1000); }
        public static TimeSpan FromMilliseconds(double x) { return Of(x, 1); }
        public static TimeSpan FromTicks(long x) { return new TimeSpan(x); }
        public long Ticks { get { return ticks; } }
        public int Days { get { return (int)(ticks / TicksPerDay); } }
        public int Hours { get { return (int)(ticks / TicksPerHour % 24); } }
        public int Minutes { get { return (int)(ticks / TicksPerMinute % 60); } }
        public int Seconds { get { return (int)(ticks / TicksPerSecond % 60); } }
        public int Milliseconds { get { return (int)(ticks / TicksPerMillisecond % 1000); } }
        public double TotalDays { get { return ticks * (1.0 / TicksPerDay); } }
        public double TotalHours { get { return ticks * (1.0 / TicksPerHour); } }
        public double TotalMinutes { get { return ticks * (1.0 / TicksPerMinute); } }
        public double TotalSeconds { get { return ticks * (1.0 / TicksPerSecond); } }
        public double TotalMilliseconds { get { return Math.Max(Math.Min(ticks * (1.0 / TicksPerMillisecond), long.MaxValue / 10000), long.MinValue / 10000); } }
        static long Sum(long a, long b)
        {
            long sum = unchecked(a + b);
            if (a < 0 == b < 0 && a < 0 != sum < 0) throw new OverflowException(TooLong);
            return sum;
        }
        public TimeSpan Add(TimeSpan t) { return new TimeSpan(Sum(ticks, t.ticks)); }
        public TimeSpan Subtract(TimeSpan t) { if (t.ticks == long.MinValue) throw new OverflowException(TooLong); return new TimeSpan(Sum(ticks, -t.ticks)); }
        public TimeSpan Negate() { if (ticks == long.MinValue) throw new OverflowException("Negating the minimum value of a twos complement number is invalid."); return new TimeSpan(-ticks); }
        public TimeSpan Duration() { if (ticks == long.MinValue) throw new OverflowException("The duration cannot be returned for TimeSpan.MinValue because the absolute value of TimeSpan.MinValue exceeds the value of TimeSpan.MaxValue."); return new TimeSpan(ticks < 0 ? -ticks : ticks); }
        public static TimeSpan operator +(TimeSpan a, TimeSpan b) { return a.Add(b); }
        public static TimeSpan operator -(TimeSpan a, TimeSpan b) { return a.Subtract(b); }
        public static TimeSpan operator -(TimeSpan a) { return a.Negate(); }
        public static bool operator ==(TimeSpan a, TimeSpan b) { return a.ticks == b.ticks; }
        public static bool operator !=(TimeSpan a, TimeSpan b) { return a.ticks != b.ticks; }
        public static bool operator <(TimeSpan a, TimeSpan b) { return a.ticks < b.ticks; }
        public static bool operator >(TimeSpan a, TimeSpan b) { return a.ticks > b.ticks; }
        public static bool operator <=(TimeSpan a, TimeSpan b) { return a.ticks <= b.ticks; }
        public static bool operator >=(TimeSpan a, TimeSpan b) { return a.ticks >= b.ticks; }
        public static int Compare(TimeSpan a, TimeSpan b) { return a.ticks.CompareTo(b.ticks); }
        public int CompareTo(TimeSpan other) { return ticks.CompareTo(other.ticks); }
        public int CompareTo(object other) { if (other == null) return 1; if (!(other is TimeSpan)) throw new ArgumentException("Object must be of type TimeSpan."); return CompareTo((TimeSpan)other); }
        public bool Equals(TimeSpan other) { return ticks == other.ticks; }
        public override bool Equals(object other) { return other is TimeSpan && ((TimeSpan)other).ticks == ticks; }
        public override int GetHashCode() { return (int)ticks ^ (int)(ticks >> 32); }
        public override string ToString()
        {
            ulong t = ticks < 0 ? (ulong)(-(ticks + 1)) + 1 : (ulong)ticks;
            ulong days = t / 864000000000, part = t % 10000000;
            var text = new StringBuilder(ticks < 0 ? "-" : "");
            if (days > 0) text.Append(days.ToString() + ".");
            text.Append((t / 36000000000 % 24).ToString("00") + ":" + (t / 600000000 % 60).ToString("00") + ":" + (t / 10000000 % 60).ToString("00"));
            if (part > 0) text.Append("." + part.ToString("0000000"));
            return text.ToString();
        }
        public static bool TryParse(string text, out TimeSpan t)
        {
            t = Zero;
            if (text == null) return false;
            text = text.Trim();
            bool minus = text.StartsWith("-");
            if (minus) text = text.Substring(1);
            long days = 0, fraction = 0;
            string[] parts = text.Split(':');
            int dot = parts[0].IndexOf('.');
            if (dot >= 0 && parts.Length > 1) { if (!Digits(parts[0].Substring(0, dot), 10675199, out days)) return false; parts[0] = parts[0].Substring(dot + 1); }
            if (parts.Length == 4) { if (!Digits(parts[0], 10675199, out days)) return false; parts = new string[] { parts[1], parts[2], parts[3] }; }
            long hours = 0, minutes = 0, seconds = 0;
            if (parts.Length == 1) { if (!Digits(parts[0], 10675199, out days)) return false; }
            else
            {
                if (parts.Length > 3 || !Digits(parts[0], 23, out hours) || !Digits(parts[1], 59, out minutes)) return false;
                if (parts.Length == 3)
                {
                    dot = parts[2].IndexOf('.');
                    string whole = dot < 0 ? parts[2] : parts[2].Substring(0, dot), rest = dot < 0 ? "0" : parts[2].Substring(dot + 1);
                    if (!Digits(whole, 59, out seconds) || rest.Length > 7 || !Digits(rest.PadRight(7, '0'), 9999999, out fraction)) return false;
                }
            }
            long all = ((days * 24 + hours) * 60 + minutes) * 60 + seconds;
            t = new TimeSpan((minus ? -1 : 1) * (all * TicksPerSecond + fraction));
            return true;
        }
        static bool Digits(string text, long most, out long n)
        {
            n = 0;
            if (text.Length == 0 || text.Length > 9) return false;
            foreach (char c in text) { if (c < '0' || c > '9') return false; n = n * 10 + c - '0'; }
            return n <= most;
        }
        public static bool TryParse(string text, IFormatProvider provider, out TimeSpan t) { return TryParse(text, out t); }
        public static TimeSpan Parse(string text) { TimeSpan t; if (text == null) throw new ArgumentNullException("input"); if (!TryParse(text, out t)) throw new FormatException("String was not recognized as a valid TimeSpan."); return t; }
        public static TimeSpan Parse(string text, IFormatProvider provider) { return Parse(text); }
        public string ToString(string format) { return TimeFormat.Text(this, format); }
        public string ToString(string format, IFormatProvider provider) { return ToString(format); }
    }
    // Formats of spans of time: "c", "g", "G" and patterns.
    static class TimeFormat
    {
        static string Fraction(long ticks, int digits, bool trim)
        {
            string all = (ticks % 10000000).ToString("0000000").Substring(0, digits);
            return trim ? all.TrimEnd('0') : all;
        }
        public static string Text(TimeSpan t, string format)
        {
            if (string.IsNullOrEmpty(format) || format == "c" || format == "t" || format == "T") return t.ToString();
            TimeSpan a = t < TimeSpan.Zero ? t.Negate() : t;
            string sign = t < TimeSpan.Zero ? "-" : "";
            if (format == "g")
            {
                string rest = Fraction(a.Ticks, 7, true);
                return sign + (a.Days > 0 ? a.Days + ":" : "") + a.Hours + ":" + a.Minutes.ToString("00") + ":" + a.Seconds.ToString("00") + (rest == "" ? "" : "." + rest);
            }
            if (format == "G") return sign + a.Days + ":" + a.Hours.ToString("00") + ":" + a.Minutes.ToString("00") + ":" + a.Seconds.ToString("00") + "." + Fraction(a.Ticks, 7, false);
            if (format.Length == 1) throw new FormatException("Input string was not in a correct format.");
            return Pattern(a, format);
        }
        static string Pattern(TimeSpan a, string format)
        {
            var text = new StringBuilder();
            for (int i = 0; i < format.Length; )
            {
                char c = format[i];
                int n = 1;
                if (c == '%') { i++; continue; }
                if (c == '\\') { if (i + 1 >= format.Length) throw new FormatException("Input string was not in a correct format."); text.Append(format[i + 1]); i += 2; continue; }
                if (c == '\'' || c == '"')
                {
                    int end = format.IndexOf(c, i + 1);
                    if (end < 0) throw new FormatException("Input string was not in a correct format.");
                    text.Append(format.Substring(i + 1, end - i - 1));
                    i = end + 1;
                    continue;
                }
                while (i + n < format.Length && format[i + n] == c) n++;
                if (n > (c == 'd' ? 8 : c == 'f' || c == 'F' ? 7 : 2)) throw new FormatException("Input string was not in a correct format.");
                switch (c)
                {
                    case 'd': text.Append(a.Days.ToString("D" + n)); break;
                    case 'h': text.Append(a.Hours.ToString("D" + n)); break;
                    case 'm': text.Append(a.Minutes.ToString("D" + n)); break;
                    case 's': text.Append(a.Seconds.ToString("D" + n)); break;
                    case 'f': case 'F': text.Append(Fraction(a.Ticks, n, c == 'F')); break;
                    default: throw new FormatException("Input string was not in a correct format.");
                }
                i += n;
            }
            return text.ToString();
        }
    }
    public struct DateTime : IComparable, IComparable<DateTime>, IEquatable<DateTime>, IFormattable
    {
        const long MaxTicks = 3155378975999999999;
        public static readonly DateTime MinValue = new DateTime(0);
        public static readonly DateTime MaxValue = new DateTime(MaxTicks);
        private long ticks;
        private DateTimeKind kind;
        public DateTime(long ticks) : this(ticks, DateTimeKind.Unspecified) { }
        public DateTime(long ticks, DateTimeKind kind)
        {
            if (ticks < 0 || ticks > MaxTicks) throw new ArgumentOutOfRangeException("ticks", "Ticks must be between DateTime.MinValue.Ticks and DateTime.MaxValue.Ticks.");
            this.ticks = ticks; this.kind = kind;
        }
        public DateTime(int year, int month, int day) { ticks = DateTicks(year, month, day); kind = DateTimeKind.Unspecified; }
        public DateTime(int year, int month, int day, int hour, int minute, int second) { ticks = DateTicks(year, month, day) + TimeTicks(hour, minute, second, 0); kind = DateTimeKind.Unspecified; }
        public DateTime(int year, int month, int day, int hour, int minute, int second, DateTimeKind kind) { ticks = DateTicks(year, month, day) + TimeTicks(hour, minute, second, 0); this.kind = kind; }
        public DateTime(int year, int month, int day, int hour, int minute, int second, int millisecond) { ticks = DateTicks(year, month, day) + TimeTicks(hour, minute, second, millisecond); kind = DateTimeKind.Unspecified; }
        public DateTime(int year, int month, int day, int hour, int minute, int second, int millisecond, DateTimeKind kind) { ticks = DateTicks(year, month, day) + TimeTicks(hour, minute, second, millisecond); this.kind = kind; }
        static int DaysBefore(int month, bool leap) { return (367 * month - 362) / 12 - (month > 2 ? leap ? 1 : 2 : 0); }
        static long DaysBeforeYear(int year) { int y = year - 1; return y * 365 + y / 4 - y / 100 + y / 400; }
        static long DateTicks(int year, int month, int day)
        {
            if (year < 1 || year > 9999 || month < 1 || month > 12 || day < 1 || day > DaysInMonth(year, month)) throw new ArgumentOutOfRangeException(null, "Year, Month, and Day parameters describe an un-representable DateTime.");
            return (DaysBeforeYear(year) + DaysBefore(month, IsLeapYear(year)) + day - 1) * TimeSpan.TicksPerDay;
        }
        static long TimeTicks(int hour, int minute, int second, int millisecond)
        {
            if (hour < 0 || hour > 23 || minute < 0 || minute > 59 || second < 0 || second > 59) throw new ArgumentOutOfRangeException(null, "Hour, Minute, and Second parameters describe an un-representable DateTime.");
            if (millisecond < 0 || millisecond > 999) throw new ArgumentOutOfRangeException("millisecond", "Valid values are between 0 and 999, inclusive.");
            return ((hour * 60 + minute) * 60 + second) * TimeSpan.TicksPerSecond + millisecond * TimeSpan.TicksPerMillisecond;
        }
        public static bool IsLeapYear(int year)
        {
            if (year < 1 || year > 9999) throw new ArgumentOutOfRangeException("year", "Year must be between 1 and 9999.");
            return year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
        }
        public static int DaysInMonth(int year, int month)
        {
            if (month < 1 || month > 12) throw new ArgumentOutOfRangeException("month", "Month must be between one and twelve.");
            bool leap = IsLeapYear(year);
            return month == 12 ? 31 : DaysBefore(month + 1, leap) - DaysBefore(month, leap);
        }
        public static DateTime UtcNow { get { return new DateTime(Clock.Ticks(), DateTimeKind.Utc); } }
        public static DateTime Now { get { return new DateTime(Clock.Ticks(), DateTimeKind.Local); } }
        public static DateTime Today { get { return Now.Date; } }
        public static DateTime SpecifyKind(DateTime d, DateTimeKind kind) { return new DateTime(d.ticks, kind); }
        public DateTime ToUniversalTime() { return new DateTime(ticks, DateTimeKind.Utc); }
        public DateTime ToLocalTime() { return new DateTime(ticks, DateTimeKind.Local); }
        public long Ticks { get { return ticks; } }
        public DateTimeKind Kind { get { return kind; } }
        // Years of 365.2425 days give the year or the one after it.
        public int Year { get { long days = ticks / TimeSpan.TicksPerDay; int y = (int)(days * 400 / 146097) + 1; if (y < 9999 && DaysBeforeYear(y + 1) <= days) y++; if (DaysBeforeYear(y) > days) y--; return y; } }
        public int DayOfYear { get { return (int)(ticks / TimeSpan.TicksPerDay - DaysBeforeYear(Year)) + 1; } }
        public int Month { get { int d = DayOfYear - 1, m = 12; bool leap = IsLeapYear(Year); while (DaysBefore(m, leap) > d) m--; return m; } }
        public int Day { get { return DayOfYear - DaysBefore(Month, IsLeapYear(Year)); } }
        public int Hour { get { return (int)(ticks / TimeSpan.TicksPerHour % 24); } }
        public int Minute { get { return (int)(ticks / TimeSpan.TicksPerMinute % 60); } }
        public int Second { get { return (int)(ticks / TimeSpan.TicksPerSecond % 60); } }
        public int Millisecond { get { return (int)(ticks / TimeSpan.TicksPerMillisecond % 1000); } }
        public DayOfWeek DayOfWeek { get { return (DayOfWeek)((ticks / TimeSpan.TicksPerDay + 1) % 7); } }
        public DateTime Date { get { return new DateTime(ticks - ticks % TimeSpan.TicksPerDay, kind); } }
        public TimeSpan TimeOfDay { get { return new TimeSpan(ticks % TimeSpan.TicksPerDay); } }
        public DateTime AddTicks(long more)
        {
            if (more > MaxTicks - ticks || more < -ticks) throw new ArgumentOutOfRangeException("value", "The added or subtracted value results in an un-representable DateTime.");
            return new DateTime(ticks + more, kind);
        }
        DateTime Plus(double value, double scale)
        {
            double ms = value * scale + (value >= 0 ? 0.5 : -0.5);
            if (!(ms > -315537897600000.0 && ms < 315537897600000.0)) throw new ArgumentOutOfRangeException("value", "Value to add was out of range.");
            return AddTicks((long)ms * 10000);
        }
        public DateTime Add(TimeSpan t) { return AddTicks(t.Ticks); }
        public DateTime AddDays(double x) { return Plus(x, 86400000); }
        public DateTime AddHours(double x) { return Plus(x, 3600000); }
        public DateTime AddMinutes(double x) { return Plus(x, 60000); }
        public DateTime AddSeconds(double x) { return Plus(x, 1000); }
        public DateTime AddMilliseconds(double x) { return Plus(x, 1); }
        public DateTime AddMonths(int months)
        {
            if (months < -120000 || months > 120000) throw new ArgumentOutOfRangeException("months", "Months value must be between +/-120000.");
            int all = Year * 12 + Month - 1 + months, y = all / 12, m = all % 12 + 1;
            if (all < 12 || y > 9999) throw new ArgumentOutOfRangeException("months", "The added or subtracted value results in an un-representable DateTime.");
            return new DateTime(DateTicks(y, m, Math.Min(Day, DaysInMonth(y, m))) + ticks % TimeSpan.TicksPerDay, kind);
        }
        public DateTime AddYears(int years) { if (years < -10000 || years > 10000) throw new ArgumentOutOfRangeException("years", "Years value must be between +/-10000."); return AddMonths(years * 12); }
        public TimeSpan Subtract(DateTime d) { return new TimeSpan(ticks - d.ticks); }
        public DateTime Subtract(TimeSpan t)
        {
            if (t.Ticks > ticks || t.Ticks < ticks - MaxTicks) throw new ArgumentOutOfRangeException("value", "The added or subtracted value results in an un-representable DateTime.");
            return new DateTime(ticks - t.Ticks, kind);
        }
        public static DateTime operator +(DateTime d, TimeSpan t) { return d.Add(t); }
        public static DateTime operator -(DateTime d, TimeSpan t) { return d.Subtract(t); }
        public static TimeSpan operator -(DateTime a, DateTime b) { return a.Subtract(b); }
        public static bool operator ==(DateTime a, DateTime b) { return a.ticks == b.ticks; }
        public static bool operator !=(DateTime a, DateTime b) { return a.ticks != b.ticks; }
        public static bool operator <(DateTime a, DateTime b) { return a.ticks < b.ticks; }
        public static bool operator >(DateTime a, DateTime b) { return a.ticks > b.ticks; }
        public static bool operator <=(DateTime a, DateTime b) { return a.ticks <= b.ticks; }
        public static bool operator >=(DateTime a, DateTime b) { return a.ticks >= b.ticks; }
        public static int Compare(DateTime a, DateTime b) { return a.ticks.CompareTo(b.ticks); }
        public int CompareTo(DateTime other) { return ticks.CompareTo(other.ticks); }
        public int CompareTo(object other) { if (other == null) return 1; if (!(other is DateTime)) throw new ArgumentException("Object must be of type DateTime."); return CompareTo((DateTime)other); }
        public bool Equals(DateTime other) { return ticks == other.ticks; }
        public override bool Equals(object other) { return other is DateTime && ((DateTime)other).ticks == ticks; }
        public override int GetHashCode() { return (int)ticks ^ (int)(ticks >> 32); }
        public override string ToString() { return ToString("G"); }
        public string ToString(IFormatProvider provider) { return ToString("G"); }
        public string ToString(string format, IFormatProvider provider) { return ToString(format); }
        public string ToString(string format) { return DateFormat.Text(this, format); }
        public static DateTime Parse(string text) { DateTime d; if (text == null) throw new ArgumentNullException("s"); if (!DateParser.Any(text, out d)) throw DateParser.Wrong(); return d; }
        public static DateTime Parse(string text, IFormatProvider provider) { return Parse(text); }
        public static DateTime Parse(string text, IFormatProvider provider, DateTimeStyles styles) { return Parse(text); }
        public static bool TryParse(string text, out DateTime d) { d = MinValue; return text != null && DateParser.Any(text, out d); }
        public static bool TryParse(string text, IFormatProvider provider, DateTimeStyles styles, out DateTime d) { return TryParse(text, out d); }
        public static DateTime ParseExact(string text, string format, IFormatProvider provider) { return ParseExact(text, format, provider, DateTimeStyles.None); }
        public static DateTime ParseExact(string text, string format, IFormatProvider provider, DateTimeStyles styles)
        {
            DateTime d;
            if (text == null) throw new ArgumentNullException("s");
            if (format == null) throw new ArgumentNullException("format");
            if (!TryParseExact(text, format, provider, styles, out d)) throw DateParser.Wrong();
            return d;
        }
        public static DateTime ParseExact(string text, string[] formats, IFormatProvider provider, DateTimeStyles styles)
        {
            DateTime d;
            foreach (string format in formats) if (TryParseExact(text, format, provider, styles, out d)) return d;
            throw DateParser.Wrong();
        }
        public static bool TryParseExact(string text, string format, IFormatProvider provider, DateTimeStyles styles, out DateTime d)
        {
            d = MinValue;
            if (text == null || format == null) return false;
            if (format.Length == 1) format = DateFormat.Pattern(format[0]);
            return DateParser.Exact((styles & DateTimeStyles.AllowWhiteSpaces) != 0 ? text.Trim() : text, format, out d);
        }
        public string ToShortDateString() { return ToString("d"); }
        public string ToLongDateString() { return ToString("D"); }
        public string ToShortTimeString() { return ToString("t"); }
        public string ToLongTimeString() { return ToString("T"); }
    }
    // Formats of dates in the invariant culture.
    static class DateFormat
    {
        public static readonly string[] Months = { "January", "February", "March", "April", "May", "June", "July", "August", "September", "October", "November", "December" };
        public static string Pattern(char c)
        {
            switch (c)
            {
                case 'd': return "MM/dd/yyyy";
                case 'D': return "dddd, dd MMMM yyyy";
                case 't': return "HH:mm";
                case 'T': return "HH:mm:ss";
                case 'f': return "dddd, dd MMMM yyyy HH:mm";
                case 'F': return "dddd, dd MMMM yyyy HH:mm:ss";
                case 'g': return "MM/dd/yyyy HH:mm";
                case 'G': return "MM/dd/yyyy HH:mm:ss";
                case 'm': case 'M': return "MMMM dd";
                case 'y': case 'Y': return "yyyy MMMM";
                case 'r': case 'R': return "ddd, dd MMM yyyy HH':'mm':'ss 'GMT'";
                case 's': return "yyyy'-'MM'-'dd'T'HH':'mm':'ss";
                case 'u': return "yyyy'-'MM'-'dd HH':'mm':'ss'Z'";
                case 'o': case 'O': return "yyyy'-'MM'-'dd'T'HH':'mm':'ss.fffffffK";
            }
            throw new FormatException("Input string was not in a correct format.");
        }
        static string Digits(int n, int width) { return n.ToString("D" + Math.Min(width, 2)); }
        public static string Text(DateTime d, string format)
        {
            if (string.IsNullOrEmpty(format)) format = "G";
            if (format.Length == 1) format = Pattern(format[0]);
            var text = new StringBuilder();
            for (int i = 0; i < format.Length; )
            {
                char c = format[i];
                int n = 1;
                if (c == '%') { i++; if (i >= format.Length || format[i] == '%') throw new FormatException("Input string was not in a correct format."); continue; }
                if (c == '\\') { if (i + 1 >= format.Length) throw new FormatException("Input string was not in a correct format."); text.Append(format[i + 1]); i += 2; continue; }
                if (c == '\'' || c == '"') { i = Quoted(text, format, i); continue; }
                while (i + n < format.Length && format[i + n] == c) n++;
                if (!Part(text, d, c, n)) text.Append(c, n);
                i += n;
            }
            return text.ToString();
        }
        static int Quoted(StringBuilder text, string format, int start)
        {
            char quote = format[start];
            for (int i = start + 1; i < format.Length; i++)
            {
                if (format[i] == quote) return i + 1;
                if (format[i] == '\\' && ++i >= format.Length) break;
                text.Append(format[i]);
            }
            throw new FormatException("Cannot find a matching quote character for the character '" + quote + "'.");
        }
        static bool Part(StringBuilder text, DateTime d, char c, int n)
        {
            switch (c)
            {
                case 'd': text.Append(n < 3 ? Digits(d.Day, n) : n == 3 ? d.DayOfWeek.ToString().Substring(0, 3) : d.DayOfWeek.ToString()); return true;
                case 'M': text.Append(n < 3 ? Digits(d.Month, n) : n == 3 ? Months[d.Month - 1].Substring(0, 3) : Months[d.Month - 1]); return true;
                case 'y': text.Append(n < 3 ? Digits(d.Year % 100, n) : d.Year.ToString("D" + n)); return true;
                case 'H': text.Append(Digits(d.Hour, n)); return true;
                case 'h': text.Append(Digits((d.Hour + 11) % 12 + 1, n)); return true;
                case 'm': text.Append(Digits(d.Minute, n)); return true;
                case 's': text.Append(Digits(d.Second, n)); return true;
                case 't': text.Append(n == 1 ? d.Hour < 12 ? "A" : "P" : d.Hour < 12 ? "AM" : "PM"); return true;
                case 'f': case 'F': Fraction(text, (int)(d.Ticks % TimeSpan.TicksPerSecond), n, c == 'F'); return true;
                case 'g': text.Append("A.D."); return true;
                case 'K': for (int i = 0; i < n; i++) text.Append(d.Kind == DateTimeKind.Utc ? "Z" : d.Kind == DateTimeKind.Local ? "+00:00" : ""); return true;
                case 'z': text.Append(n == 1 ? "+0" : n == 2 ? "+00" : "+00:00"); return true;
            }
            return false;
        }
        static void Fraction(StringBuilder text, int ticks, int n, bool trim)
        {
            if (n > 7) throw new FormatException("Input string was not in a correct format.");
            string digits = ticks.ToString("D7").Substring(0, n);
            if (trim) digits = digits.TrimEnd('0');
            string before = text.ToString();
            if (trim && digits == "" && before.EndsWith(".")) text.Length = before.Length - 1;
            text.Append(digits);
        }
    }
}
namespace System.Diagnostics
{
    public class Stopwatch
    {
        public static readonly long Frequency = 10000000;
        public static readonly bool IsHighResolution = true;
        private long kept, begun;
        public bool IsRunning { get; private set; }
        public static long GetTimestamp() { return Clock.Ticks(); }
        public static Stopwatch StartNew() { var w = new Stopwatch(); w.Start(); return w; }
        public void Start() { if (IsRunning) return; begun = Clock.Ticks(); IsRunning = true; }
        public void Stop() { if (!IsRunning) return; kept = ElapsedTicks; IsRunning = false; }
        public void Reset() { kept = 0; IsRunning = false; }
        public void Restart() { Reset(); Start(); }
        public long ElapsedTicks { get { long all = IsRunning ? kept + Clock.Ticks() - begun : kept; return all < 0 ? 0 : all; } }
        public long ElapsedMilliseconds { get { return ElapsedTicks / 10000; } }
        public TimeSpan Elapsed { get { return new TimeSpan(ElapsedTicks); } }
    }
}
