class P { static void F(object x = new object()) { } static void Main() { F(); } }
