//! Curves of arcs that follow given directions.

use crate::thresholds;
use crate::{Arc, ArcCurve, Curve, Error, Line, LineCurve, Point3, PolyCurve, Result, Vector3};

/// Tangents with no larger sine between them have one direction.
const SAME_DIRECTION: f64 = 1e-10;

/// The arc that leaves `from` along a direction and ends at `to`; a line when the direction leads straight there.
///
/// # Errors
/// The points coincide, the direction is zero, or it leads straight away from the end.
pub fn tangent_arc(from: Point3, direction: Vector3, to: Point3) -> Result<Curve> {
    let chord = to - from;
    let (Some(d), Some(c)) = (direction.unitized(), chord.unitized()) else {
        return Err(Error::degenerate("tangent arc", "its ends coincide or its direction is zero"));
    };
    if d.cross(c).length() < SAME_DIRECTION && d.dot(c) > 0.0 {
        return Ok(LineCurve::new(Line::new(from, to)).into());
    }
    Ok(ArcCurve::new(Arc::from_start_direction_end(from, d, to)?).into())
}

/// Two arcs that join smoothly and have given directions at the ends: the first leaves `start` along `out`, the second
/// comes to `end` along `into`. Either may be a line.
///
/// `ratio`, between 0 and 1, is the share of the first arc's tangent length in both: with 0.5 they are equal. Bolton,
/// *Biarc curves*, Computer-Aided Design 7 (1975).
///
/// # Errors
/// Ends that coincide, a direction of zero, a ratio outside 0…1, and directions that no two arcs join (both straight
/// away from the other end).
pub fn biarc(start: Point3, out: Vector3, end: Point3, into: Vector3, ratio: f64) -> Result<[Curve; 2]> {
    if !(ratio > 0.0 && ratio < 1.0) {
        return Err(Error::OutOfRange { what: "ratio", value: ratio, must: "between 0 and 1" });
    }
    let (Some(t1), Some(t2)) = (out.unitized(), into.unitized()) else {
        return Err(Error::degenerate("biarc", "a direction is zero"));
    };
    let v = end - start;
    if !v.is_finite() || v.length() == 0.0 {
        return Err(Error::degenerate("biarc", "its ends coincide"));
    }
    // Control points lie d along the first direction and k·d against the second; the way between them is d + k·d long:
    // a quadratic for d with one positive root.
    let k = (1.0 - ratio) / ratio;
    let (a, b, c) = (2.0 * k * (t1.dot(t2) - 1.0), -2.0 * v.dot(t1 + t2 * k), v.length_squared());
    let d = if a > -thresholds::FEW_ROUNDINGS * (1.0 + k) {
        -c / b
    } else {
        // Both signs of b without cancellation: a < 0 < c.
        let root = (b * b - 4.0 * a * c).sqrt();
        if b < 0.0 { 2.0 * c / (-b + root) } else { (-b - root) / (2.0 * a) }
    };
    if !(d > 0.0 && d.is_finite()) {
        return Err(Error::degenerate("biarc", "its directions lead away from the other end"));
    }
    let (p, q) = (start + t1 * d, end - t2 * (k * d));
    let joint = p.lerp(q, ratio);
    let first = tangent_arc(start, t1, joint)?;
    // Arcs towards the joint are made from the end and turned round.
    let second = tangent_arc(end, -t2, joint)?.reversed();
    Ok([first, second])
}

