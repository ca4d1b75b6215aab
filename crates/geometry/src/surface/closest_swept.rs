//! Nearest points of surfaces that a plane curve sweeps: the question about the surface is one about the curve.
//!
//! Derived here. On a surface of revolution whose profile lies in a plane with the axis, the point of a circle nearest to a
//! place is in the half-plane of that place, or at an end of the arc; on a curve moved square to its plane, height and
//! profile are apart.

use std::f64::consts::{PI, TAU};

use katydid_elementary::Elementary;

use super::Surface;
use super::closest::SurfacePoint;
use crate::{
    Curve, CurvePoint, Direction, Interval, Line, Plane, Point3, Result, RevolutionSurface, Vector3, Xform,
};

/// A profile may leave its plane by so much of its distance from the origin of the plane and its size: rounding of
/// coordinates that were turned and moved some times.
const FLAT: f64 = 1e-14;

/// A surface that a plane curve sweeps.
#[derive(Debug, Clone)]
pub(super) enum Swept {
    /// Turned about an axis in the profile's plane.
    Turned {
        surface: RevolutionSurface,
        /// The profile's plane: its origin and y-axis on the axis of revolution, the normal the way that angles grow.
        plane: Plane,
    },
    /// Moved along a segment square to the profile's plane.
    Moved {
        surface: Surface,
        profile: Curve,
        /// The segment's domain, and the direction along which it runs.
        range: Interval,
        along: Direction,
        /// From the profile's plane at the start of the segment to that at its end.
        step: Vector3,
    },
}

/// Whether a curve lies in a plane, but for rounding.
fn is_flat(curve: &Curve, plane: &Plane) -> bool {
    let bounds = curve.bounding_box_in(plane);
    let size = [bounds.x, bounds.y].iter().fold(0.0_f64, |m, i| m.max(i.start.abs()).max(i.end.abs()));
    let from = [plane.origin.x, plane.origin.y, plane.origin.z].iter().fold(0.0_f64, |m, c| m.max(c.abs()));
    bounds.z.start.abs().max(bounds.z.end.abs()) <= FLAT * (size + from)
}

impl Swept {
    /// The surface as one that is swept, if it is.
    pub(super) fn of(surface: &Surface) -> Option<Self> {
        match surface {
            Surface::Revolution(turned) => Self::turned(turned),
            Surface::Sum(sum) => {
                let [first, second] = sum.curves();
                let moved = |profile: &Curve, line: &Line, range, along| {
                    let home = Xform::translation(line.from.to_vector() + sum.shift());
                    let profile = profile.transformed(&home).ok()?;
                    let step = line.to - line.from;
                    let plane = Plane::from_normal(profile.start(), step).ok()?;
                    let surface = surface.clone();
                    is_flat(&profile, &plane).then_some(Self::Moved { surface, profile, range, along, step })
                };
                match (first, second) {
                    (profile, Curve::Line(line)) => moved(profile, &line.line, line.domain, Direction::V),
                    (Curve::Line(line), profile) => moved(profile, &line.line, line.domain, Direction::U),
                    _ => None,
                }
            }
            _ => None,
        }
    }

    fn turned(surface: &RevolutionSurface) -> Option<Self> {
        let axis = surface.axis();
        let profile = surface.profile();
        let unit = axis.unit_direction()?;
        let domain = profile.domain();
        // The arm of the place farthest from the axis, of some, gives the plane.
        let arm = |share: f64| {
            let w = profile.point_at(domain.at(share)) - axis.from;
            w - unit * w.dot(unit)
        };
        let arms = [0.0, 0.5, 1.0].map(arm);
        let longest = arms.into_iter().reduce(|a, b| if b.length() > a.length() { b } else { a })?;
        let plane = Plane::from_points(axis.from, axis.from + longest.unitized()?, axis.from + unit).ok()?;
        // Turned by the right hand about the axis, x goes to unit × x, which is against this plane's normal.
        is_flat(profile, &plane).then(|| Self::Turned { surface: surface.clone(), plane })
    }

    /// The nearest point of the surface.
    ///
    /// # Errors
    /// The square of the distance overflows.
    pub(super) fn nearest(&self, q: Point3) -> Result<SurfacePoint> {
        let (surface_point, [u, v]) = match self {
            Self::Turned { surface, plane } => {
                let (angle, t) = nearest_turned(surface, plane, q)?;
                let range = surface.domain(surface.angle_direction());
                let a = range.clamp(range.at(surface.angle().normalized(angle)));
                let uv = if surface.angle_direction() == Direction::U { [a, t] } else { [t, a] };
                (surface.point_at(uv[0], uv[1]), uv)
            }
            Self::Moved { surface, profile, range, along, step } => {
                let share = (q - profile.start()).dot(*step) / step.length_squared();
                let t = profile.closest_point(q - *step * share)?.parameter;
                let s = range.clamp(range.at(share));
                let uv = if *along == Direction::V { [t, s] } else { [s, t] };
                (surface.point_at(uv[0], uv[1]), uv)
            }
        };
        Ok(SurfacePoint { u, v, point: surface_point, distance: surface_point.distance_to(q) })
    }
}

