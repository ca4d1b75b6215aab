using System; class B { } class P { static void F<T>(T x) where T : IDisposable { } static void Main() { F(new B()); } }
