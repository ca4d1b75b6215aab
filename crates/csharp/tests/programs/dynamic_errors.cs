using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class A { private int p = 1; public int X { get { return p; } } public void F(int x) { } }
class P { static void Try(Action a) { try { a(); Console.WriteLine("none"); } catch (Exception e) { Console.WriteLine(e.GetType().Name); } } static void Main() { dynamic d = new A(), n = null, i = 5; Try(() => { var x = d.Nope; }); Try(() => { d.F("s"); }); Try(() => { d.F(); }); Try(() => { var x = n.Length; }); Try(() => { string s = i; }); Try(() => { var x = i + d; }); Try(() => { d.X = 5; }); Try(() => { i.Foo(); }); Try(() => { var x = i[0]; }); Try(() => { int x = (int)"s".Length; d.F(x); }); Try(() => { bool b = i; }); } }
