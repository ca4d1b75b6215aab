using System;

class TickArgs : EventArgs { public int N; public TickArgs(int n) { N = n; } }

interface ISource { event EventHandler Changed; void Raise(); }

class Clock : ISource
{
    public event EventHandler<TickArgs> Tick;
    public event Action Plain = delegate { };
    public static event Action<string> Said;
    public event EventHandler Changed;
    public void Run(int n)
    {
        for (int i = 0; i < n; i++)
        {
            if (Tick != null) Tick(this, new TickArgs(i));
            Plain();
        }
    }
    public void Raise() { Changed?.Invoke(this, EventArgs.Empty); }
    public static void Say(string s) { Said?.Invoke(s); }
    private Action stored;
    public event Action Custom
    {
        add { Console.WriteLine("add"); stored += value; }
        remove { Console.WriteLine("remove"); stored -= value; }
    }
    public void RunCustom() { if (stored != null) stored(); else Console.WriteLine("nobody"); }
}

class Listener
{
    public int Sum;
    public void OnTick(object sender, TickArgs e) { Sum += e.N; Console.WriteLine(sender.GetType().Name + " " + e.N); }
    public void OnChanged(object sender, EventArgs e) { Console.WriteLine("changed " + (e == EventArgs.Empty)); }
}

abstract class Base
{
    public virtual event Action Done;
    public void Finish() { if (Done != null) Done(); }
}
class Derived : Base { }

class Program
{
    static void Main()
    {
        var clock = new Clock();
        var l = new Listener();
        clock.Tick += l.OnTick;
        clock.Tick += (s, e) => Console.WriteLine("lambda " + e.N);
        clock.Run(2);
        clock.Tick -= l.OnTick;
        clock.Run(1);
        Console.WriteLine(l.Sum);
        ISource source = clock;
        source.Raise();
        source.Changed += l.OnChanged;
        source.Raise();
        source.Changed -= l.OnChanged;
        source.Raise();
        Clock.Say("nobody");
        Clock.Said += Console.WriteLine;
        Clock.Said += s => Console.WriteLine(s.Length);
        Clock.Say("hello");
        Action h = () => Console.WriteLine("custom");
        clock.RunCustom();
        clock.Custom += h;
        clock.RunCustom();
        clock.Custom -= h;
        clock.RunCustom();
        Base d = new Derived();
        d.Done += () => Console.WriteLine("done");
        d.Finish();
    }
}
