using System;
using System.Text;
class P {
    static void Main() {
        var b = new StringBuilder();
        b.Append("a").Append((string)null).Append("").Append('b').Append(int.MinValue).Append(0).Append(int.MaxValue).Append("\u00e9\ud83d\ude00").Append('\0'.ToString()).Append(2.5).Append(true).Append((object)null).Append(7L);
        Console.WriteLine(b + " " + b.Length);
        b.Append(b.ToString()).Append(b); Console.WriteLine(b.Length);
        b.Clear().Append('x', 3).AppendLine("!").AppendFormat("{0}-{1}", 1, "z"); Console.WriteLine(b);
        for (int i = 0; i < 20000; i++) b.Append(i).Append(' ').Append("s");
        int sum = 0; foreach (char c in b.ToString()) sum = sum * 31 + c; Console.WriteLine(b.Length + " " + sum);
        StringBuilder none = null; try { none.Append('c'); } catch (NullReferenceException) { Console.WriteLine("null"); }
        try { none.Append("c"); } catch (NullReferenceException) { Console.WriteLine("null"); }
    }
}
