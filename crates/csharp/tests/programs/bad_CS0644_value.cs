class E : System.ValueType { } class P { static void Main() { } }
