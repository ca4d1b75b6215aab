//! Curves as lines and arcs within a tolerance.

use super::tessellate::chord_distance;
use super::{Curve, PolyCurve};
use crate::bernstein::{halves, squared_distance};
use crate::curve::thresholds::{STRAIGHT_BEND, TOO_SHORT};
use crate::nurbs::project;
use crate::{Arc, Error, Line, Plane, Point3, Result, Vector3};

/// A part of the result and, for the check, nothing else.
enum Simple {
    Line(Line),
    Arc(Arc),
}

impl Curve {
    /// The curve as lines and arcs, none of which is farther than `tolerance` from it; where the curve is smooth,
    /// arcs join with its tangents. Lines, arcs and polylines give their own parts. For planar curves.
    ///
    /// Pairs of arcs with the ends and end tangents of a piece and equal shares of the turn (K. Bolton, *Biarc
    /// curves*, CAD 7, 1975), the piece being halved until Bernstein coefficients of its squared distance from both
    /// centres certify the tolerance.
    ///
    /// # Errors
    /// The tolerance is not above 0, the curve is not planar within it, or it would need more than 100,000 arcs.
    pub fn to_arcs_and_lines(&self, tolerance: f64) -> Result<PolyCurve> {
        if !(tolerance > 0.0 && tolerance.is_finite()) {
            return Err(Error::OutOfRange {
                what: "tolerance",
                value: tolerance,
                must: "finite and greater than 0",
            });
        }
        if let Self::Line(_) | Self::Arc(_) = self {
            return PolyCurve::new(vec![self.clone()]);
        }
        let plane = self
            .plane(tolerance)
            .ok_or(Error::degenerate("curve", "only planar curves become arcs and lines"))?;
        let mut out: Vec<Self> = Vec::new();
        for part in self.smooth_parts()? {
            match part {
                Self::Line(_) | Self::Arc(_) => out.push(part),
                other => {
                    let curve = other.to_nurbs()?;
                    for bezier in curve.beziers_between(&curve.span_parameters())? {
                        approximate(bezier, &plane, 0.9 * tolerance, &mut out)?;
                    }
                }
            }
        }
        PolyCurve::new(out)
    }
}

fn approximate(bezier: Vec<[f64; 4]>, plane: &Plane, tolerance: f64, out: &mut Vec<Curve>) -> Result<()> {
    let mut stack = vec![(bezier, 0_u32)];
    while let Some((c, depth)) = stack.pop() {
        let (Some(&first), Some(&last)) = (c.first(), c.last()) else { continue };
        let (a, b) = (project(first), project(last));
        if chord_distance(&c) <= tolerance && depth > 0 || a.distance_to(b) <= TOO_SHORT * tolerance {
            if a != b {
                out.push(Line::new(a, b).into());
            }
            continue;
        }
        if let Some(found) = biarc(&c, plane)
            && found.iter().all(|s| matches!(s, Simple::Arc(_) | Simple::Line(_)))
            && certified(&c, &found, tolerance)
        {
            for s in found {
                out.push(match s {
                    Simple::Line(l) => l.into(),
                    Simple::Arc(a) => a.into(),
                });
            }
            continue;
        }
        if depth > 30 || out.len() > 100_000 {
            if out.len() > 100_000 {
                return Err(Error::Invalid { what: "arcs", why: "more than 100000 would be needed".into() });
            }
            out.push(Line::new(a, b).into());
            continue;
        }
        let (left, right) = halves(&c);
        stack.push((right, depth + 1));
        stack.push((left, depth + 1));
    }
    Ok(())
}

/// The end directions of a Bézier curve by its first and last leg that has a length.
fn directions(c: &[[f64; 4]]) -> Option<[Vector3; 2]> {
    let start = project(*c.first()?);
    let end = project(*c.last()?);
    let from = c.iter().map(|&p| project(p) - start).find(|v| v.length() > 0.0)?;
    let to = c.iter().rev().map(|&p| end - project(p)).find(|v| v.length() > 0.0)?;
    Some([from.unitized()?, to.unitized()?])
}

