static class __Shown
{
    public static string Of(object value) { return value == null ? "" : value.ToString(); }
}
namespace Rhino
{
    [Native] public class RhinoDoc
    {
        internal static RhinoDoc __active = new RhinoDoc();
        public static RhinoDoc ActiveDoc { get { return __active; } }
        public extern double ModelAbsoluteTolerance { get; }
        public extern double ModelAngleToleranceRadians { get; }
        public extern double ModelAngleToleranceDegrees { get; }
        extern int raw_get_UnitNumber();
        public UnitSystem ModelUnitSystem { get { return (UnitSystem)raw_get_UnitNumber(); } }
    }
}
namespace Rhino.Display
{
    using Rhino.Geometry;
    using System.Drawing;
    // What scripts draw themselves is not drawn: these are never called.
    public class DisplayPipeline
    {
        public extern void DrawCurve(Curve curve, Color color);
        public extern void DrawCurve(Curve curve, Color color, int thickness);
        public extern void DrawLine(Line line, Color color);
        public extern void DrawLine(Line line, Color color, int thickness);
        public extern void DrawLine(Point3d from, Point3d to, Color color);
        public extern void DrawLine(Point3d from, Point3d to, Color color, int thickness);
        public extern void DrawArrow(Line line, Color color);
        public extern void DrawPoint(Point3d point, Color color);
        public extern void DrawPolyline(IEnumerable<Point3d> points, Color color);
        public extern void DrawPolyline(IEnumerable<Point3d> points, Color color, int thickness);
        public extern void DrawCircle(Circle circle, Color color);
        public extern void DrawCircle(Circle circle, Color color, int thickness);
        public extern void DrawSphere(Sphere sphere, Color color);
        public extern void DrawBox(Box box, Color color);
        public extern void DrawMeshWires(Mesh mesh, Color color);
        public extern void DrawMeshFalseColors(Mesh mesh);
        public extern void Draw2dText(string text, Color color, Point3d at, bool middle, int height);
        public extern void Draw2dText(string text, Color color, Point3d at, bool middle, int height, string font);
    }
}
namespace System.Numerics
{
    public struct Complex
    {
        public double Real; public double Imaginary;
        public Complex(double re, double im) { Real = re; Imaginary = im; }
        public double Magnitude { get { return Math.Sqrt(Real * Real + Imaginary * Imaginary); } }
        public double Phase { get { return Math.Atan2(Imaginary, Real); } }
        public static Complex operator +(Complex a, Complex b) { return new Complex(a.Real + b.Real, a.Imaginary + b.Imaginary); }
        public static Complex operator -(Complex a, Complex b) { return new Complex(a.Real - b.Real, a.Imaginary - b.Imaginary); }
        public static Complex operator *(Complex a, Complex b) { return new Complex(a.Real * b.Real - a.Imaginary * b.Imaginary, a.Real * b.Imaginary + a.Imaginary * b.Real); }
        public override string ToString() { return "(" + Real + ", " + Imaginary + ")"; }
    }
}
