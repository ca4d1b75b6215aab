class P { static void F(int x = "a") { } static void Main() { F(); } }
