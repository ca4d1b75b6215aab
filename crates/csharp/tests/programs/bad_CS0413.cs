class A<T> { T M(object o) { return o as T; } } class P { static void Main() { } }
