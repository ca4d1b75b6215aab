using System;
using System.Diagnostics;
class P {
    static void Main() {
        var w = new Stopwatch();
        Console.WriteLine(w.IsRunning + " " + w.ElapsedTicks + " " + w.Elapsed + " " + w.ElapsedMilliseconds + " " + Stopwatch.Frequency);
        w.Stop(); w.Reset(); Console.WriteLine(w.IsRunning);
    }
}
