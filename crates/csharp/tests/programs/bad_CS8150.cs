class P { static int s; static ref int F() { return s; } static void Main() { F() = 1; } }
