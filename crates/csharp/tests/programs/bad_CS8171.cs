class P { static void Main() { int x = 1; int r = ref x; } }
