class B { } class P { static void Main() { B<int> x = null; } }
