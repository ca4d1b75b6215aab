class A<T> { T M() { return new T(); } } class P { static void Main() { } }
