static class S { } class P { static void Main() { System.Collections.Generic.List<S> x = null; } }
