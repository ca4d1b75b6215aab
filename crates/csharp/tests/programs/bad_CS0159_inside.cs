class P { static void Main() { goto a; { a: System.Console.WriteLine(1); } } }
