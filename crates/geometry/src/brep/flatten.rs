//! Curves in the coordinates of a plane.

use crate::thresholds;
use crate::{
    Arc, ArcCurve, Circle, Curve, Line, LineCurve, NurbsCurve, Plane, Point3, PolyCurve, PolylineCurve,
    Result, Vector3,
};

/// The shadow of a curve on a plane in the plane's coordinates: x and y, with z exactly 0. Exact; arcs that are
/// parallel to the plane stay arcs.
pub fn flattened(curve: &Curve, plane: &Plane) -> Result<Curve> {
    let at = |p: Point3| {
        let [x, y, _] = plane.coordinates(p);
        Point3::new(x, y, 0.0)
    };
    Ok(match curve {
        Curve::Line(c) => {
            LineCurve { line: Line::new(at(c.line.from), at(c.line.to)), domain: c.domain }.into()
        }
        Curve::Arc(c) => match flat_arc(c, plane) {
            Some(arc) => arc.into(),
            None => flattened(&c.to_nurbs()?.into(), plane)?,
        },
        Curve::Polyline(c) => {
            let points = c.points().iter().map(|p| at(*p)).collect();
            PolylineCurve::with_parameters(points, c.parameters().to_vec())?.into()
        }
        Curve::Nurbs(c) => {
            let points: Vec<Point3> = c.control_points().into_iter().map(at).collect();
            let knots = c.knots().to_vec();
            if c.is_rational() {
                NurbsCurve::with_weights(c.degree(), &points, &c.weights(), knots)?.into()
            } else {
                NurbsCurve::new(c.degree(), points, knots)?.into()
            }
        }
        Curve::Poly(c) => {
            let segments = c.segments().iter().map(|s| flattened(s, plane)).collect::<Result<_>>()?;
            PolyCurve::with_parameters(segments, c.parameters().to_vec())?.into()
        }
    })
}

fn flat_arc(curve: &ArcCurve, plane: &Plane) -> Option<ArcCurve> {
    let own = &curve.arc.circle.plane;
    let side = own.z_axis.parallel_to(plane.z_axis, thresholds::PARALLEL);
    if side == 0 {
        return None;
    }
    let [x, y, _] = plane.coordinates(own.origin);
    let x_axis = Vector3::new(own.x_axis.dot(plane.x_axis), own.x_axis.dot(plane.y_axis), 0.0).unitized()?;
    let z_axis = Vector3::new(0.0, 0.0, f64::from(side));
    let y_axis = Vector3::new(-x_axis.y, x_axis.x, 0.0) * f64::from(side);
    let frame = Plane { origin: Point3::new(x, y, 0.0), x_axis, y_axis, z_axis };
    let circle = Circle { plane: frame, radius: curve.arc.circle.radius };
    Some(ArcCurve { arc: Arc { circle, angle: curve.arc.angle }, domain: curve.domain })
}
