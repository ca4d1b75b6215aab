class P { public static virtual void F() { } static void Main() { } }
