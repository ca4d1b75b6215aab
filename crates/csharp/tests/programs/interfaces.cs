using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

interface IShape { double Area { get; } string Name(); }
class Sq : IShape, IComparable<Sq> { public double S; public double Area { get { return S * S; } } string IShape.Name() { return "explicit"; } public string Name() { return "implicit"; } public int CompareTo(Sq o) { return S.CompareTo(o.S); } }
class Bag : IEnumerable<int> { public IEnumerator<int> GetEnumerator() { yield return 1; yield return 2; } System.Collections.IEnumerator System.Collections.IEnumerable.GetEnumerator() { return GetEnumerator(); } }
class Res : IDisposable { string n; public Res(string n) { this.n = n; Console.WriteLine("open " + n); } public void Dispose() { Console.WriteLine("close " + n); } }

static class Program
{
    static void Main()
    {
        IShape s = new Sq { S = 3 }; Console.WriteLine(s.Area + " " + s.Name() + " " + ((Sq)s).Name()); var l = new List<Sq> { new Sq { S = 3 }, new Sq { S = 1 } }; l.Sort(); Console.WriteLine(l[0].S); foreach (int x in new Bag()) Console.Write(x + " "); Console.WriteLine(new Bag().Sum()); using (var r = new Res("a")) using (var r2 = new Res("b")) { Console.WriteLine("in"); } try { using (new Res("c")) throw new Exception("x"); } catch (Exception e) { Console.WriteLine(e.Message); }
    }
}
