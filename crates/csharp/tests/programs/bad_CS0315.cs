using System; class A<T> where T : IDisposable { } class P { static void Main() { A<int> a = null; } }
