// Operators on values whose types are known when they run: whole numbers, numbers, texts, truth values.
using System;

public static class __Nullable
{
    public static bool? And(bool? a, bool? b) { if (a == false || b == false) return false; if (a == null || b == null) return null; return true; }
    public static bool? Or(bool? a, bool? b) { if (a == true || b == true) return true; if (a == null || b == null) return null; return false; }
}

public static class __Dynamic
{
    static bool Whole(object x) { return x is int || x is byte || x is short || x is char; }
    static bool Long(object x) { return Whole(x) || x is long; }
    static bool Real(object x) { return Long(x) || x is double || x is float; }
    static object Refused(string op, object a, object b)
    {
        string x = a == null ? "<null>" : a.GetType().ToString(), y = b == null ? "<null>" : b.GetType().ToString();
        throw new InvalidOperationException("Operator '" + op + "' cannot be applied to operands of type '" + x + "' and '" + y + "'");
    }
    public static double ToDouble(object x)
    {
        if (Real(x)) return Convert.ToDouble(x);
        throw new InvalidCastException("Cannot convert type '" + (x == null ? "<null>" : x.GetType().ToString()) + "' to 'double'");
    }
    public static double ReadDouble(object x) { return x is string ? Convert.ToDouble(x) : ToDouble(x); }
    public static object op_Addition(object a, object b)
    {
        if (a is string || b is string) return "" + a + b;
        if (Whole(a) && Whole(b)) return Convert.ToInt32(a) + Convert.ToInt32(b);
        if (Long(a) && Long(b)) return Convert.ToInt64(a) + Convert.ToInt64(b);
        return Real(a) && Real(b) ? Convert.ToDouble(a) + Convert.ToDouble(b) : Refused("+", a, b);
    }
    public static object op_Subtraction(object a, object b)
    {
        if (Whole(a) && Whole(b)) return Convert.ToInt32(a) - Convert.ToInt32(b);
        if (Long(a) && Long(b)) return Convert.ToInt64(a) - Convert.ToInt64(b);
        return Real(a) && Real(b) ? Convert.ToDouble(a) - Convert.ToDouble(b) : Refused("-", a, b);
    }
    public static object op_Multiply(object a, object b)
    {
        if (Whole(a) && Whole(b)) return Convert.ToInt32(a) * Convert.ToInt32(b);
        if (Long(a) && Long(b)) return Convert.ToInt64(a) * Convert.ToInt64(b);
        return Real(a) && Real(b) ? Convert.ToDouble(a) * Convert.ToDouble(b) : Refused("*", a, b);
    }
    public static object op_Division(object a, object b)
    {
        if (Whole(a) && Whole(b)) return Convert.ToInt32(a) / Convert.ToInt32(b);
        if (Long(a) && Long(b)) return Convert.ToInt64(a) / Convert.ToInt64(b);
        return Real(a) && Real(b) ? Convert.ToDouble(a) / Convert.ToDouble(b) : Refused("/", a, b);
    }
    public static object op_Modulus(object a, object b)
    {
        if (Whole(a) && Whole(b)) return Convert.ToInt32(a) % Convert.ToInt32(b);
        if (Long(a) && Long(b)) return Convert.ToInt64(a) % Convert.ToInt64(b);
        return Real(a) && Real(b) ? Convert.ToDouble(a) % Convert.ToDouble(b) : Refused("%", a, b);
    }
    public static object op_LessThan(object a, object b) { return Real(a) && Real(b) ? Convert.ToDouble(a) < Convert.ToDouble(b) : Refused("<", a, b); }
    public static object op_GreaterThan(object a, object b) { return Real(a) && Real(b) ? Convert.ToDouble(a) > Convert.ToDouble(b) : Refused(">", a, b); }
    public static object op_LessThanOrEqual(object a, object b) { return Real(a) && Real(b) ? Convert.ToDouble(a) <= Convert.ToDouble(b) : Refused("<=", a, b); }
    public static object op_GreaterThanOrEqual(object a, object b) { return Real(a) && Real(b) ? Convert.ToDouble(a) >= Convert.ToDouble(b) : Refused(">=", a, b); }
    public static object op_Equality(object a, object b) { return Real(a) && Real(b) ? Convert.ToDouble(a) == Convert.ToDouble(b) : a == null ? b == null : a.Equals(b); }
    public static object op_Inequality(object a, object b) { return !(bool)op_Equality(a, b); }
}
