class P { static ref int F() { return ref 5; } static void Main() { F() = 1; } }
