using System; class A<T> where T : IDisposable where T : new() { } class P { static void Main() { } }
