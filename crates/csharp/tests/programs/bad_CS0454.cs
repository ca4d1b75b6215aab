class A<T, U> where T : U where U : T { } class P { static void Main() { } }
