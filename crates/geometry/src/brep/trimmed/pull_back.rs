//! Curves on a surface as curves in its parameter plane.

use super::lift::{ending, in_parameter_plane};
use super::rim::with_straight_sides;
use crate::brep::flatten::flattened;
use crate::brep::thresholds::STRAIGHT_TRIM;
use crate::surface::Foot;
use crate::thresholds;
use crate::{
    Curve, Direction, Error, Interval, Line, LineCurve, NurbsCurve, Point3, PolyCurve, Result, Surface,
};
use crate::{Tolerance, Vector3, Xform};

/// The most halvings of one stretch.
const DEEPEST: u32 = 11;
/// Steps from the middle of a stretch to each of its ends, along all stretches of a curve together; and of one at least.
const STEPS: usize = 192;
const LEAST_STEPS: usize = 4;
/// The most steps for one stretch.
const MOST_STEPS: usize = 24;

impl Surface {
    /// A curve that lies on the surface, or near it, as a curve in the parameter plane (x is u, y is v): of its nearest
    /// points, with its own parameter, within the tolerance. On planes it is exact; along lines of constant parameter
    /// it is a straight line. Where the surface closes the curve may go over the seam, and leave the domain by up to
    /// a period for every turn.
    ///
    /// # Errors
    /// The tolerance is not above 0, or the nearest point leaps from one part of the surface to another.
    pub fn parameter_curve(&self, curve: &Curve, tolerance: &Tolerance) -> Result<Curve> {
        let limit = tolerance.positive_distance()?;
        if let Self::Plane(plane) = self {
            let flat = flattened(curve, plane.plane())?;
            let scale = |d: Direction| {
                let (domain, extent) = (plane.domain(d), plane.extents()[d.index()]);
                let speed = domain.length() / extent.length();
                (speed, domain.start - extent.start * speed)
            };
            let ((a, c), (b, d)) = (scale(Direction::U), scale(Direction::V));
            if (a, b, c, d) == (1.0, 1.0, 0.0, 0.0) {
                return Ok(flat);
            }
            let axes = [Vector3::X * a, Vector3::Y * b, Vector3::Z];
            let map = Xform::from_columns(axes[0], axes[1], axes[2], Point3::new(c, d, 0.0));
            return in_parameter_plane(&flat.transformed(&map)?);
        }
        let mut foot = Foot::new(self)?;
        let mut parts: Vec<Curve> = Vec::new();
        let mut places = Vec::new();
        let stretches = curve.smooth_stretches();
        let steps = (STEPS / stretches.len().max(1)).clamp(LEAST_STEPS, MOST_STEPS);
        for stretch in stretches {
            let part = self.pulled_stretch(curve, stretch, steps, &mut foot, limit)?;
            let part = match parts.last() {
                Some(before) => ending(&part, [before.end(), part.end()])?,
                None => part,
            };
            places.push(stretch.start);
            parts.push(part);
        }
        places.extend([curve.domain().end]);
        if parts.len() == 1
            && let Some(only) = parts.pop()
        {
            return Ok(only);
        }
        Ok(PolyCurve::with_parameters(parts, places)?.into())
    }

