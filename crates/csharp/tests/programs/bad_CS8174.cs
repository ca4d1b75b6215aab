class P { static void Main() { ref int r; } }
