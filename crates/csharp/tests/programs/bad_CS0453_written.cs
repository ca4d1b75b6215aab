class P { static void Main() { System.Nullable<string> x = null; } }
