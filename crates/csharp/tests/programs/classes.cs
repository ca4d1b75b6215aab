using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

abstract class Shape { public string Name { get; set; } public abstract double Area(); public virtual string Describe() { return Name + " " + Area().ToString("F2"); } protected Shape(string n) { Name = n; count++; } static int count = 0; public static int Count { get { return count; } } }
class Circle : Shape { readonly double r; public Circle(double r) : base("circle") { this.r = r; } public override double Area() { return Math.PI * r * r; } }
class Square : Shape { public double Side; public Square() : this(2) { } public Square(double s) : base("square") { Side = s; } public override double Area() => Side * Side; public override string Describe() { return "[" + base.Describe() + "]"; } }
sealed class Cube : Square { public Cube(double s) : base(s) { Name = "cube"; } public new double Area() { return -1; } }

static class Program
{
    static void Main()
    {
        var shapes = new List<Shape> { new Circle(1), new Square(), new Cube(3) }; foreach (var s in shapes) Console.WriteLine(s.Describe()); Console.WriteLine(Shape.Count + " " + new Cube(3).Area() + " " + (shapes[2] is Square) + " " + (shapes[0] as Square == null)); Square q = (Square)shapes[1]; q.Side = 5; Console.WriteLine(shapes[1].Area()); try { var bad = (Circle)shapes[1]; } catch (InvalidCastException) { Console.WriteLine("bad cast"); } Console.WriteLine(shapes[2].GetType().Name + " " + shapes[2].GetType());
    }
}
