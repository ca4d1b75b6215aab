class E : System.Enum { } class P { static void Main() { } }
