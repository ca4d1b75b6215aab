//! Curves pulled, pushed and offset onto surfaces.

mod beam;
mod lines;
mod thresholds;

use crate::pull::thresholds::{EXACT_OFFSET, LEAST_ANGLE, LEAST_GAP, LEVEL, NO_TURN, SAME_END};
use beam::Beam;
use katydid_elementary::Elementary;
pub(crate) use lines::LineIndex;

use crate::curve::traced::{Sample, joined, sampled};
use crate::surface::geodesic::{Shot, Unrolled, shot};
use crate::surface::{ClosestOnSurface, Foot, Surface};
use crate::{Curve, Direction, Error, Interval, OffsetCorner, Point3, Result, Tolerance, Vector3};

/// Parts of a smooth stretch of a curve that are looked at before halving begins.
const PARTS: usize = 8;
/// A foot that moves by less than this part of the point's way stands.
const STANDS: f64 = 1e-9;
/// A foot is foretold from how it moves over no more of the domain than this: one turn of a closed surface.
const FARTHEST: f64 = 1.0;

fn check(tolerance: &Tolerance) -> Result<f64> {
    let limit = tolerance.absolute;
    if limit > 0.0 && limit.is_finite() {
        Ok(limit)
    } else {
        Err(Error::OutOfRange { what: "tolerance", value: limit, must: "finite and greater than 0" })
    }
}

/// The largest gap between ends that are the same point: far below the tolerance, far above rounding.
fn gap(curve: &Curve, limit: f64) -> f64 {
    (SAME_END * curve.bounding_box().diagonal().length()).min(0.1 * limit)
}

/// A surface prepared for many curves that are projected onto it along one direction.
pub struct SurfaceProjection {
    surface: std::sync::Arc<Surface>,
    lines: LineIndex,
}

impl SurfaceProjection {
    /// # Errors
    /// The direction has no length.
    pub fn new(surface: std::sync::Arc<Surface>, direction: Vector3) -> Result<Self> {
        Ok(Self { lines: LineIndex::new(&surface, direction)?, surface })
    }

    /// As [`Surface::project_curve`].
    ///
    /// # Errors
    /// The tolerance is not above 0.
    pub fn project(&self, curve: &Curve, tolerance: &Tolerance) -> Result<Vec<Curve>> {
        self.surface.project_along(curve, &self.lines, tolerance)
    }
}

impl Surface {
    /// The curves that the nearest points of the surface make for all points of a curve, within the tolerance. There is
    /// more than one where the nearest point leaps, from side to side of a fold, say. Beside the surface the nearest points
    /// run along its sides.
    ///
    /// # Errors
    /// The tolerance is not above 0, or as [`ClosestOnSurface::nearest`].
    pub fn pull_curve(&self, curve: &Curve, tolerance: &Tolerance) -> Result<Vec<Curve>> {
        let limit = check(tolerance)?;
        let sizes = Direction::BOTH.map(|d| self.domain(d).length());
        let mut foot = Foot::new(self)?;
        let mut rows = Vec::new();
        for part in curve.smooth_stretches() {
            // The foot before, and how it moves: where nearest points are as near all around, the curve keeps to a side.
            let mut last: Option<(f64, [f64; 2], [f64; 2])> = None;
            let formula = |t: f64| -> Result<Option<Sample>> {
                let [place, velocity] = curve.jet_at::<2>(t, t >= part.end);
                let near = last.map(|(before, uv, rate)| {
                    let ways = rate.map(|rate| rate * (t - before));
                    let short = (0..2).all(|k| ways[k].abs() <= FARTHEST * sizes[k]);
                    if short { [uv[0] + ways[0], uv[1] + ways[1]] } else { uv }
                });
                let uv = foot.at(place.to_point(), near)?;
                let rate = foot.slope(uv, place, velocity).unwrap_or_default();
                last = Some((t, uv, rate));
                let moved = foot.velocity(uv, rate);
                let direction = moved.unitized().filter(|_| moved.length() > STANDS * velocity.length());
                Ok(Some(Sample { point: foot.image(Point3::new(uv[0], uv[1], 0.0)), direction }))
            };
            rows.extend(sampled(part.start, part.end, PARTS, 0.5 * limit, formula)?);
        }
        joined(&rows, gap(curve, limit).max(LEAST_GAP), tolerance.angle)
    }

