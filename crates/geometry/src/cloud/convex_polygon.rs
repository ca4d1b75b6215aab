use katydid_elementary::Elementary;

use super::{check_points2, turn};
use crate::thresholds;
use crate::{
    Arc, Circle, Curve, Error, Interval, Line, Plane, Point2, Point3, PolyCurve, PolylineCurve, Result,
};

/// A convex polygon in a plane, counter-clockwise.
#[derive(Debug, Clone, PartialEq)]
pub struct ConvexPolygon {
    corners: Vec<Point2>,
}

impl ConvexPolygon {
    /// The polygon with given corners, in either sense; corners on straight sides and repeated ones are dropped.
    ///
    /// # Errors
    /// A coordinate is not finite or beyond 3.2e60, the polygon has no area, or it is not convex.
    pub fn new(corners: &[Point2]) -> Result<Self> {
        check_points2(corners)?;
        let mut ring = corners.to_vec();
        ring.dedup();
        while ring.len() > 1 && ring.first() == ring.last() {
            ring.pop();
        }
        if doubled_area(&ring) < 0.0 {
            ring.reverse();
        }
        let hull = super::convex_hull(&ring)?;
        if hull.len() < 3 {
            return Err(Error::degenerate("convex polygon", "it has no area"));
        }
        let kept: Vec<Point2> = hull.iter().filter_map(|&i| ring.get(i).copied()).collect();
        // A convex ring is its hull and points on the hull's sides, in the hull's order.
        let on_border = |p: Point2| {
            let next = kept.iter().cycle().skip(1);
            kept.iter().zip(next).any(|(&a, &b)| turn(a, b, p) == 0.0)
        };
        let rising = hull.iter().zip(hull.iter().cycle().skip(1)).filter(|(a, b)| a > b).count();
        if rising != 1 || !ring.iter().all(|&p| on_border(p)) {
            return Err(Error::degenerate("convex polygon", "it is not convex"));
        }
        Ok(Self { corners: kept })
    }

    /// The rectangle over two ranges.
    ///
    /// # Errors
    /// A range has no length or is not finite.
    pub fn rectangle(x: Interval, y: Interval) -> Result<Self> {
        let (x, y) = (x.ordered(), y.ordered());
        let corners = [(x.start, y.start), (x.end, y.start), (x.end, y.end), (x.start, y.end)];
        Self::new(&corners.map(|(x, y)| Point2::new(x, y)))
    }

    /// The corners, counter-clockwise.
    pub fn corners(&self) -> &[Point2] {
        &self.corners
    }

    /// The area.
    pub fn area(&self) -> f64 {
        0.5 * doubled_area(&self.corners)
    }

    /// Whether a point lies inside or on the border; exact.
    pub fn contains(&self, p: Point2) -> bool {
        let next = self.corners.iter().cycle().skip(1);
        self.corners.iter().zip(next).all(|(&a, &b)| turn(a, b, p) >= 0.0)
    }
}

/// Twice the signed area inside a ring of points.
pub(super) fn doubled_area(ring: &[Point2]) -> f64 {
    let Some(&o) = ring.first() else { return 0.0 };
    ring.windows(2).map(|w| (w[0] - o).cross(w[1] - o)).sum()
}

/// The part of a convex ring that is at least as near to `site` as to `other`, into `out`; `false` when all of it is,
/// and `out` is left alone.
pub(super) fn nearer_part(ring: &[Point2], site: Point2, other: Point2, out: &mut Vec<Point2>) -> bool {
    let d = other - site;
    let half = 0.5 * d.length_squared();
    let beyond = |p: Point2| (p - site).dot(d) - half;
    if !ring.iter().any(|&p| beyond(p) > 0.0) {
        return false;
    }
    out.clear();
    let Some(&last) = ring.last() else { return true };
    let (mut before, mut side) = (last, beyond(last));
    for &p in ring {
        let here = beyond(p);
        if (side > 0.0 && here < 0.0) || (side < 0.0 && here > 0.0) {
            out.push(before.lerp(p, side / (side - here)));
        }
        if here <= 0.0 {
            out.push(p);
        }
        (before, side) = (p, here);
    }
    true
}

