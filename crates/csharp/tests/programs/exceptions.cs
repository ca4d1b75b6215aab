using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class My : Exception { public int Code; public My(int c, string m) : base(m) { Code = c; } }
static class X { public static int F(int n) { try { if (n == 0) throw new My(7, "zero"); return n; } catch (My e) when (e.Code == 7) { Console.WriteLine("my " + e.Code + " " + e.Message); return -1; } finally { Console.WriteLine("fin " + n); } } public static void Deep(int n) { if (n == 0) throw new InvalidOperationException("deep"); try { Deep(n - 1); } finally { Console.Write("u" + n + " "); } } public static int Loop() { for (int i = 0; ; i++) { try { if (i == 2) continue; if (i == 4) break; Console.Write(i + " "); } finally { Console.Write("f" + i + " "); } } return 5; } }

static class Program
{
    static void Main()
    {
        Console.WriteLine(X.F(0) + " " + X.F(3)); try { X.Deep(3); } catch (Exception e) { Console.WriteLine(e.GetType().Name + " " + e.Message); } Console.WriteLine(X.Loop()); try { try { throw new ArgumentException("a", "p"); } catch (ArgumentException e) { throw new ApplicationException("outer", e); } } catch (ApplicationException e) { Console.WriteLine(e.Message + " <- " + e.InnerException.GetType().Name); } try { try { throw new Exception("r"); } catch { throw; } } catch (Exception e) { Console.WriteLine("again " + e.Message); } try { string s = null; Console.WriteLine(s.Length); } catch (NullReferenceException) { Console.WriteLine("null"); } try { object o = "x"; int i = (int)o; } catch (InvalidCastException) { Console.WriteLine("cast"); } try { throw new My(1, "unfiltered"); } catch (My e) when (e.Code == 2) { Console.WriteLine("no"); } catch (Exception e) { Console.WriteLine("yes " + e.Message); }
    }
}
