using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

enum S { Idle, Run, Stop } class Machine { public S State { get; private set; } readonly Dictionary<S, Func<S>> next; public Machine() { next = new Dictionary<S, Func<S>> { { S.Idle, () => S.Run }, { S.Run, () => S.Stop }, { S.Stop, () => { throw new InvalidOperationException("end"); } } }; } public void Step() { State = next[State](); } }

static class Program
{
    static void Main()
    {
        var m = new Machine(); try { while (true) { Console.Write(m.State + " "); m.Step(); } } catch (InvalidOperationException e) { Console.WriteLine(e.Message); }
    }
}
