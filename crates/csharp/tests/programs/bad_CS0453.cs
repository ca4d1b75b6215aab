class A<T> where T : struct { } class P { static A<string> f; static void Main() { } }
