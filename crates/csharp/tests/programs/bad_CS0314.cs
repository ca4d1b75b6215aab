using System; class A<T> where T : IDisposable { } class B<U> { A<U> x; } class P { static void Main() { } }
