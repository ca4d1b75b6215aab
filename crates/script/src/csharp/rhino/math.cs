namespace Rhino
{
    public static class RhinoMath
    {
        public const double UnsetValue = -1.23432101234321e+308;
        public const float UnsetSingle = -1.234321e+38f;
        public const int UnsetIntIndex = -2147483647;
        public const double ZeroTolerance = 2.3283064365386962890625e-10;
        public const double SqrtEpsilon = 1.490116119385e-8;
        public const double Epsilon = 2.2204460492503131e-16;
        public const double DefaultDistanceToleranceMillimeters = 0.01;
        public const double DefaultAngleTolerance = Math.PI / 180.0;
        public const double TwoPI = 2.0 * Math.PI;
        public const double HalfPI = 0.5 * Math.PI;
        public static double ToRadians(double degrees) { return degrees * Math.PI / 180.0; }
        public static double ToDegrees(double radians) { return radians * 180.0 / Math.PI; }
        public static bool IsValidDouble(double x) { return x != UnsetValue && !double.IsNaN(x) && !double.IsInfinity(x); }
        public static bool EpsilonEquals(double x, double y, double epsilon) { return Math.Abs(x - y) <= epsilon; }
        public static double Clamp(double x, double a, double b) { return x < a ? a : x > b ? b : x; }
        public static int Clamp(int x, int a, int b) { return x < a ? a : x > b ? b : x; }
    }
}
namespace Rhino.Geometry
{
    public struct Interval : IEquatable<Interval>
    {
        public double T0; public double T1;
        public Interval(double t0, double t1) { T0 = t0; T1 = t1; }
        public Interval(Interval other) { T0 = other.T0; T1 = other.T1; }
        public static Interval Unset { get { return new Interval(RhinoMath.UnsetValue, RhinoMath.UnsetValue); } }
        public double this[int i] { get { return i == 0 ? T0 : i == 1 ? T1 : throw new IndexOutOfRangeException(); } set { if (i == 0) T0 = value; else if (i == 1) T1 = value; else throw new IndexOutOfRangeException(); } }
        public double Min { get { return T0 <= T1 ? T0 : T1; } }
        public double Max { get { return T0 <= T1 ? T1 : T0; } }
        public double Mid { get { return T0 == T1 ? T0 : 0.5 * (T0 + T1); } }
        public double Length { get { return T1 - T0; } }
        public bool IsValid { get { return RhinoMath.IsValidDouble(T0) && RhinoMath.IsValidDouble(T1); } }
        public bool IsSingleton { get { return IsValid && T0 == T1; } }
        public bool IsIncreasing { get { return IsValid && T0 < T1; } }
        public bool IsDecreasing { get { return IsValid && T0 > T1; } }
        public double ParameterAt(double t) { return (1 - t) * T0 + t * T1; }
        public Interval ParameterIntervalAt(Interval t) { return new Interval(ParameterAt(t.T0), ParameterAt(t.T1)); }
        public double NormalizedParameterAt(double x) { return T0 == T1 ? T0 : x == T1 ? 1.0 : (x - T0) / (T1 - T0); }
        public Interval NormalizedIntervalAt(Interval t) { return new Interval(NormalizedParameterAt(t.T0), NormalizedParameterAt(t.T1)); }
        public bool IncludesParameter(double t) { return t >= Min && t <= Max; }
        public bool IncludesParameter(double t, bool strict) { return strict ? t > Min && t < Max : IncludesParameter(t); }
        public bool IncludesInterval(Interval i) { return IncludesParameter(i.T0) && IncludesParameter(i.T1); }
        public bool IncludesInterval(Interval i, bool strict) { return IncludesParameter(i.T0, strict) && IncludesParameter(i.T1, strict); }
        public void MakeIncreasing() { if (T0 > T1) Swap(); }
        public void Swap() { double t = T0; T0 = T1; T1 = t; }
        public void Reverse() { double t = T0; T0 = -T1; T1 = -t; }
        public void Grow(double t) { if (!IsValid) { T0 = t; T1 = t; return; } MakeIncreasing(); if (t < T0) T0 = t; if (t > T1) T1 = t; }
        public static Interval FromUnion(Interval a, Interval b) { return new Interval(Math.Min(a.Min, b.Min), Math.Max(a.Max, b.Max)); }
        public static Interval FromIntersection(Interval a, Interval b) { double s = Math.Max(a.Min, b.Min), e = Math.Min(a.Max, b.Max); return s <= e ? new Interval(s, e) : Unset; }
        public bool EpsilonEquals(Interval o, double e) { return Math.Abs(T0 - o.T0) <= e && Math.Abs(T1 - o.T1) <= e; }
        public static Interval operator +(Interval a, double x) { return new Interval(a.T0 + x, a.T1 + x); }
        public static Interval operator +(double x, Interval a) { return a + x; }
        public static Interval operator -(Interval a, double x) { return new Interval(a.T0 - x, a.T1 - x); }
        public static bool operator ==(Interval a, Interval b) { return a.T0 == b.T0 && a.T1 == b.T1; }
        public static bool operator !=(Interval a, Interval b) { return !(a == b); }
        public bool Equals(Interval o) { return this == o; }
        public override bool Equals(object o) { return o is Interval && (Interval)o == this; }
        public override int GetHashCode() { return T0.GetHashCode() ^ T1.GetHashCode(); }
        public override string ToString() { return T0 + "," + T1; }
    }
}
