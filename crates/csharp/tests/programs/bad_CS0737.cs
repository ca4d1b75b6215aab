interface I { void F(); } class A : I { void F() { } } class P { static void Main() { } }
