using System; class B { } class A<T> where T : IDisposable, B { } class P { static void Main() { } }
