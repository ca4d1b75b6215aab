// Structs in variables of their own: every value that can be told from a copy is looked at.
using System;
using System.Collections.Generic;

struct V
{
    public double X, Y;
    public V(double x, double y) { X = x; Y = y; }
    public V(V other) { X = other.X; Y = other.Y; }
    public double Length { get { return Math.Sqrt(X * X + Y * Y); } }
    public double Sum { get { return X + Y; } set { X = value - Y; } }
    public double this[int i]
    {
        get { return i == 0 ? X : Y; }
        set { if (i == 0) X = value; else Y = value; }
    }
    public static V operator +(V a, V b) { return new V(a.X + b.X, a.Y + b.Y); }
    public static V operator -(V a, V b) { return new V(a.X - b.X, a.Y - b.Y); }
    public static V operator *(V a, double k) { return new V(a.X * k, a.Y * k); }
    public static double operator *(V a, V b) { return a.X * b.X + a.Y * b.Y; }
    public static V operator -(V a) { return new V(-a.X, -a.Y); }
    public static V operator ++(V a) { return new V(a.X + 1, a.Y + 1); }
    public static bool operator ==(V a, V b) { return a.X == b.X && a.Y == b.Y; }
    public static bool operator !=(V a, V b) { return !(a == b); }
    public override bool Equals(object o) { return o is V && (V)o == this; }
    public override int GetHashCode() { return X.GetHashCode() ^ Y.GetHashCode(); }
    public override string ToString() { return "(" + X + "; " + Y + ")"; }
    public double Dot(V v) { return X * v.X + Y * v.Y; }
    public static V Same(V v) { return v; }
    public static V Swapped(V v) { return new V(v.Y, v.X); }
    public bool Unitize()
    {
        double n = Length;
        if (!(n > 0)) return false;
        X /= n;
        Y /= n;
        return true;
    }
    public void Add(V v) { X += v.X; Y += v.Y; }
    public void AddTwice(V v) { Add(v); this.Add(v); v.X = 1000; X += v.X - 1000; }
    public double Bump() { X += 1; return X; }
    public V Moved(double d) { X += d; return this; }
    public void Become(V v) { this = v; Y++; }
    public void Turn() { this = new V(-Y, X); }
    public int Sign()
    {
        if (X > 0) { if (Y > 0) return 1; return 2; }
        else if (X < 0) return 3;
        return 4;
    }
    public bool Clamp(double least, double most)
    {
        bool changed = false;
        if (X < least) { X = least; changed = true; }
        if (X > most) { X = most; changed = true; }
        return changed;
    }
    public void Late(bool fails) { X = 77; if (fails) throw new InvalidOperationException("late"); Y = 78; }
    public double Guarded(int d) { X = 5; int q = 10 / d; Y = q; return Y; }
}

struct Named
{
    public string Name;
    public int Count;
    public List<int> All;
    public void More() { Count++; if (All == null) All = new List<int>(); All.Add(Count); Name += "!"; }
}

struct Auto { public int A { get; set; } public int B { get; private set; } public Auto(int a) : this() { A = a; B = a * 2; } }
struct Wide { public int A, B, C, D, E; }
struct Inner { public V At; public int N; }
struct Box<T> { public T Item; public int N; public Box(T item) { Item = item; N = 1; } public void Put(T item) { Item = item; N++; } }

class Holder { public V At = new V(1, 2); public V Auto { get; set; } public static V Shared = new V(9, 9); }

class P
{
    static void Set(ref V v) { v.X = 42; }
    static void Make(out V v) { v = new V(6, 7); }
    static double Look(in V v) { return v.X; }
    static V Changed(V v) { v.X = -1; v.Add(new V(0, 5)); return v; }
    static string Three(V a, double b, V c) { return a + " " + b + " " + c; }
    static V Call(Func<V> f) { return f(); }
    static IEnumerable<V> Walk(int n) { V v = new V(0, 0); for (int i = 0; i < n; i++) { v.Add(new V(1, i)); yield return v; } }
    static double Deep(int n, V v) { if (n == 0) return v.X; V w = v; w.X += 1; return Deep(n - 1, w) + w.Y; }

