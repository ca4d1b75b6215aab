class P { static void Main() { int x=1; ref int r = ref x; System.Func<int> f = () => r; } }