/// The angle and the profile's parameter of the nearest point.
fn nearest_turned(surface: &RevolutionSurface, plane: &Plane, q: Point3) -> Result<(f64, f64)> {
    let range = surface.angle();
    let full = surface.is_full_turn();
    let [x, height, depth] = plane.coordinates(q);
    // The way that angles grow is against the plane's normal.
    let (radius, around) =
        (x.hypotenuse(depth), if x == 0.0 && depth == 0.0 { range.start } else { (-depth).arctangent_of(x) });
    let mut best: Option<(CurvePoint, f64)> = None;
    let mut offer = |place: Point3, angle: f64| -> Result<()> {
        let found = surface.profile().closest_point(place)?;
        if best.is_none_or(|(b, _)| found.distance < b.distance) {
            best = Some((found, angle));
        }
        Ok(())
    };
    // Points of the profile on this side of the axis, and those beyond it, which come round after half a turn.
    for (sign, turn) in [(1.0, 0.0), (-1.0, PI)] {
        let angle = range.start + (around + turn - range.start).rem_euclid(TAU);
        if full || angle <= range.end {
            offer(plane.at(sign * radius, height, 0.0), range.clamp(angle))?;
        }
    }
    if !full {
        for angle in [range.start, range.end] {
            let (sin, cos) = (around - angle).sine_cosine();
            offer(plane.at(radius * cos, height, -radius * sin), angle)?;
        }
    }
    let nothing = crate::Error::NotFinite("square of the distance to the surface");
    best.map(|(found, angle)| (angle, found.parameter)).ok_or(nothing)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Arc, Circle, ClosestOnSurface, NurbsCurve, SumSurface};

    /// Against the search among Bézier patches of the same surface.
    fn agrees(surface: &Surface, places: &[Point3]) {
        let swept = Swept::of(surface).unwrap();
        let search = ClosestOnSurface::of_nurbs(&surface.to_nurbs().unwrap());
        for &q in places {
            let (a, b) = (swept.nearest(q).unwrap(), search.nearest(q).unwrap());
            assert!((a.distance - b.distance).abs() <= 1e-9 * (1.0 + b.distance), "{q:?}: {a:?} {b:?}");
            assert!(
                surface.point_at(a.u, a.v).distance_to(a.point)
                    <= 1e-12 * (1.0 + a.point.to_vector().length())
            );
            let inside = |d: Direction, t: f64| surface.domain(d).contains(t);
            assert!(inside(Direction::U, a.u) && inside(Direction::V, a.v));
        }
    }

    fn places() -> Vec<Point3> {
        let wave = |i: usize, k: f64| (i as f64 * k).sin() * 6.0;
        let mut places: Vec<Point3> =
            (0..60).map(|i| Point3::new(wave(i, 1.3), wave(i, 2.1), wave(i, 0.7))).collect();
        places.extend([Point3::ORIGIN, Point3::new(0.0, 0.0, 2.0), Point3::new(1.0, 2.0, 3.0)]);
        places
    }

    fn axis() -> Line {
        Line::new(Point3::new(1.0, 2.0, -1.0), Point3::new(2.0, 2.5, 3.0))
    }

    /// A place by its distance along the axis and its signed distance from it, in one plane with it.
    fn beside(along: f64, away: f64) -> Point3 {
        let line = axis();
        let unit = line.unit_direction().unwrap();
        let arm = unit.cross(Vector3::new(0.3, -1.0, 0.2)).unitized().unwrap();
        line.from + unit * along + arm * away
    }

    #[test]
    fn lines_arcs_and_free_curves_turned() {
        let profiles: Vec<Curve> = vec![
            Line::new(beside(0.0, 2.0), beside(4.0, 2.0)).into(),
            Line::new(beside(0.0, 2.0), beside(4.0, -1.0)).into(),
            Arc::through(beside(0.0, 3.0), beside(1.0, 4.0), beside(2.0, 3.0)).unwrap().into(),
            NurbsCurve::clamped_uniform(
                3,
                &[beside(0.0, 1.0), beside(1.0, 4.0), beside(2.0, -2.0), beside(4.0, 1.0)],
            )
            .unwrap()
            .into(),
        ];
        let angles = [(0.0, TAU), (0.3, 1.2), (-2.0, 3.5), (1.0, 1.0 + TAU), (-1.0, 2.5)];
        for profile in &profiles {
            for (start, end) in angles {
                let turned = RevolutionSurface::with_domain(
                    profile.clone(),
                    axis(),
                    Interval::new(start, end),
                    Interval::new(0.0, 3.0),
                )
                .unwrap();
                let mut all = places();
                all.extend([axis().from, axis().at(0.4), beside(1.0, 2.0), beside(2.0, -3.0)]);
                agrees(&Surface::Revolution(turned.transposed()), &all);
                agrees(&Surface::Revolution(turned), &all);
            }
        }
    }

    #[test]
    fn curves_moved_square_to_their_plane() {
        let circle = Circle::new(
            Plane::from_normal(Point3::new(1.0, 0.0, 2.0), Vector3::new(1.0, 2.0, 2.0)).unwrap(),
            3.0,
        )
        .unwrap();
        let normal = Vector3::new(1.0, 2.0, 2.0);
        let curve: Curve = circle.into();
        let moved = SumSurface::extrusion(curve.clone(), normal * 1.5).unwrap();
        agrees(&Surface::Sum(moved.transposed()), &places());
        agrees(&Surface::Sum(moved), &places());
        // Aslant it is no such surface, nor where the profile leaves the plane of the axis.
        let aslant = SumSurface::extrusion(curve.clone(), Vector3::new(0.0, 1.0, 5.0)).unwrap();
        assert!(Swept::of(&Surface::Sum(aslant)).is_none());
        let skew: Curve = Line::new(Point3::new(1.0, 0.0, 0.0), Point3::new(1.0, 1.0, 4.0)).into();
        let upright = Line::new(Point3::ORIGIN, Point3::new(0.0, 0.0, 1.0));
        let hyperboloid = RevolutionSurface::new(skew, upright, Interval::new(0.0, TAU)).unwrap();
        assert!(Swept::of(&Surface::Revolution(hyperboloid)).is_none());
    }
}
