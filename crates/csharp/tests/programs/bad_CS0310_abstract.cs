abstract class B { } class P { static T Make<T>() where T : new() { return new T(); } static void Main() { Make<B>(); } }
