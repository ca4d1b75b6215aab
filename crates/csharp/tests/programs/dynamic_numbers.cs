using System;

class P
{
    static void Main()
    {
        dynamic a = 7, b = 2, c = 2.5, s = "n";
        Console.WriteLine(a + b); Console.WriteLine(a / b); Console.WriteLine(a * c); Console.WriteLine(a - c); Console.WriteLine(a % b);
        Console.WriteLine(s + a); Console.WriteLine(a > b); Console.WriteLine(a == 7); Console.WriteLine(a != 7);
        double d = a; int i = b; string t = s;
        Console.WriteLine(d / i + t);
        if (a < c) Console.WriteLine("less"); else Console.WriteLine("more");
        a = "text"; Console.WriteLine(a);
        object o = b; Console.WriteLine((int)o + 1);
        try { int bad = s; Console.WriteLine(bad); } catch (Exception) { Console.WriteLine("refused"); }
    }
}
