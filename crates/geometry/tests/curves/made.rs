//! Curves that several of these tests begin with.

use katydid_geometry::{
    Arc, Circle, Curve, KnotSpacing, Line, NurbsCurve, Plane, Point3, PolyCurve, PolylineCurve, Vector3,
};

pub(super) fn p(x: f64, y: f64, z: f64) -> Point3 {
    Point3::new(x, y, z)
}

pub(super) fn line(a: Point3, b: Point3) -> Curve {
    Line::new(a, b).into()
}

pub(super) fn polyline(points: &[(f64, f64)]) -> Curve {
    PolylineCurve::new(points.iter().map(|&(x, y)| p(x, y, 0.0)).collect()).unwrap().into()
}

pub(super) fn circle(r: f64) -> Curve {
    Circle::new(Plane::XY, r).unwrap().into()
}

pub(super) fn wave() -> Curve {
    let points: Vec<_> = (0..12)
        .map(|i| p(f64::from(i), 3.0 * (f64::from(i) * 1.3).sin(), (f64::from(i) * 0.7).cos()))
        .collect();
    NurbsCurve::interpolate(3, &points, KnotSpacing::Chord, None, None).unwrap().into()
}

/// A line, an arc tangent to it and a spline, end to end.
pub(super) fn chain() -> Curve {
    let arc = Arc::from_start_direction_end(p(4.0, 0.0, 0.0), Vector3::X, p(6.0, 2.0, 0.0)).unwrap();
    let spline =
        NurbsCurve::bezier(&[p(6.0, 2.0, 0.0), p(6.0, 4.0, 1.0), p(8.0, 4.0, 2.0), p(9.0, 9.0, 0.0)]);
    PolyCurve::new(vec![line(p(0.0, 0.0, 0.0), p(4.0, 0.0, 0.0)), arc.into(), spline.unwrap().into()])
        .unwrap()
        .into()
}
