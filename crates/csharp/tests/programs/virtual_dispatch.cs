using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class A { public virtual string F() { return "A"; } public string G() { return F() + H(); } public virtual string H() { return "h"; } } class B : A { public override string F() { return "B" + base.F(); } } class C : B { public override string F() { return "C" + base.F(); } public new string G() { return "new"; } public sealed override string H() { return "c"; } }
abstract class T { public string Run() { return Pre() + Body() + Post; } protected virtual string Pre() { return "<"; } protected abstract string Body(); protected virtual string Post { get { return ">"; } } } class U : T { protected override string Body() { return "u"; } protected override string Post { get { return base.Post + "!"; } } }

static class Program
{
    static void Main()
    {
        A a = new C(); Console.WriteLine(a.F() + " " + a.G() + " " + ((C)a).G() + " " + new B().G()); Console.WriteLine(new U().Run()); A[] all = { new A(), new B(), new C() }; Console.WriteLine(string.Join(",", all.Select(x => x.F())));
    }
}
