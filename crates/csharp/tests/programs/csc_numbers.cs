using System;

static class Program
{
    static void Main()
    {
        // Mono's compiler reads these otherwise, and its Math.Round of a half goes away from zero.
        Console.WriteLine(0b1010 + 1_000);
        Console.WriteLine(Math.Round(2.5) + " " + Math.Round(-2.5) + " " + Math.Round(3.5));
        int? missing = null;
        Console.WriteLine(missing is null);
        Console.WriteLine(nameof(Program.Main) + default(int));
    }
}