/// Arcs from point to point, each smooth with the one before; the first leaves along `direction`, or is a line without
/// one. A closed chain ends with an arc to the first point.
///
/// # Errors
/// Fewer than two points, neighbours that coincide, and a point straight behind the direction there.
pub fn poly_arc(points: &[Point3], direction: Option<Vector3>, closed: bool) -> Result<Curve> {
    let (Some(&first), Some(&second)) = (points.first(), points.get(1)) else {
        return Err(Error::Invalid { what: "arc chain", why: "it needs at least two points".to_owned() });
    };
    let mut direction = direction.and_then(Vector3::unitized).unwrap_or(second - first);
    let mut pieces = Vec::with_capacity(points.len());
    let back = (closed && points.last() != Some(&first)).then_some(first);
    let mut from = first;
    for &to in points.iter().skip(1).chain(&back) {
        let piece = tangent_arc(from, direction, to)?;
        direction = piece.tangent_on_side(piece.domain().end, true).unwrap_or(direction);
        pieces.push(piece);
        from = to;
    }
    if pieces.len() == 1 {
        return pieces.pop().ok_or(Error::degenerate("arc chain", "it has no pieces"));
    }
    Ok(PolyCurve::new(pieces)?.into())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(start: Point3, out: Vector3, end: Point3, into: Vector3, ratio: f64) {
        let [a, b] = biarc(start, out, end, into, ratio).unwrap();
        assert!(a.start().distance_to(start) < 1e-9 && b.end().distance_to(end) < 1e-9);
        assert!(a.end().distance_to(b.start()) < 1e-9, "{a:?} {b:?}");
        let tangent = |c: &Curve, t: f64, below| c.tangent_on_side(t, below).unwrap();
        assert!((tangent(&a, a.domain().start, false) - out.unitized().unwrap()).length() < 1e-8);
        assert!((tangent(&b, b.domain().end, true) - into.unitized().unwrap()).length() < 1e-8);
        let joint = tangent(&a, a.domain().end, true) - tangent(&b, b.domain().start, false);
        assert!(joint.length() < 1e-7, "{ratio} {joint:?}");
    }

    #[test]
    fn biarcs_are_smooth() {
        let (o, e) = (Point3::ORIGIN, Point3::new(4.0, 1.0, 0.0));
        for ratio in [0.2, 0.5, 0.7] {
            check(o, Vector3::Y, e, Vector3::X, ratio);
            check(o, Vector3::Y, e, Vector3::Y, ratio);
            check(o, Vector3::new(1.0, 1.0, 0.0), e, Vector3::new(1.0, -2.0, 0.0), ratio);
            check(o, Vector3::Z, e, Vector3::X, ratio);
            check(o, -Vector3::X, e, Vector3::X, ratio);
        }
        // A half circle of radius 2 is one of two equal arcs.
        let [a, b] = biarc(o, Vector3::Y, Point3::new(4.0, 0.0, 0.0), -Vector3::Y, 0.5).unwrap();
        assert!((a.length() - std::f64::consts::PI).abs() < 1e-12 && (b.length() - a.length()).abs() < 1e-12);
        let straight = biarc(o, Vector3::X, Point3::new(4.0, 0.0, 0.0), Vector3::X, 0.5).unwrap();
        assert!(straight.iter().all(|c| matches!(c, Curve::Line(_))));
        assert!(biarc(o, -Vector3::X, Point3::new(4.0, 0.0, 0.0), -Vector3::X, 0.5).is_err());
        assert!(biarc(o, Vector3::X, e, Vector3::X, 1.0).is_err());
        assert!(biarc(o, Vector3::X, o, Vector3::X, 0.5).is_err());
    }

    #[test]
    fn chains_are_smooth() {
        let points = [[0.0, 0.0, 0.0], [2.0, 2.0, 0.0], [4.0, 0.0, 0.0], [6.0, 0.5, 1.0]].map(Point3::from);
        let chain = poly_arc(&points, Some(Vector3::Y), false).unwrap();
        let Curve::Poly(poly) = &chain else { panic!() };
        assert_eq!(poly.segments().len(), 3);
        // From the origin upwards to (2, 2): a quarter of a circle; then the next quarter.
        let quarter = std::f64::consts::PI;
        assert!((poly.segments()[0].length() - quarter).abs() < 1e-12);
        assert!((poly.segments()[1].length() - quarter).abs() < 1e-12);
        for pair in poly.segments().windows(2) {
            let before = pair[0].tangent_on_side(pair[0].domain().end, true).unwrap();
            let after = pair[1].tangent_on_side(pair[1].domain().start, false).unwrap();
            assert!((before - after).length() < 1e-9);
        }
        let line = poly_arc(&points[..2], None, false).unwrap();
        assert!(matches!(line, Curve::Line(_)));
        let closed = poly_arc(&points, None, true).unwrap();
        assert!(closed.start().distance_to(closed.end()) < 1e-9);
        assert!(poly_arc(&points[..1], None, false).is_err());
        assert!(poly_arc(&[points[0], points[0]], None, false).is_err());
    }
}
