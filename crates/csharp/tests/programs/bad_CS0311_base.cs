class A<T> where T : A<T> { } class B : A<B> { } class C : A<int[]> { } class P { static void Main() { } }
