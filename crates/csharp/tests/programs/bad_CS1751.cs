class P { static void F(params int[] x = null) { } static void Main() { } }
