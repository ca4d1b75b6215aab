using System.Collections.Generic; class P { static void Main() { List<int,int> x = null; } }