    fn pulled_stretch(
        &self,
        curve: &Curve,
        part: Interval,
        steps: usize,
        foot: &mut Foot<'_>,
        limit: f64,
    ) -> Result<Curve> {
        let point = |t: f64| curve.point_at(t);
        // The ends may lie where the surface is singular; the middle tells on which turn they are.
        let middle = foot.at(point(part.middle()), None)?;
        let halves = [part.start, part.end].map(|end| Interval::new(part.middle(), end));
        let first = walked(foot, &point, halves[0], steps, middle)?;
        let last = walked(foot, &point, halves[1], steps, middle)?;
        if let Some(line) = self.axial(foot, &point, part, [first, last], middle, limit)? {
            return Ok(line);
        }
        let slope = |foot: &Foot<'_>, t: f64, uv: [f64; 2], below: bool| -> Option<Vector3> {
            let [place, velocity] = curve.jet_at::<2>(t, below);
            foot.slope(uv, place, velocity).map(|[x, y]| Vector3::new(x, y, 0.0))
        };
        let mut nodes = vec![(part.start, first)];
        let mut stack =
            vec![(part.middle(), middle, part.end, last, 1), (part.start, first, part.middle(), middle, 1)];
        while let Some((s, a, t, b, depth)) = stack.pop() {
            let h = t - s;
            let chord = Vector3::new(b[0] - a[0], b[1] - a[1], 0.0) / h;
            let from = slope(foot, s, a, false).unwrap_or(chord);
            let to = slope(foot, t, b, true).unwrap_or(chord);
            let at = |uv: [f64; 2]| Point3::new(uv[0], uv[1], 0.0);
            let piece = NurbsCurve::hermite(at(a), from * h, at(b), to * h)?;
            let mut worst = 0.0_f64;
            for x in [0.25, 0.5, 0.75] {
                let place = piece.point_at(x);
                let exact = foot.at(point(s + h * x), Some([place.x, place.y]))?;
                worst = worst.max(foot.image(place).distance_to(foot.image(at(exact))));
            }
            if worst <= limit {
                nodes.push((t, b));
                continue;
            }
            if depth >= DEEPEST {
                return Err(Error::degenerate("curve to pull", "its nearest point leaps on the surface"));
            }
            let m = s + 0.5 * h;
            let place = piece.point_at(0.5);
            let uv = foot.at(point(m), Some([place.x, place.y]))?;
            stack.push((m, uv, t, b, depth + 1));
            stack.push((s, a, m, uv, depth + 1));
        }
        let count = nodes.len();
        let (mut points, mut slopes, mut places) = (Vec::new(), Vec::new(), Vec::new());
        for (k, (t, uv)) in nodes.iter().enumerate() {
            let beside = nodes.get(if k + 1 < count { k + 1 } else { k - 1 });
            let chord = beside.map_or(Vector3::ZERO, |(s, other)| {
                Vector3::new(other[0] - uv[0], other[1] - uv[1], 0.0) / (s - t)
            });
            points.push(Point3::new(uv[0], uv[1], 0.0));
            slopes.push(slope(foot, *t, *uv, k + 1 == count).unwrap_or(chord));
            places.push(*t);
        }
        Ok(NurbsCurve::hermite_through(&points, &slopes, &places)?.into())
    }

    /// The straight line that a curve along a line of constant parameter is.
    fn axial(
        &self,
        foot: &mut Foot<'_>,
        point: &impl Fn(f64) -> Point3,
        part: Interval,
        ends: [[f64; 2]; 2],
        middle: [f64; 2],
        limit: f64,
    ) -> Result<Option<Curve>> {
        for k in 0..2 {
            let domain = self.domain(Direction::BOTH[k]);
            let mut constant = middle[k];
            let near = |x: f64| (x - constant).abs() <= thresholds::SAME_PARAMETER * domain.length();
            if !(near(ends[0][k]) && near(ends[1][k])) {
                continue;
            }
            for side in [domain.start, domain.end] {
                if (constant - side).abs() <= thresholds::SAME_PARAMETER * domain.length() {
                    constant = side;
                }
            }
            let mut straight = true;
            for x in [0.2, 0.4, 0.6, 0.8] {
                let uv = foot.at(point(part.at(x)), Some(middle))?;
                let mut on_line = uv;
                on_line[k] = constant;
                let [p, q] = [uv, on_line].map(|uv| foot.image(Point3::new(uv[0], uv[1], 0.0)));
                straight &= p.distance_to(q) <= STRAIGHT_TRIM * limit;
            }
            let other = 1 - k;
            let moves = (ends[0][other] - ends[1][other]).abs()
                > thresholds::SAME_PARAMETER * self.domain(Direction::BOTH[other]).length();
            if straight && moves {
                let end = |uv: [f64; 2]| {
                    let mut uv = uv;
                    uv[k] = constant;
                    Point3::new(uv[0], uv[1], 0.0)
                };
                let line = Line::new(end(ends[0]), end(ends[1]));
                return Ok(Some(LineCurve { line, domain: part }.into()));
            }
        }
        Ok(None)
    }

    /// Closed curves on the surface as closed curves in the parameter plane.
    ///
    /// # Errors
    /// A curve is open, or runs round the surface; or as [`Surface::parameter_curve`].
    pub(super) fn pulled_loops(&self, curves: &[Curve], tolerance: &Tolerance) -> Result<Vec<Curve>> {
        let limit = tolerance.positive_distance()?;
        let mut out = Vec::with_capacity(curves.len());
        for curve in crate::join_curves(curves, limit, false) {
            if !(curve.is_closed() || curve.start().distance_to(curve.end()) <= limit) {
                return Err(Error::degenerate("trimming curve", "it is open"));
            }
            let flat = self.parameter_curve(&curve, tolerance)?;
            let (a, b) = (flat.start(), flat.end());
            let round = Direction::BOTH.iter().any(|d| {
                let gap = if *d == Direction::U { (a.x - b.x).abs() } else { (a.y - b.y).abs() };
                self.is_closed(*d) && gap > 0.5 * self.domain(*d).length()
            });
            if round {
                return Err(Error::Unsupported(
                    "trimming by a closed curve that runs round a closed surface",
                ));
            }
            let flat = if a == b { flat } else { ending(&flat, [a, a])? };
            out.push(with_straight_sides(self, &flat)?);
        }
        Ok(out)
    }
}

/// The parameters at the end of a way along a curve, on the turn on which one comes to it from its start.
fn walked(
    foot: &mut Foot<'_>,
    point: &impl Fn(f64) -> Point3,
    way: Interval,
    steps: usize,
    start: [f64; 2],
) -> Result<[f64; 2]> {
    let mut uv = start;
    for k in 1..=steps {
        let t = if k == steps { way.end } else { way.at(k as f64 / steps as f64) };
        uv = foot.at(point(t), Some(uv))?;
    }
    Ok(uv)
}
