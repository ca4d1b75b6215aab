using System;
using System.Text;
class P {
    static void Show(byte[] b) { string s = Convert.ToBase64String(b); Console.WriteLine(b.Length + " " + s + " " + string.Join(",", Convert.FromBase64String(s))); }
    static void Refused(string s) { try { Convert.FromBase64String(s); Console.WriteLine("read"); } catch (FormatException e) { Console.WriteLine(e.Message); } }
    static void Main() {
        for (int n = 0; n < 8; n++) { var b = new byte[n]; for (int i = 0; i < n; i++) b[i] = (byte)(i * 37 + 250); Show(b); }
        Console.WriteLine(Convert.ToBase64String(new byte[] { 1, 2, 3, 4, 5 }, 1, 3));
        Console.WriteLine(string.Join(",", Convert.FromBase64String(" A Q I\nD ")));
        Refused("abc"); Refused("ab!="); Refused("a==="); Refused("ab==cd=="); Refused("=abc"); Refused("ab=c");
        try { Convert.ToBase64String(null); } catch (ArgumentNullException e) { Console.WriteLine(e.ParamName); }
        try { Convert.ToBase64String(new byte[2], 1, 2); } catch (ArgumentOutOfRangeException e) { Console.WriteLine(e.ParamName); }
    }
}
