using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class Log { public static int N; public static int Say(string s) { Console.WriteLine(++N + " " + s); return N; } } class A { int a = Log.Say("A.a"); public A() : this(1) { Log.Say("A()"); } public A(int x) { Log.Say("A(int)"); V(); } public virtual void V() { Log.Say("A.V"); } } class B : A { int b = Log.Say("B.b"); public B() { Log.Say("B()"); } public B(string s) : base(5) { Log.Say("B(string)"); } public override void V() { Log.Say("B.V " + b); } }
class P { static void Main() { new B(); new B("x"); new A(3); var x = new B { }; } }