/// The two arcs with the ends and end tangents of a Bézier curve and equal tangent lengths.
fn biarc(c: &[[f64; 4]], plane: &Plane) -> Option<Vec<Simple>> {
    let (a, b) = (project(*c.first()?), project(*c.last()?));
    let [ta, tb] = directions(c)?;
    let v = b - a;
    // |v|² − 2d v·(ta + tb) + 2d²(ta·tb − 1) = 0 for the tangent length d (equal on both sides).
    let sum = ta + tb;
    let (p, q, r) = (2.0 * (1.0 - ta.dot(tb)), 2.0 * v.dot(sum), -v.length_squared());
    let root = (q * q - 4.0 * p * r).max(0.0).sqrt();
    // The stable form of the positive root.
    let d = if q >= 0.0 { -2.0 * r / (q + root) } else { (root - q) / (2.0 * p) };
    if !(d > 0.0 && d.is_finite()) {
        return None;
    }
    let joint = (a + ta * d).lerp(b - tb * d, 0.5);
    Some(vec![simple(a, ta, joint, plane)?, simple(joint, (b - tb * d - joint).unitized()?, b, plane)?])
}

fn simple(from: Point3, direction: Vector3, to: Point3, plane: &Plane) -> Option<Simple> {
    let chord = to - from;
    let bend = direction.cross(chord).dot(plane.z_axis);
    if bend.abs() <= STRAIGHT_BEND * chord.length() {
        return (chord.dot(direction) > 0.0).then_some(Simple::Line(Line::new(from, to)));
    }
    Arc::from_start_direction_end(from, direction, to).ok().map(Simple::Arc)
}

/// Whether the first part of a Bézier curve is within the tolerance of the first arc and the rest of the second, for
/// some cut between them.
fn certified(c: &[[f64; 4]], parts: &[Simple], tolerance: f64) -> bool {
    let [first, second] = parts else { return false };
    let joint = match first {
        Simple::Line(l) => l.to,
        Simple::Arc(a) => a.end(),
    };
    let across = match second {
        Simple::Line(l) => l.direction(),
        Simple::Arc(a) => a.circle.plane.z_axis.cross(a.start() - a.circle.center()),
    };
    // Cut where the curve passes the joint's normal: bisection.
    let side = |x: f64| (project(crate::bernstein::value(c, x)) - joint).dot(across);
    if !(side(0.0) < 0.0 && side(1.0) > 0.0) {
        return false;
    }
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..30 {
        let middle = 0.5 * (low + high);
        if side(middle) < 0.0 { low = middle } else { high = middle }
    }
    let (left, right) = split(c, 0.5 * (low + high));
    let near = |points: &[[f64; 4]], part: &Simple| match part {
        Simple::Line(l) => points.iter().all(|&p| l.distance_to(project(p)) <= tolerance),
        Simple::Arc(a) => {
            let r = a.circle.radius;
            // An arc of more than half a turn is not for one piece.
            let (far, near) = ((r + tolerance).powi(2), (r - tolerance).max(0.0).powi(2));
            a.angle.length() < std::f64::consts::PI && within(points, a.circle.center(), near, far, 4)
        }
    };
    near(&left, first) && near(&right, second)
}

/// Whether the squared distance from a point stays between two bounds, by halving.
fn within(points: &[[f64; 4]], center: Point3, near: f64, far: f64, depth: u32) -> bool {
    let squared = squared_distance(points, center);
    if squared.iter().all(|c| c[0] >= near * c[1] && c[0] <= far * c[1]) {
        return true;
    }
    if depth == 0 {
        return false;
    }
    let (left, right) = halves(points);
    within(&left, center, near, far, depth - 1) && within(&right, center, near, far, depth - 1)
}

fn split(points: &[[f64; 4]], x: f64) -> (Vec<[f64; 4]>, Vec<[f64; 4]>) {
    let mut row = points.to_vec();
    let n = row.len();
    let mut left = Vec::with_capacity(n);
    for level in 0..n {
        left.push(row[0]);
        for i in 0..n - 1 - level {
            row[i] = std::array::from_fn(|c| (1.0 - x) * row[i][c] + x * row[i + 1][c]);
        }
    }
    (left, row)
}
