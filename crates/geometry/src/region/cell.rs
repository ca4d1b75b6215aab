//! The part of a plane that other planes bound.

use katydid_elementary::Elementary;

use crate::region::thresholds::CONVEX_TURN;
use crate::thresholds;
use crate::{Error, Plane, Point3, PolylineCurve, Result};

/// The convex part of `plane` around its origin that other planes cut off, as a closed polyline, counter-clockwise
/// about the normal. Planes parallel to it bound nothing.
///
/// By duality: a line at distance d with unit normal n, seen from the origin, is the point n/d; the corners of the
/// cell are the sides of the convex hull of these points, and the cell is bounded when the hull holds the origin
/// (de Berg and others, *Computational Geometry*, 8.2 and 11.4).
///
/// # Errors
/// A plane goes through the origin of `plane`, or the planes leave the part open.
pub fn plane_cell(plane: &Plane, bounds: &[Plane]) -> Result<PolylineCurve> {
    let mut duals: Vec<[f64; 2]> = Vec::new();
    for bound in bounds {
        if !(bound.is_finite() && plane.is_finite()) {
            return Err(Error::NotFinite("plane"));
        }
        let n = bound.z_axis;
        let line = [n.dot(plane.x_axis), n.dot(plane.y_axis)];
        let slope = line[0].hypotenuse(line[1]);
        if slope <= thresholds::NO_DIRECTION {
            continue;
        }
        let height = n.dot(bound.origin - plane.origin);
        let scale = (bound.origin - plane.origin).length();
        if height.abs() <= thresholds::ROUNDING * scale.max(f64::MIN_POSITIVE) {
            return Err(Error::degenerate("bounding plane", "it goes through the origin of the plane"));
        }
        let dual = line.map(|x| x / height);
        if dual.iter().all(|x| x.is_finite()) {
            duals.push(dual);
        }
    }
    let open = || Error::degenerate("bounding planes", "they leave the part around the origin open");
    let hull = hull(duals);
    let cross = |a: [f64; 2], b: [f64; 2]| a[0] * b[1] - a[1] * b[0];
    let mut points: Vec<Point3> = Vec::with_capacity(hull.len() + 1);
    for (a, b) in hull.iter().zip(hull.iter().cycle().skip(1)) {
        // The origin must lie left of every side.
        let turn = cross(*a, *b);
        let size = a[0].hypotenuse(a[1]) * b[0].hypotenuse(b[1]);
        if hull.len() < 3 || !(turn > thresholds::ROUNDING * size) {
            return Err(open());
        }
        // a·p = 1 and b·p = 1.
        points.push(plane.at((b[1] - a[1]) / turn, (a[0] - b[0]) / turn, 0.0));
    }
    points.push(*points.first().ok_or_else(open)?);
    PolylineCurve::new(points)
}

/// The convex hull counter-clockwise, without points on its sides: Andrew's monotone chain.
fn hull(mut points: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    points.sort_by(|p, q| p[0].total_cmp(&q[0]).then(p[1].total_cmp(&q[1])));
    points.dedup();
    if points.len() < 3 {
        return points;
    }
    let half = |points: &mut dyn Iterator<Item = [f64; 2]>| {
        let mut chain: Vec<[f64; 2]> = Vec::new();
        for p in points {
            while let [.., a, b] = chain[..] {
                let turn = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
                let size = (b[0] - a[0]).hypotenuse(b[1] - a[1]) * (p[0] - a[0]).hypotenuse(p[1] - a[1]);
                if turn > CONVEX_TURN * size {
                    break;
                }
                chain.pop();
            }
            chain.push(p);
        }
        chain.pop();
        chain
    };
    let mut out = half(&mut points.iter().copied());
    out.extend(half(&mut points.iter().rev().copied()));
    out
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a failing assertion is how a test reports")]
    use super::plane_cell;
    use crate::{Curve, Plane, Point3, Vector3};

    fn wall(x: f64, y: f64) -> Plane {
        Plane::from_normal(Point3::new(x, y, 5.0), Vector3::new(x, y, 0.3)).unwrap()
    }

    #[test]
    fn cells() {
        let upright =
            |x: f64, y: f64| Plane::from_normal(Point3::new(x, y, 7.0), Vector3::new(-x, -y, 0.0)).unwrap();
        let room =
            [upright(2.0, 0.0), upright(-1.0, 0.0), upright(0.0, 3.0), upright(0.0, -1.0), upright(9.0, 9.0)];
        let cell = plane_cell(&Plane::XY, &room).unwrap();
        assert_eq!(cell.points().len(), 5);
        let (area, _) = Curve::from(cell).signed_area_in(&Plane::XY);
        assert!((area - 12.0).abs() < 1e-12);
        assert!(plane_cell(&Plane::XY, &room[..3]).unwrap_err().to_string().contains("open"));
        assert!(plane_cell(&Plane::XY, &[Plane::XY.with_origin(Point3::new(0.0, 0.0, 3.0))]).is_err());
        let through = Plane::from_normal(Point3::new(0.0, 4.0, 0.0), Vector3::X).unwrap();
        assert!(plane_cell(&Plane::XY, &[through]).unwrap_err().to_string().contains("origin"));
        assert!(plane_cell(&Plane::XY, &[wall(1.0, 0.0), wall(-1.0, 1.0), wall(0.0, -1.0)]).is_ok());
    }
}
