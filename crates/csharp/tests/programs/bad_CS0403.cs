class A<T> { T M() { return null; } } class P { static void Main() { } }
