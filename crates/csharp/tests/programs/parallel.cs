using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class Program
{
    static void Main()
    {
        var r = new double[5]; System.Threading.Tasks.Parallel.For(0, 5, i => r[i] = i * 2); Console.WriteLine(string.Join(",", r)); object gate = new object(); int sum = 0; System.Threading.Tasks.Parallel.ForEach(new[] { 1, 2, 3 }, x => { lock (gate) sum += x; }); Console.WriteLine(sum);
    }
}
