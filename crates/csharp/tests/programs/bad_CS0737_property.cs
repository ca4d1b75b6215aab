interface I { int F { get; } } class A : I { internal int F { get { return 1; } } } class P { static void Main() { } }
