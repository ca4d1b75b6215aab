using System;
using System.Collections.Generic;
class P {
    static void Main() {
        var g = new Guid("00112233-4455-6677-8899-aAbBcCdDeEfF");
        foreach (var f in new[] { "D", "N", "B", "P", "n", "" }) Console.WriteLine(g.ToString(f));
        Console.WriteLine(string.Join(" ", g.ToByteArray()));
        Console.WriteLine(new Guid(g.ToByteArray()) == g);
        Console.WriteLine(Guid.Empty + " " + (new Guid() == Guid.Empty));
        Guid o;
        foreach (var s in new[] { "{00112233-4455-6677-8899-aabbccddeeff}", "(00112233-4455-6677-8899-aabbccddeeff)", "00112233445566778899aabbccddeeff", "0011223-34455-6677-8899-aabbccddeeff", "x", "", "{00112233-4455-6677-8899-aabbccddeeff)" })
            Console.WriteLine(Guid.TryParse(s, out o) + " " + o + " " + g.Equals(o));
        try { new Guid("zz"); } catch (FormatException) { Console.WriteLine("no Guid"); }
        try { new Guid((string)null); } catch (ArgumentNullException e) { Console.WriteLine(e.ParamName); }
        try { new Guid(new byte[3]); } catch (ArgumentException) { Console.WriteLine("no 16 bytes"); }
        var n = Guid.NewGuid();
        Console.WriteLine(n.ToString()[14] + " " + "89ab".Contains(n.ToString().Substring(19, 1)) + " " + (n != Guid.NewGuid()));
        var h = new Guid("f0112233-4455-6677-8899-aabbccddeeff");
        Console.WriteLine(g.CompareTo(h) + " " + h.CompareTo(g) + " " + g.CompareTo(g) + " " + g.CompareTo(null));
        var d = new Dictionary<Guid, int>(); d[g] = 1; d[new Guid(g.ToByteArray())] = 2;
        Console.WriteLine(d.Count + " " + d[g] + " " + string.Format("{0} {0:N}", g) + $" {g:B}");
        object boxed = g; Console.WriteLine(boxed.Equals(g) + " " + boxed + " " + boxed.GetType());
    }
}
