using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class Res : IDisposable { string n; public Res(string n) { this.n = n; Console.WriteLine("open " + n); } public void Dispose() { Console.WriteLine("close " + n); } }
class P {
 static IEnumerable<int> Gen(int n) { using (new Res("gen")) { try { for (int i = 0; i < n; i++) { Console.WriteLine("yield " + i); yield return i; } } finally { Console.WriteLine("finally"); } } }
 static IEnumerable<int> Nested() { foreach (int x in Gen(2)) yield return x * 2; yield return 99; }
 static IEnumerator<string> Names() { yield return "x"; yield return "y"; }
 static void Main() {
  foreach (int x in Gen(3)) { if (x == 1) break; Console.WriteLine("got " + x); } Console.WriteLine("--");
  foreach (int x in Nested()) Console.WriteLine(x); Console.WriteLine("--"); Console.WriteLine(Gen(5).First()); Console.WriteLine("--"); Console.WriteLine(string.Join(",", Gen(3).Take(2))); Console.WriteLine("--");
  var e = Gen(2).GetEnumerator(); e.MoveNext(); e.Dispose(); Console.WriteLine(e.MoveNext()); Console.WriteLine("--"); try { foreach (int x in Gen(3)) throw new Exception("mid"); } catch (Exception ex) { Console.WriteLine(ex.Message); }
  var it = Gen(1); foreach (var q in it) { } foreach (var q in it) { } var names = Names(); while (names.MoveNext()) Console.Write(names.Current); Console.WriteLine(); Func<IEnumerable<int>> lazy = () => Gen(1); var unused = lazy(); Console.WriteLine("lazy"); using (var r = new Res("a")) using (var r2 = new Res("b")) { Console.WriteLine("in"); } Console.WriteLine(Gen(4).Skip(1).Where(x => x % 2 == 1).Count());
 } }
