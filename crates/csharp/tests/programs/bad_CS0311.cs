using System; class A<T> where T : IDisposable { } class B { } class P { static void Main() { A<B> a = null; } }
