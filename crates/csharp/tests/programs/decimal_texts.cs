// Decimals as texts: formats, kept scale, Parse.
using System;
using System.Globalization;
class P
{
    static void Parse(string s)
    {
        decimal d;
        Console.Write("[" + s + "] " + decimal.TryParse(s, out d) + " " + d);
        try { Console.WriteLine(" " + decimal.Parse(s)); } catch (FormatException e) { Console.WriteLine(" " + e.Message); } catch (OverflowException e) { Console.WriteLine(" " + e.Message); }
    }
    static void Main()
    {
        foreach (decimal d in new decimal[] { 0m, 1.50m, -1.50m, 1234567.891m, 0.000012345m, -0.005m, 79228162514264337593543950335m, 1e-28m, 100m, 0.5m, 2.5m })
        {
            foreach (string f in new string[] { "G", "G0", "G1", "G3", "G29", "F0", "F2", "F5", "N1", "E2", "E0", "P1", "C2", "0.##", "#,##0.00", "000.0", "#.#E+0", "0.0;(0.0);zero" })
                Console.Write(d.ToString(f) + " | ");
            Console.WriteLine(d);
        }
        foreach (string s in new string[] { "1", "1.50", " -2.5 ", "+3", "4-", "1,234.5", ".5", "5.", "", " ", "a", "1e3", "1.2.3", "(5)", "0.000", "-0.00", "12345678901234567890123456789", "79228162514264337593543950335", "79228162514264337593543950336", "0.1234567890123456789012345678949", "0.12345678901234567890123456785", "0.12345678901234567890123456795", "7.92281625142643375935439503355", "1 2", "--1", "1-2" })
            Parse(s);
        Console.WriteLine(decimal.Parse("1.5e3", NumberStyles.Float) + " " + decimal.Parse("2e-3", NumberStyles.Any));
        Console.WriteLine($"{1.5m} {1.5m:F3} {12.30m,8}|" + string.Format(" {0:N2}", 1234.5m));
        Console.WriteLine(1.0m.Equals(1.00m) + " " + (1.0m.GetHashCode() == 1.00m.GetHashCode()) + " " + 1.5m.GetHashCode() + " " + (-3m).GetHashCode());
        try { Console.WriteLine(1.5m.ToString("X")); } catch (FormatException e) { Console.WriteLine(e.Message); }
        try { Console.WriteLine(1.5m.ToString("D")); } catch (FormatException e) { Console.WriteLine(e.Message); }
        Console.WriteLine(1m + 0.00m + " " + 1.10m * 2 + " " + 3m / 2 + " " + 1.00m / 2 + " " + 10m / 4.00m + " " + 6.00m / 3m + " " + 0.10m % 0.03m + " " + (1.10m - 1.10m) + " " + -(1.20m));
    }
}
