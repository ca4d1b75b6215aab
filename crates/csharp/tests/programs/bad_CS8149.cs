class P { static int s; static int F() { return ref s; } static void Main() { F() = 1; } }