/// The outline of a convex ring of corners in a plane's coordinates as a closed curve in space, cut off by a circle
/// where one is given: straight pieces and arcs of the circle then. `None` when nothing is left.
///
/// # Errors
/// The radius is not finite and greater than 0, or a corner is not finite.
pub(super) fn outline(
    ring: &[Point2],
    plane: &Plane,
    circle: Option<(Point2, f64)>,
) -> Result<Option<Curve>> {
    if ring.len() < 3 {
        return Ok(None);
    }
    let at = |p: Point2| plane.at(p.x, p.y, 0.0);
    let whole = || -> Result<Option<Curve>> {
        let mut points: Vec<Point3> = ring.iter().map(|&p| at(p)).collect();
        points.extend(points.first().copied());
        Ok(Some(PolylineCurve::new(points)?.into()))
    };
    let Some((center, radius)) = circle else { return whole() };
    let circle = Circle::new(plane.with_origin(at(center)), radius)?;
    if ring.iter().all(|p| p.distance_to(center) <= radius) {
        return whole();
    }
    // What of each side lies inside the circle.
    let next = ring.iter().cycle().skip(1);
    let sides: Vec<(Point2, Point2)> =
        ring.iter().zip(next).filter_map(|(&a, &b)| chord(a, b, center, radius)).collect();
    if sides.is_empty() {
        let next = ring.iter().cycle().skip(1);
        let inside = ring.iter().zip(next).all(|(&a, &b)| (b - a).cross(center - a) >= 0.0);
        return Ok(inside.then(|| circle.into()));
    }
    let angle = |p: Point2| (p.y - center.y).arctangent_of(p.x - center.x);
    let mut pieces: Vec<Curve> = Vec::with_capacity(2 * sides.len());
    for (&(a, b), &(c, _)) in sides.iter().zip(sides.iter().cycle().skip(1)) {
        pieces.push(Line::new(at(a), at(b)).into());
        if b.distance_to(c) > thresholds::ROUNDING * radius {
            let start = angle(b);
            let sweep = (angle(c) - start).rem_euclid(std::f64::consts::TAU);
            if sweep > thresholds::ROUNDING {
                pieces.push(Arc::new(circle, Interval::new(start, start + sweep))?.into());
            }
        }
    }
    Ok(Some(PolyCurve::new(pieces)?.into()))
}

/// The part of a segment inside a circle; `None` when there is none of any length.
fn chord(a: Point2, b: Point2, center: Point2, radius: f64) -> Option<(Point2, Point2)> {
    let (d, f) = (b - a, a - center);
    let (dd, df) = (d.length_squared(), d.dot(f));
    let squared = df * df - dd * (f.length_squared() - radius * radius);
    if !(squared > 0.0) {
        return None;
    }
    let root = squared.sqrt();
    let (from, to) = (((-df - root) / dd).max(0.0), ((-df + root) / dd).min(1.0));
    if !((to - from) * dd.sqrt() > thresholds::ROUNDING * radius) {
        return None;
    }
    let at = |t: f64| if t == 1.0 { b } else { a + d * t };
    Some((at(from), at(to)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn convex_or_not() {
        let square =
            [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]].map(Point2::from);
        let polygon = ConvexPolygon::new(&square).unwrap();
        assert_eq!(polygon.corners().len(), 4);
        assert_eq!(polygon.area(), 4.0);
        assert!(polygon.contains(Point2::new(2.0, 1.0)) && !polygon.contains(Point2::new(2.0, 2.1)));
        let mut turned = square;
        turned.reverse();
        assert_eq!(ConvexPolygon::new(&turned).unwrap().area(), 4.0);
        let dart = [[0.0, 0.0], [2.0, 0.0], [0.5, 0.5], [0.0, 2.0]].map(Point2::from);
        assert!(ConvexPolygon::new(&dart).is_err());
        let bow = [[0.0, 0.0], [2.0, 0.0], [0.0, 2.0], [2.0, 2.0]].map(Point2::from);
        assert!(ConvexPolygon::new(&bow).is_err());
        assert!(ConvexPolygon::new(&bow[..2]).is_err());
        assert!(ConvexPolygon::rectangle(Interval::UNIT, Interval::new(1.0, 1.0)).is_err());
    }

    #[test]
    fn outlines_with_a_circle() {
        let square = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(Point2::from);
        let length = |center: Point2, r: f64| {
            outline(&square, &Plane::XY, Some((center, r))).unwrap().map(|c| c.length())
        };
        let tau = std::f64::consts::TAU;
        assert!((length(Point2::ORIGIN, 0.5).unwrap() - 0.5 * tau).abs() < 1e-9);
        assert!((length(Point2::ORIGIN, 2.0).unwrap() - 8.0).abs() < 1e-12);
        // Radius √2·… between: four chords and four arcs.
        let r: f64 = 1.25;
        let half = (r * r - 1.0).sqrt();
        let arc = tau / 4.0 - 2.0 * (half / r).asin();
        assert!((length(Point2::ORIGIN, r).unwrap() - (8.0 * half + 4.0 * r * arc)).abs() < 1e-9);
        // A half disc at a side, and a disc beside the square.
        assert!((length(Point2::new(1.0, 0.0), 0.5).unwrap() - (1.0 + 0.25 * tau)).abs() < 1e-9);
        assert_eq!(length(Point2::new(3.0, 0.0), 1.5), None);
        assert!(outline(&square, &Plane::XY, Some((Point2::ORIGIN, -1.0))).is_err());
    }
}