    /// The curves in which the lines through all points of a curve, along a direction and against it, meet the surface:
    /// all of them, in front of the curve and behind it, within the tolerance.
    ///
    /// Lines through some points of each smooth stretch of the curve are met with the surface; from each meeting the
    /// curve is followed both ways by Newton's method, to where it leaves the surface or the direction becomes tangent to
    /// it. So a piece that lies between two of those points (a 32nd of a stretch) may be missed, and stretches that lie
    /// over the outline of the surface, where every line only grazes it, give nothing.
    ///
    /// # Errors
    /// A direction of length 0, or a tolerance that is not above 0.
    pub fn project_curve(
        &self,
        curve: &Curve,
        direction: Vector3,
        tolerance: &Tolerance,
    ) -> Result<Vec<Curve>> {
        check(tolerance)?;
        self.project_along(curve, &LineIndex::new(self, direction)?, tolerance)
    }

    /// As [`Surface::project_curve`], for a surface that is prepared for many curves.
    pub(crate) fn project_along(
        &self,
        curve: &Curve,
        lines: &LineIndex,
        tolerance: &Tolerance,
    ) -> Result<Vec<Curve>> {
        let limit = check(tolerance)?;
        let beam = Beam::new(self, curve, lines);
        let mut rows = Vec::new();
        for part in curve.smooth_stretches() {
            for way in beam.ways(part)? {
                for w in way.windows(2) {
                    let (a, b) = (w[0], w[1]);
                    let formula = |t: f64| {
                        let x = (t - a.t) / (b.t - a.t);
                        let guess = [0, 1].map(|d| a.uv[d] + (b.uv[d] - a.uv[d]) * x);
                        Ok(beam.sample(t, part, if x >= 1.0 { b.uv } else { guess }))
                    };
                    rows.extend(sampled(a.t, b.t, 1, 0.5 * limit, formula)?);
                }
            }
        }
        joined(&rows, gap(curve, limit).max(LEAST_GAP), tolerance.angle)
    }

