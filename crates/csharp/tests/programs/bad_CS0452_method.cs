class P { static void F<T>(T x) where T : class { } static void Main() { F(3); } }
