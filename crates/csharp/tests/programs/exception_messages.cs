using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class Program
{
    static void Main()
    {
        Action[] bad = { () => { int[] a = new int[1]; a[1] = 0; }, () => { object o = null; o.ToString(); }, () => { int z = 0; Console.WriteLine(1 % z); }, () => int.Parse(""), () => new List<int>()[0].ToString(), () => new Dictionary<int, int>().First(), () => "abc".Substring(5), () => { throw new ArgumentNullException("p"); }, () => { throw new ArgumentOutOfRangeException("q"); }, () => { throw new NotImplementedException(); }, () => Enumerable.Empty<int>().Average(), () => new[] { 1, 2 }.Single(), () => new Queue<int>().Dequeue(), () => checked(int.MaxValue * int.Parse("2")).ToString() }; foreach (var f in bad) { try { f(); Console.WriteLine("none"); } catch (Exception e) { Console.WriteLine(e.GetType().Name); } }
    }
}