    /// The curves on the surface at a distance from a curve on it, measured along the surface: to the left of the curve
    /// seen against the normal, to the right for a negative distance. The curve is pulled to the surface first.
    ///
    /// From each point a geodesic is walked at a right angle to the curve. At corners the outer side goes round at the
    /// distance, and on the inner side neighbouring stretches are cut where they cross. Loops within a stretch that
    /// bends more tightly than the distance are not removed. Where a walk leaves the surface there is a gap. On a plane
    /// the offset is that of [`Curve::offset`] with sharp corners, which removes loops, and may leave the surface.
    ///
    /// # Errors
    /// The distance is not finite, or the tolerance not above 0.
    pub fn offset_curve(&self, curve: &Curve, distance: f64, tolerance: &Tolerance) -> Result<Vec<Curve>> {
        let limit = check(tolerance)?;
        if !distance.is_finite() {
            return Err(Error::NotFinite("offset distance"));
        }
        if let Surface::Plane(flat) = self {
            let plane = flat.plane();
            let heights = curve.extent_along(plane.z_axis);
            let at = plane.origin.to_vector().dot(plane.z_axis);
            if (heights.start - at).abs().max((heights.end - at).abs()) <= LEVEL * limit {
                return curve.offset(plane, -distance, OffsetCorner::Sharp, tolerance);
            }
            let flat = curve.transformed(&crate::Xform::projection_along(plane, plane.z_axis)?)?;
            return flat.offset(plane, -distance, OffsetCorner::Sharp, tolerance);
        }
        let sheet = Unrolled::new(self);
        let closest = ClosestOnSurface::new(self)?;
        // The place on the surface, and the direction of the curve in it.
        let foot = |t: f64, below: bool| -> Result<Option<([f64; 2], Vector3, Vector3)>> {
            let near = closest.nearest(curve.point_at(t))?;
            let (Some(normal), Some(along)) =
                (self.normal_at(near.u, near.v), curve.tangent_on_side(t, below))
            else {
                return Ok(None);
            };
            let flat = (along - normal * along.dot(normal)).unitized();
            Ok(flat.map(|flat| ([near.u, near.v], normal, flat)))
        };
        let walk = |at: [f64; 2], direction: Vector3| -> Option<Sample> {
            let Shot { point, across } = shot(&sheet, at, direction, distance.abs())?;
            Some(Sample { point, direction: across })
        };
        let sign = if distance < 0.0 { -1.0 } else { 1.0 };
        let parts = stretches_between_kinks(curve, tolerance.angle);
        let mut stretches: Vec<Vec<Vec<Sample>>> = Vec::new();
        for part in &parts {
            let formula = |t: f64| {
                Ok(foot(t, t >= part.end)?.and_then(|(at, normal, flat)| walk(at, normal.cross(flat) * sign)))
            };
            stretches.push(sampled(part.start, part.end, PARTS, 0.5 * limit, formula)?);
        }
        let mut curves: Vec<Vec<Curve>> = stretches
            .iter()
            .map(|rows| joined(rows, gap(curve, limit).max(LEAST_GAP), tolerance.angle))
            .collect::<Result<_>>()?;
        let n = parts.len();
        let corners = if curve.is_closed() && n > 1 { n } else { n.saturating_sub(1) };
        for i in 0..corners {
            let j = (i + 1) % n;
            let (Some(first), Some(second)) = (foot(parts[i].end, true)?, foot(parts[j].start, false)?)
            else {
                continue;
            };
            let (at, normal, before) = first;
            let after = second.2;
            let turn = before.cross(after).dot(normal).arctangent_of(before.dot(after));
            if turn.abs() < NO_TURN {
                continue;
            }
            if turn * sign < 0.0 {
                // The outer side: round the corner.
                let fan = |x: f64| {
                    let (sin, cos) = (turn * x).sine_cosine();
                    let flat = before * cos + normal.cross(before) * sin;
                    Ok(walk(at, normal.cross(flat) * sign))
                };
                let rows = sampled(0.0, 1.0, 4, 0.5 * limit, fan)?;
                let round = joined(&rows, gap(curve, limit).max(LEAST_GAP), tolerance.angle)?;
                curves[i].extend(round);
            } else {
                cut_at_crossing(&mut curves, i, j, limit)?;
            }
        }
        Ok(crate::join_curves(&curves.concat(), 2.0 * limit, true))
    }
}

/// The stretches between places where the curve turns by more than an angle.
fn stretches_between_kinks(curve: &Curve, angle: f64) -> Vec<Interval> {
    let domain = curve.domain();
    let tight = Tolerance { absolute: EXACT_OFFSET, angle: angle.max(LEAST_ANGLE) };
    let mut cuts = vec![domain.start];
    cuts.extend(
        curve
            .discontinuities(crate::Continuity::G1, &tight)
            .into_iter()
            .filter(|&t| domain.start < t && t < domain.end),
    );
    cuts.push(domain.end);
    cuts.windows(2).map(|w| Interval::new(w[0], w[1])).collect()
}

