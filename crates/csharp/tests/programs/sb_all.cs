using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P
{
    static void Main()
    {
        var sb = new StringBuilder(); sb.Append(1).Append('c').Append("s").Append(2.5).Append(true).Append((object)null).Append('x', 3).AppendLine().AppendLine("line").AppendFormat("{0:D3}-{1}", 7, "z"); Console.WriteLine(sb.ToString().Replace(Environment.NewLine, "/")); Console.WriteLine(sb.Length); sb.Insert(0, "START").Replace("x", "yy").Remove(0, 2); Console.WriteLine(sb.ToString().Replace("\n", "/")); sb[0] = 'Q'; Console.WriteLine(sb[0]); sb.Length = 3; Console.WriteLine(sb); sb.Clear(); Console.WriteLine(sb.Length + "[" + sb + "]"); sb = new StringBuilder("init", 50); sb.Append("abcdef", 1, 2).Append(new[] { 'p', 'q' }); Console.WriteLine(sb.ToString(2, 3)); sb.Insert(2, 99).Insert(0, 'z').Insert(1, 1.5).Insert(0, true); Console.WriteLine(sb); sb.Replace('z', 'Z').Replace("it", "IT", 0, sb.Length); Console.WriteLine(sb); for (int i = 0; i < 3; i++) sb.Append(i).Append(i < 2 ? "," : "\n"); Console.Write(sb); Console.WriteLine(sb.ToString().IndexOf("IT")); sb.AppendFormat("{0,6:0.0}|{1,-4}|", 2.345, 'k'); Console.WriteLine(sb);
    }
}
