using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class Program
{
    static void Main()
    {
        Console.WriteLine(int.Parse(" 42 ") + double.Parse("1.5e3")); int n; Console.WriteLine(int.TryParse("x", out n) + " " + n); double d; Console.WriteLine(double.TryParse("3.25", out d) + " " + d);
        try { int.Parse("abc"); } catch (FormatException e) { Console.WriteLine(e.Message); } try { int.Parse("99999999999"); } catch (OverflowException e) { Console.WriteLine(e.Message); } Console.WriteLine(bool.Parse("true")); Console.WriteLine(Convert.ToInt32(2.5) + " " + Convert.ToInt32(3.5) + " " + Convert.ToInt32("12") + " " + Convert.ToDouble("2.5") + " " + Convert.ToString(255, 16) + " " + Convert.ToInt32("ff", 16));
    }
}