/// Ends stretch `i` and starts stretch `j` where they cross.
fn cut_at_crossing(curves: &mut [Vec<Curve>], i: usize, j: usize, limit: f64) -> Result<()> {
    let (Some(a), Some(b)) = (curves[i].last().cloned(), curves[j].first().cloned()) else { return Ok(()) };
    let found = crate::intersect::curve_curve(&a, &b, 2.0 * limit)?;
    // The crossing nearest to the corner.
    let Some(crossing) = found.crossings.iter().max_by(|x, y| x.a.total_cmp(&y.a)) else { return Ok(()) };
    let (s, t) = (a.domain(), b.domain());
    if s.start < crossing.a
        && let (Ok(head), Some(last)) = (a.trimmed(Interval::new(s.start, crossing.a)), curves[i].last_mut())
    {
        *last = head;
    }
    if crossing.b < t.end
        && let (Ok(tail), Some(first)) = (b.trimmed(Interval::new(crossing.b, t.end)), curves[j].first_mut())
    {
        *first = tail;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{PI, TAU};

    use crate::{
        Circle, Curve, Cylinder, Interval, Line, Plane, PlaneSurface, Point3, PolylineCurve, Sphere, Surface,
        Tolerance, Vector3,
    };

    fn p(x: f64, y: f64, z: f64) -> Point3 {
        Point3::new(x, y, z)
    }

    fn ball() -> Surface {
        Sphere::around(Point3::ORIGIN, 5.0).unwrap().into()
    }

    fn length(curves: &[Curve]) -> f64 {
        curves.iter().map(Curve::length).sum()
    }

    const FINE: Tolerance = Tolerance { absolute: 1e-4, angle: 0.01 };

    fn all_on(surface: &Surface, curves: &[Curve]) {
        for curve in curves {
            for k in 0..=50 {
                let q = curve.point_at(curve.domain().at(f64::from(k) / 50.0));
                assert!(surface.closest_point(q).unwrap().distance < 2e-4, "{q:?}");
            }
        }
    }

    #[test]
    fn pulled() {
        // A line beside a ball is pulled to a part of a great circle.
        let line: Curve = Line::new(p(-8.0, 0.0, 8.0), p(8.0, 0.0, 8.0)).into();
        let arc = ball().pull_curve(&line, &FINE).unwrap();
        assert_eq!(arc.len(), 1);
        all_on(&ball(), &arc);
        assert!((length(&arc) - 5.0 * PI / 2.0).abs() < 1e-3, "{}", length(&arc));
        // Beyond a flat surface it runs along the side.
        let side = Interval::new(0.0, 4.0);
        let flat: Surface = PlaneSurface::new(Plane::XY, side, side).unwrap().into();
        let line: Curve = Line::new(p(-1.0, 1.0, 3.0), p(3.0, 5.0, 3.0)).into();
        let pulled = flat.pull_curve(&line, &FINE).unwrap();
        assert!((length(&pulled) - (1.0 + 8f64.sqrt() + 1.0 - 1.0)).abs() < 1.2, "{}", length(&pulled));
        all_on(&flat, &pulled);
    }

    #[test]
    fn pulled_from_the_middle() {
        // All around the axis of a tube is as near: the pulled curve keeps to the side where it began.
        let tube: Surface = Cylinder::new(Plane::XY, 2.0, Interval::new(0.0, 10.0)).unwrap().into();
        let axis: Curve = Line::new(p(0.0, 0.0, 1.0), p(0.0, 0.0, 9.0)).into();
        let pulled = tube.pull_curve(&axis, &FINE).unwrap();
        assert_eq!(pulled.len(), 1, "{pulled:?}");
        all_on(&tube, &pulled);
        assert!((length(&pulled) - 8.0).abs() < 1e-6, "{}", length(&pulled));
        // A circle around a tube comes to a closed circle, over the seam.
        let around: Curve = Circle::new(Plane::XY.offset(4.0), 3.0).unwrap().into();
        let ring = tube.pull_curve(&around, &FINE).unwrap();
        assert!(
            ring.len() == 1 && ring[0].is_closed() && (length(&ring) - 4.0 * PI).abs() < 1e-3,
            "{ring:?}"
        );
    }

    #[test]
    fn projected() {
        // A circle above a ball: a parallel above and one below.
        let circle: Curve = Circle::new(Plane::XY.offset(20.0), 3.0).unwrap().into();
        let both = ball().project_curve(&circle, Vector3::Z, &FINE).unwrap();
        assert_eq!(both.len(), 2, "{both:?}");
        all_on(&ball(), &both);
        assert!((length(&both) - 2.0 * TAU * 3.0).abs() < 1e-3);
        // A line longer than the ball is wide: a closed great circle, in two halves where it turns.
        let line: Curve = Line::new(p(-9.0, 1.0, 9.0), p(9.0, 1.0, 9.0)).into();
        let around = ball().project_curve(&line, -Vector3::Z, &FINE).unwrap();
        all_on(&ball(), &around);
        assert!((length(&around) - TAU * 24f64.sqrt()).abs() < 5e-3, "{} {}", around.len(), length(&around));
        assert!(ball().project_curve(&line, Vector3::Y, &FINE).unwrap().is_empty());
        assert!(ball().project_curve(&line, Vector3::ZERO, &FINE).is_err());
        // Over the outline every line only grazes the ball; a little inside it there are two parallels.
        let outline: Curve = Circle::new(Plane::XY.offset(20.0), 5.0).unwrap().into();
        assert!(ball().project_curve(&outline, Vector3::Z, &FINE).unwrap().is_empty());
        let inside: Curve = Circle::new(Plane::XY.offset(20.0), 4.9999).unwrap().into();
        let both = ball().project_curve(&inside, Vector3::Z, &FINE).unwrap();
        assert!((length(&both) - 2.0 * TAU * 4.9999).abs() < 1e-3, "{}", length(&both));
        // Part of a corner on a plane.
        let side = Interval::new(0.0, 4.0);
        let flat: Surface = PlaneSurface::new(Plane::XY, side, side).unwrap().into();
        let corner = PolylineCurve::new(vec![p(-2.0, 1.0, 5.0), p(3.0, 1.0, 6.0), p(3.0, 9.0, 5.0)]).unwrap();
        let flat_corner = flat.project_curve(&corner.into(), Vector3::Z, &FINE).unwrap();
        assert!(flat_corner.len() == 1 && (length(&flat_corner) - 6.0).abs() < 1e-4, "{flat_corner:?}");
    }

    #[test]
    fn offset_on_surfaces() {
        // Parallels of the ball: colatitude grows by distance / radius.
        let parallel: Curve = Circle::new(Plane::XY.offset(4.0), 3.0).unwrap().into();
        let colatitude = 0.6f64.asin();
        for d in [1.0, -1.0] {
            let curves = ball().offset_curve(&parallel, d, &FINE).unwrap();
            all_on(&ball(), &curves);
            let want = TAU * 5.0 * (colatitude - d / 5.0).sin();
            assert!((length(&curves) - want).abs() < 1e-3, "{d} {} {want}", length(&curves));
        }
        // A tube unrolls: offset of a helix-like corner keeps lengths of straight parts.
        let tube: Surface = Cylinder::new(Plane::XY, 2.0, Interval::new(0.0, 10.0)).unwrap().into();
        let ring: Curve = Circle::new(Plane::XY.offset(5.0), 2.0).unwrap().into();
        let up = tube.offset_curve(&ring, 1.5, &FINE).unwrap();
        assert!((length(&up) - TAU * 2.0).abs() < 1e-3);
        assert!((up[0].start().z - 5.0).abs() > 1.4);
        assert!(tube.offset_curve(&ring, 7.0, &FINE).unwrap().is_empty());
        let side = Interval::new(0.0, 9.0);
        let flat: Surface = PlaneSurface::new(Plane::XY, side, side).unwrap().into();
        let line: Curve = Line::new(p(1.0, 1.0, 0.0), p(5.0, 1.0, 0.0)).into();
        let left = flat.offset_curve(&line, 1.0, &FINE).unwrap();
        assert!(left[0].start().distance_to(p(1.0, 2.0, 0.0)) < 1e-9);
    }
}
