// Random decimals of all sizes and scales: sums, products, quotients, remainders and order.
using System;
class P
{
    static decimal Make(Random r)
    {
        int size = r.Next(4);
        int low = r.Next(int.MinValue, int.MaxValue), mid = size > 1 ? r.Next(int.MinValue, int.MaxValue) : 0, high = size > 2 ? r.Next(int.MinValue, int.MaxValue) : 0;
        if (size == 0) low = r.Next(20);
        return new decimal(low, mid, high, r.Next(2) == 0, (byte)(r.Next(3) == 0 ? r.Next(29) : r.Next(6)));
    }
    static string Try(Func<decimal> f)
    {
        try { return f().ToString(); }
        catch (OverflowException) { return "overflow"; }
        catch (DivideByZeroException) { return "by zero"; }
    }
    static void Main()
    {
        var r = new Random(12345);
        for (int i = 0; i < 400; i++)
        {
            decimal a = Make(r), b = Make(r);
            Console.WriteLine(a + " " + b + ": " + Try(() => a + b) + " " + Try(() => a - b) + " " + Try(() => a * b) + " " + Try(() => a / b) + " " + Try(() => a % b) + " " + a.CompareTo(b) + " " + (a == b));
        }
    }
}
