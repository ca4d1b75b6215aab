using System;
class A { public event Action E; public void R() { E(); } }
class P { static void Main() { var a = new A(); a.E = null; } }
