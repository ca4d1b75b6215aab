class P { static void F(ref int x = 3) { } static void Main() { } }