    static void Main()
    {
        V a = new V(3, 4), b = a;
        b.X = 10;
        Console.WriteLine(a + " " + b);
        a = new V(a.Y, a.X);
        Console.WriteLine(a);
        V t = a; a = b; b = t;
        Console.WriteLine(a + " " + b);
        a = V.Swapped(a);
        a = V.Same(a);
        b = V.Swapped(b) + a;
        Console.WriteLine(a + " " + b);
        a += b; a *= 2; a -= a * 0.5;
        Console.WriteLine(a);
        Console.WriteLine(a.Unitize() + " " + a.Length.ToString("F6"));
        V zero = new V();
        Console.WriteLine(zero.Unitize() + " " + zero);
        V late;
        late.X = 1;
        late.Y = late.X + 1;
        Console.WriteLine(late);
        late.Add(late);
        Console.WriteLine(late);
        late.AddTwice(late);
        Console.WriteLine(late);
        V again = late;
        again.Add(++again);
        again.Become(again = again + late);
        Console.WriteLine(again + " " + again.Dot(again = new V(1, 2)) + " " + again);
        V p = late++;
        V q = ++late;
        Console.WriteLine(p + " " + q + " " + late);
        Console.WriteLine(Three(late, late.Bump(), late));
        Console.WriteLine(late.X + late.Bump() + late.X);
        Console.WriteLine(late.X - (late.X = 2) + late.X);
        Console.WriteLine(Three(late, (late = new V(1, 1)).X, late));
        V moved = late.Moved(3);
        moved.Y = 0;
        Console.WriteLine(late + " " + moved);
        late.Become(moved);
        Console.WriteLine(late);
        late.Turn(); late.Turn();
        Console.WriteLine(late + " " + late.Sign() + new V(1, 1).Sign() + new V(1, -1).Sign() + new V(0, 0).Sign());
        Console.WriteLine(late.Clamp(0, 1) + " " + late + " " + late.Clamp(-5, 5));
        late.Sum = 10;
        late[1] = 3;
        late[0] += 2;
        Console.WriteLine(late + " " + late.Sum + " " + late[0]);
        Set(ref late);
        Console.WriteLine(late + " " + Look(in late));
        V made;
        Make(out made);
        Make(out V other);
        other.X += made.Y;
        Console.WriteLine(made + " " + other);
        Console.WriteLine(Changed(made) + " " + made);
        object boxed = made;
        made.X = 0;
        Console.WriteLine(boxed + " " + made + " " + boxed.Equals(made) + " " + made.Equals(new V(0, 7)));
        V? maybe = made;
        made.Y = 1;
        Console.WriteLine(maybe.Value + " " + made + " " + (maybe == made));
        V caught = new V(1, 1);
        try { caught.Late(true); caught = new V(8, 8); } catch (InvalidOperationException e) { Console.WriteLine(e.Message + " " + caught); }
        try { caught = new V(2, caught.Guarded(0)); } catch (DivideByZeroException) { Console.WriteLine("zero " + caught); } finally { caught.X = 3; }
        Console.WriteLine(caught);
        try { caught.Add(++caught); Console.WriteLine(caught.Dot(caught = new V(3, 1))); } finally { caught.Become(caught = caught + caught); }
        Console.WriteLine(caught);
        try { V own = new V(1, 2); own.Add(own); Console.WriteLine(own); own.Late(true); } catch (Exception e) { Console.WriteLine(e.Message); }
        V shared = new V(1, 1);
        Action grow = () => { shared.X *= 2; shared.Add(new V(1, 1)); };
        grow(); grow();
        shared.Y = new V(1, 2) * shared++;
        shared.X += shared++.Y;
        Console.WriteLine(shared);
        Func<V> fresh = () => { V inside = shared; inside.Y = 0; inside.Bump(); return inside; };
        Console.WriteLine(Call(fresh) + " " + shared);
        var list = new List<V> { new V(1, 2), new V(3, 4) };
        V first = list[0];
        first.X = 50;
        list.Add(first);
        first.X = 51;
        list[1] = first;
        foreach (V v in list) Console.Write(v + " ");
        Console.WriteLine();
        V[] array = { new V(1, 1), new V(2, 2) };
        V from = array[0];
        array[0].X = 9;
        array[1].Add(from);
        from = array[1];
        array[1].Bump();
        Console.WriteLine(from + " " + array[0] + " " + array[1]);
        V total = new V();
        foreach (V v in array) { V w = v; w.Bump(); total += w; }
        foreach (V v in Walk(3)) total += v;
        Console.WriteLine(total);
        Holder holder = new Holder();
        V at = holder.At;
        holder.At.X = 70;
        at.Y = 71;
        holder.Auto = at;
        at.X = 72;
        V stat = Holder.Shared;
        Holder.Shared.X = 1;
        Console.WriteLine(at + " " + holder.At + " " + holder.Auto + " " + stat + " " + Holder.Shared);
        for (int i = 0; i < 3; i++)
        {
            V each;
            if (i % 2 == 0) each = new V(i, i); else each = at;
            V picked = i > 1 ? each : -each;
            each = i == 0 ? each + each : picked;
            Console.Write(each + " " + picked + " ");
        }
        Console.WriteLine();
        V turn = new V(1, 0);
        int turns = 0;
        while (turn.Bump() < 6 && turns++ < 100) turn.Add(new V(0, turn.X));
        do { turn.Y -= 7; } while (turn.Y > 0);
        Console.WriteLine(turn + " " + turns);
        Named named = new Named();
        named.Name = "n";
        named.More();
        Named copy = named;
        copy.More();
        Console.WriteLine(named.Name + named.Count + named.All.Count + " " + copy.Name + copy.Count + copy.All.Count);
        Auto auto = new Auto(4);
        auto.A++;
        Auto then = auto;
        then.A = 100;
        Console.WriteLine(auto.A + " " + auto.B + " " + then.A);
        Wide wide = new Wide();
        wide.E = 5;
        Wide wider = wide;
        wider.E++;
        Console.WriteLine(wide.E + " " + wider.E);
        Inner inner = new Inner();
        inner.At.X = 4;
        inner.At.Bump();
        Inner outer = inner;
        outer.At.Bump();
        outer.N = 2;
        Console.WriteLine(inner.At + " " + outer.At + " " + inner.N + outer.N);
        Box<V> box = new Box<V>(inner.At);
        box.Put(outer.At);
        Box<string> word = new Box<string>("w");
        Box<string> words = word;
        words.Put("z");
        Console.WriteLine(box.Item + " " + box.N + " " + word.Item + word.N + words.Item + words.N);
        Console.WriteLine(Deep(4, new V(1, 0.5)));
        V x = new V(1, 2), y = new V(3, 4);
        (x, y) = (y, x);
        Console.WriteLine(x + " " + y);
        x.X = y.X = 6;
        x = y = new V(7, 8);
        y.X = 0;
        Console.WriteLine(x + " " + y + " " + (x == y) + (x != y) + (x * y));
        double sum = 0;
        V pos = new V(0, 0), dir = new V(1, 2);
        for (int i = 0; i < 1000; i++)
        {
            V step = dir;
            step.Unitize();
            pos = pos + step * 0.5;
            dir = new V(dir.Y, -dir.X) + pos * 0.001;
            sum += pos.Length + step * dir;
        }
        Console.WriteLine(sum.ToString("F9"));
        string said = $"{pos.X:F3} {dir}";
        Console.WriteLine(said.Length > 5);
        switch (x.Sign()) { case 1: V s = x; s.X = 0; Console.WriteLine(s + " " + x); break; default: Console.WriteLine("?"); break; }
    }
}
