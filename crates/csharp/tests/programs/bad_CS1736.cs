class P { static int g() { return 1; } static void F(int x = g()) { } static void Main() { F(); } }
