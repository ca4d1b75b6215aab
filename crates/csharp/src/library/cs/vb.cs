// What programs written in VB call.
using System;

public static class __VB
{
    // CInt rounds half to even; True is -1.
    public static int Int(int x) { return x; }
    public static int Int(long x) { return checked((int)x); }
    public static int Int(double x) { return Convert.ToInt32(x); }
    public static int Int(bool x) { return x ? -1 : 0; }
    public static int Int(object x) { return Convert.ToInt32(x); }
    public static double Dbl(double x) { return x; }
    public static double Dbl(object x) { return Convert.ToDouble(x); }
    public static string Str(string x) { return x; }
    public static string Str(object x) { return x == null ? null : x.ToString(); }
    public static string Join(object a, object b) { return "" + a + b; }
    public static int Whole(int a, int b) { return a / b; }
    public static long Whole(long a, long b) { return a / b; }
}
