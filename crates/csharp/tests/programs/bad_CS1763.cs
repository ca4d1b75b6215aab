class P { static void F(object x = "a") { } static void Main() { F(); } }
