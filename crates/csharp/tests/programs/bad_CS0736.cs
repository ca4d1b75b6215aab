interface I { void F(); } class A : I { public static void F() { } } class P { static void Main() { } }
