class P { static void Main() { int x = 1; ref long r = ref x; } }
