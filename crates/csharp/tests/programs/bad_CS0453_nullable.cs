class P { static void F<T>() where T : struct { } static void Main() { F<int?>(); } }
