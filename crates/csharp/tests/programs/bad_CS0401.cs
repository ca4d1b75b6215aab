class A<T> where T : new(), System.IDisposable { } class P { static void Main() { } }
