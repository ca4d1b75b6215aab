using System; class A<T> where T : IDisposable, IDisposable { } class P { static void Main() { } }
