class P { static void Main() { int x=1; const int c = 4; ref int r = ref c; } }
