using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class Program
{
    static void Main()
    {
        object[] os = { 1, 2L, 3.5, 'c', "s", true, (byte)7, 2.5f, DayOfWeekLike.B }; foreach (var o in os) Console.WriteLine(o.GetType().Name + " " + o + " " + (o is int) + (o is double) + (o is IComparable) + (o is string)); try { long l = (long)os[0]; Console.WriteLine(l); } catch (InvalidCastException) { Console.WriteLine("no unbox to another type"); } Console.WriteLine((double)(int)os[0] + (float)os[7]); 
        } enum DayOfWeekLike { A, B } static void Unused() {
    }
}
