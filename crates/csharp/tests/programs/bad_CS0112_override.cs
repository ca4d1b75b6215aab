class P { public static override string ToString() { return ""; } static void Main() { } }
