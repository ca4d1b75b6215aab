class A<T> where T : System.Array { } class P { static void Main() { } }
