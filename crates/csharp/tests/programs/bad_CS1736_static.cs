class P { static int s = 3; static void F(int x = s) { } static void Main() { F(); } }
