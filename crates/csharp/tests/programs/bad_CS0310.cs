class A<T> where T : new() { } class B { public B(int x) { } } class P { static void Main() { var a = new A<B>(); } }
