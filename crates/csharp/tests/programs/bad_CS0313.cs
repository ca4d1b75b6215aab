using System; class A<T> where T : IComparable { } class P { static void Main() { A<int?> a = null; } }
