using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class Program
{
    static void Main()
    {
        var sb = new StringBuilder(); sb.Append("a").Append(1).Append(2.5).Append('c').AppendLine("x"); sb.AppendFormat("{0:F1}", 3.14159); sb.Insert(0, "<<"); sb.Replace("a", "AAA"); Console.WriteLine(sb.ToString()); Console.WriteLine(sb.Length); sb.Length = 3; Console.WriteLine(sb); sb[0] = 'Q'; sb.Remove(1, 1); Console.WriteLine(sb); sb.Clear(); Console.WriteLine(sb.Length);
    }
}
