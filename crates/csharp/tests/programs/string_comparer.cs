using System;
using System.Collections.Generic;
class P {
    static void Main() {
        var d = new Dictionary<string, int>(StringComparer.OrdinalIgnoreCase); d["Wall"] = 1; d["WALL"] = 2; d["roof"] = 3;
        Console.WriteLine(d.Count + " " + d["wall"] + " " + d.ContainsKey("ROOF") + " " + d.ContainsKey("rooF "));
        var h = new HashSet<string>(StringComparer.Ordinal) { "a", "A", "a" }; Console.WriteLine(h.Count);
        foreach (var c in new[] { StringComparer.Ordinal, StringComparer.OrdinalIgnoreCase, StringComparer.InvariantCulture, StringComparer.InvariantCultureIgnoreCase })
        {
            var l = new List<string> { "b", "A", "a", "B", "_", "10", "9" }; l.Sort(c); Console.WriteLine(string.Join(" ", c.Compare("a", "A") == 0 ? new List<string> { l[0], l[1], l[2] } : l));
            Console.WriteLine(c.Equals("x", "X") + " " + Math.Sign(c.Compare("a", "B")) + " " + Math.Sign(c.Compare(null, "a")) + " " + Math.Sign(c.Compare("a", null)) + " " + c.Compare(null, null) + " " + (c.GetHashCode("Q") == c.GetHashCode("q")) + " " + c.Equals(null, null) + c.Equals(null, "a"));
        }
        try { StringComparer.Ordinal.GetHashCode((string)null); } catch (ArgumentNullException) { Console.WriteLine("null"); }
    }
}
