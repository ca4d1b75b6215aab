//! Developable faces laid flat.

use katydid_elementary::Elementary;

use super::lift::followed;
use super::no_face;
use crate::{
    Brep, Curve, Direction, Error, Plane, Point3, Quadrant, Result, Surface, Tolerance, Vector3, Xform,
};

/// Places in each direction at which a surface is looked at.
const PLACES: usize = 17;
/// The most steps along a span.
const MOST_STEPS: usize = 1 << 14;

impl Brep {
    /// A developable face laid into the world's xy plane without stretching: lengths, angles and areas on it stay what
    /// they are. Its front looks upward. A plane is moved; other surfaces must consist of straight lines in one
    /// direction of their parameters, along each of which the normal stays the same: cylinders, cones, extrusions, and
    /// surfaces ruled so that they can be unrolled.
    ///
    /// One of the surface's curves across the lines is drawn in the plane with the geodesic curvature that it has (M. do
    /// Carmo, *Differential Geometry of Curves and Surfaces*, §4-4); points beside it follow along the straight lines.
    /// Edges are within the tolerance. The start of that curve lies at the origin, and leaves it along x.
    ///
    /// # Errors
    /// The face does not exist, has kinks, is not straight in any direction, or its normal turns along a straight line
    /// by more than the tolerance's angle.
    pub fn unrolled_face(&self, face: usize, tolerance: &Tolerance) -> Result<Self> {
        let limit = tolerance.positive_distance()?;
        let surface = self.face_surface(face).ok_or_else(no_face)?;
        let reversed = self.is_reversed(face);
        if let Surface::Plane(plane) = surface {
            let own = if reversed { plane.plane().flipped() } else { *plane.plane() };
            return self.sub_brep(&[face])?.transformed(&Xform::plane_to_plane(&own, &Plane::XY));
        }
        let sheet = Development::new(surface, reversed, tolerance)?;
        let mut curves: Vec<Curve> = Vec::new();
        let own = self.faces().get(face).ok_or_else(no_face)?;
        for trim in own.loops.iter().filter_map(|l| self.loops().get(*l)).flat_map(|chain| &chain.trims) {
            let has_edge = self.trims().get(*trim).is_some_and(|trim| trim.edge.is_some());
            let Some(flat) = self.trim_as_curve(*trim)?.filter(|_| has_edge) else { continue };
            let image: Curve = followed(&flat.smooth_stretches(), 0.1 * limit, |t, below| {
                let [place, slope] = flat.jet_at::<2>(t, below);
                sheet.image(place, slope)
            })?
            .into();
            curves.push(image.as_line(0.1 * limit).map_or(image, Curve::from));
        }
        let mut found = Self::planar_faces(&curves, tolerance)?.breps;
        match (found.pop(), found.len()) {
            (Some(only), 0) => Ok(if looks_down(&only) { only.flipped() } else { only }),
            _ => Err(Error::degenerate("unrolled face", "its edges do not enclose one region")),
        }
    }
}

/// Whether the normal of a flat face points down.
fn looks_down(flat: &Brep) -> bool {
    matches!(flat.face_surface(0), Some(Surface::Plane(plane)) if plane.plane().z_axis.z < 0.0)
}

/// A place along the directrix in the plane, and the angle of its tangent there.
#[derive(Debug, Clone, Copy)]
struct Place {
    x: f64,
    y: f64,
    angle: f64,
}

/// A developable surface and how it lies in the plane.
struct Development<'a> {
    surface: &'a Surface,
    /// The direction of the directrix, across the straight lines.
    across: Direction,
    /// The parameter of the straight lines at which it lies.
    start: f64,
    /// Which way is up, seen from the surface's normal.
    up: f64,
    /// Places along the directrix by its parameters.
    places: Vec<(f64, Place)>,
}

/// The directrix at a parameter: its derivative and curvature as they count in the plane, and the surface's frame.
struct Rule {
    speed: f64,
    turn: f64,
    tangent: Vector3,
    side: Vector3,
}

impl<'a> Development<'a> {
    fn new(surface: &'a Surface, reversed: bool, tolerance: &Tolerance) -> Result<Self> {
        let limit = tolerance.positive_distance()?;
        let up = if reversed { -1.0 } else { 1.0 };
        let straight = |direction: Direction| -> Result<bool> {
            let domain = surface.domain(direction.other());
            for k in 0..PLACES {
                let t = domain.at(k as f64 / (PLACES - 1) as f64);
                if !surface.isocurve(direction, t)?.is_linear(0.1 * limit) {
                    return Ok(false);
                }
            }
            Ok(true)
        };
        let mut known =
            Err(Error::degenerate("face", "it is not straight in any direction of its parameters"));
        for along in [Direction::V, Direction::U] {
            if !straight(along)? {
                continue;
            }
            let found = Self::along(surface, along, up, tolerance);
            if found.is_ok() {
                return found;
            }
            known = found;
        }
        known
    }

    fn along(surface: &'a Surface, along: Direction, up: f64, tolerance: &Tolerance) -> Result<Self> {
        let across = along.other();
        if !surface.kinks(across, tolerance.angle).is_empty() {
            return Err(Error::degenerate("face", "it has kinks, at which it must be divided first"));
        }
        let domain = surface.domain(along);
        // The end at which the directrix is nowhere slow: not at the tip of a cone.
        let slowest = |v: f64| {
            let us = surface.domain(across);
            let speed = |k: usize| {
                let u = us.at(k as f64 / (PLACES - 1) as f64);
                derivatives(surface, across, u, v, false).1.length()
            };
            (0..PLACES).map(speed).fold(f64::INFINITY, f64::min)
        };
        let start = if slowest(domain.end) > slowest(domain.start) { domain.end } else { domain.start };
        let mut sheet = Self { surface, across, start, up, places: Vec::new() };
        sheet.check_normals(along, tolerance.angle)?;
        sheet.lay(0.01 * tolerance.positive_distance()?)?;
        Ok(sheet)
    }

    /// Refuses surfaces whose normal turns along a straight line.
    fn check_normals(&self, along: Direction, angle: f64) -> Result<()> {
        let (us, vs) = (self.surface.domain(self.across), self.surface.domain(along));
        let share = |k: usize| (k as f64 + 0.5) / PLACES as f64;
        for i in 0..PLACES {
            let normal = |v: f64| {
                let u = us.at(share(i));
                if self.across == Direction::U {
                    self.surface.normal_at(u, v)
                } else {
                    self.surface.normal_at(v, u)
                }
            };
            let first = normal(vs.at(share(0)));
            for j in 1..PLACES {
                let turn = first.zip(normal(vs.at(share(j)))).and_then(|(a, b)| a.angle_to(b));
                if turn.is_some_and(|turn| turn > angle) {
                    return Err(Error::degenerate(
                        "face",
                        "it cannot be unrolled: its normal turns along its lines",
                    ));
                }
            }
        }
        Ok(())
    }

    fn rule(&self, u: f64, below: bool) -> Result<Rule> {
        let (_, first, second, normal) = derivatives(self.surface, self.across, u, self.start, below);
        let none = || Error::degenerate("face", "it has no normal along an edge");
        let (speed, normal) = (first.length(), normal.unitized().ok_or_else(none)? * self.up);
        let tangent = first.unitized().ok_or_else(none)?;
        let side = normal.cross(tangent);
        Ok(Rule { speed, turn: second.dot(side) / speed, tangent, side })
    }

    /// One step of Runge and Kutta's method of fourth order along the directrix.
    fn step(&self, from: Place, u: f64, h: f64) -> Result<Place> {
        let [a, b, c] = [self.rule(u, false)?, self.rule(u + 0.5 * h, false)?, self.rule(u + h, true)?];
        let angle = |part: f64| from.angle + part;
        // The angle does not depend on the place: its stages are Simpson's rule and its halves.
        let middle = angle(h * (5.0 * a.turn + 8.0 * b.turn - c.turn) / 24.0);
        let last = angle(h * (a.turn + 4.0 * b.turn + c.turn) / 6.0);
        let sum = |f: fn(f64) -> f64| {
            h * (a.speed * f(from.angle) + 4.0 * b.speed * f(middle) + c.speed * f(last)) / 6.0
        };
        Ok(Place { x: from.x + sum(f64::cosine), y: from.y + sum(f64::sine), angle: last })
    }

    /// Lays the directrix into the plane, with steps that are halved until nothing moves by more than a limit.
    fn lay(&mut self, limit: f64) -> Result<()> {
        let spans = self.surface.span_parameters(self.across);
        let Some(&first) = spans.first() else { return Err(Error::degenerate("face", "it has no domain")) };
        let mut place = Place { x: 0.0, y: 0.0, angle: 0.0 };
        self.places.push((first, place));
        for w in spans.windows(2) {
            let (from, length) = (w[0], w[1] - w[0]);
            let mut count = 8;
            let mut known = self.walk(place, from, length, count)?;
            loop {
                count *= 2;
                let finer = self.walk(place, from, length, count)?;
                let ends = known.last().zip(finer.last());
                let moved = ends.map_or(0.0, |((_, a), (_, b))| (a.x - b.x).hypotenuse(a.y - b.y));
                known = finer;
                if moved <= limit {
                    break;
                }
                if count >= MOST_STEPS {
                    return Err(Error::degenerate("face", "it cannot be laid flat within the tolerance"));
                }
            }
            place = known.last().map_or(place, |(_, place)| *place);
            self.places.append(&mut known);
        }
        Ok(())
    }

    fn walk(&self, mut place: Place, from: f64, length: f64, count: usize) -> Result<Vec<(f64, Place)>> {
        let mut out = Vec::with_capacity(count);
        for k in 0..count {
            let at = |k: usize| from + length * (k as f64 / count as f64);
            place = self.step(place, at(k), at(k + 1) - at(k))?;
            out.push((at(k + 1), place));
        }
        Ok(out)
    }

    /// The image of parameters, and that of a direction in which they move.
    fn image(&self, uv: Vector3, slope: Vector3) -> Result<(Point3, Vector3)> {
        let u = if self.across == Direction::U { uv.x } else { uv.y };
        let before = self.places.partition_point(|(t, _)| *t <= u).saturating_sub(1);
        let Some(&(t, place)) = self.places.get(before) else {
            return Err(Error::degenerate("face", "it has no domain"));
        };
        let place = if u == t { place } else { self.step(place, t, u - t)? };
        let rule = self.rule(u, u >= self.surface.domain(self.across).end)?;
        let origin = derivatives(self.surface, self.across, u, self.start, false).0;
        let d = self.surface.derivatives(uv.x, uv.y, 1, self.surface.inner_quadrant(uv.x, uv.y));
        let moved = d.get(1, 0) * slope.x + d.get(0, 1) * slope.y;
        let (sin, cos) = place.angle.sine_cosine();
        let flat = |w: Vector3| {
            let (a, b) = (w.dot(rule.tangent), w.dot(rule.side));
            Vector3::new(a * cos - b * sin, a * sin + b * cos, 0.0)
        };
        Ok((Point3::new(place.x, place.y, 0.0) + flat(d.point() - origin), flat(moved)))
    }
}

/// The point at (u, v), first and second derivative in the direction of u, and the normal, where u runs in `across`.
fn derivatives(
    surface: &Surface,
    across: Direction,
    u: f64,
    v: f64,
    below: bool,
) -> (Point3, Vector3, Vector3, Vector3) {
    let (x, y) = if across == Direction::U { (u, v) } else { (v, u) };
    let inner = surface.inner_quadrant(x, y).from_below();
    let below = [
        if across == Direction::U { below || inner[0] } else { inner[0] },
        if across == Direction::V { below || inner[1] } else { inner[1] },
    ];
    let d = surface.derivatives(x, y, 2, Quadrant::new(below[0], below[1]));
    let normal = d.get(1, 0).cross(d.get(0, 1));
    match across {
        Direction::U => (d.point(), d.get(1, 0), d.get(2, 0), normal),
        Direction::V => (d.point(), d.get(0, 1), d.get(0, 2), normal),
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use crate::brep::testing::area;
    use crate::{
        Brep, Cone, Curve, Cylinder, Interval, NurbsCurve, NurbsSurface, Plane, Point3, Sphere, SumSurface,
        Surface, Tolerance, Vector3, Xform,
    };

    fn tolerance() -> Tolerance {
        Tolerance { absolute: 1e-4, ..Tolerance::default() }
    }

    fn lengths(brep: &Brep) -> Vec<f64> {
        let curves = (0..brep.edges().len()).filter_map(|e| brep.edge_as_curve(e).unwrap());
        let mut all: Vec<f64> = curves.map(|c| c.length()).collect();
        all.sort_by(f64::total_cmp);
        all
    }

    /// Area and edges are those of the face; seams count twice.
    fn check(surface: Surface, edges: &[f64], wanted: f64) {
        let brep = Brep::from_surface(surface).unwrap();
        for brep in [brep.clone(), brep.flipped()] {
            let flat = brep.unrolled_face(0, &tolerance()).unwrap();
            assert_eq!(flat.faults(), []);
            assert!((area(&flat) / wanted - 1.0).abs() < 1e-4, "{} {wanted}", area(&flat));
            let found = lengths(&flat);
            assert_eq!(found.len(), edges.len(), "{found:?}");
            for (a, b) in found.iter().zip(edges) {
                assert!((a - b).abs() < 1e-3, "{found:?} {edges:?}");
            }
            assert!(flat.bounding_box_in(&Plane::XY).unwrap().z.length() < 1e-9);
        }
    }

    #[test]
    fn round_ones() {
        let tilted = Plane::from_normal(Point3::new(1.0, 2.0, 3.0), Vector3::new(1.0, -1.0, 2.0)).unwrap();
        let tube = Cylinder::new(tilted, 2.0, Interval::new(0.0, 3.0)).unwrap();
        check(tube.into(), &[3.0, 3.0, 4.0 * PI, 4.0 * PI], 12.0 * PI);
        // Slant √2: a sector of a disc.
        let (cone, slant) = (Cone::new(tilted, 1.0, 1.0).unwrap(), 2.0_f64.sqrt());
        check(cone.into(), &[slant, slant, 2.0 * PI], slant * PI);
    }

    fn wave() -> NurbsCurve {
        let points = [(0.0, 0.0), (1.0, 2.0), (3.0, -1.0), (5.0, 2.0), (6.0, 0.0)]
            .map(|(x, y)| Point3::new(x, y, 0.0));
        NurbsCurve::clamped_uniform(3, &points).unwrap()
    }

    #[test]
    fn free_ones() {
        let profile: Curve = wave().into();
        // An oblique extrusion: both edges are the profile.
        let way = Vector3::new(0.5, 0.3, 2.0);
        let wall: Surface = SumSurface::extrusion(profile.clone(), way).unwrap().into();
        let brep = Brep::from_surface(wall.clone()).unwrap();
        let (long, short) = (profile.length(), way.length());
        check(wall, &[short, short, long, long], area(&brep));
        // A piece of a cone over the wave.
        let apex = Point3::new(2.0, 1.0, 4.0);
        let inner: Curve = profile.transformed(&Xform::scale(apex, 0.4)).unwrap();
        let cone = NurbsSurface::ruled(&wave(), &inner.to_nurbs().unwrap()).unwrap();
        let brep = Brep::from_surface(cone.clone().into()).unwrap();
        let mut edges = [
            long,
            0.4 * long,
            0.6 * apex.distance_to(profile.start()),
            0.6 * apex.distance_to(profile.end()),
        ];
        edges.sort_by(f64::total_cmp);
        check(cone.clone().into(), &edges, area(&brep));
        check(cone.transposed().into(), &edges, area(&brep));
    }

    #[test]
    fn holes_stay_as_large() {
        let tube: Surface = Cylinder::new(Plane::XY, 2.0, Interval::new(0.0, 3.0)).unwrap().into();
        let [u, v] = crate::Direction::BOTH.map(|d| tube.domain(d));
        // An ellipse in the parameter plane inside the domain.
        let middle = Plane::XY.with_origin(Point3::new(u.middle(), v.middle(), 0.0));
        let hole = crate::Ellipse { plane: middle, rx: 0.2 * u.length(), ry: 0.2 * v.length() };
        let ring: Curve = hole.to_nurbs().unwrap().into();
        let corners =
            [(u.start, v.start), (u.end, v.start), (u.end, v.end), (u.start, v.end), (u.start, v.start)];
        let frame = crate::PolylineCurve::new(corners.map(|(x, y)| Point3::new(x, y, 0.0)).to_vec()).unwrap();
        let pieces = Brep::from_parameter_loops(&tube, &[frame.into(), ring], &tolerance()).unwrap();
        let flat = pieces[0].unrolled_face(0, &tolerance()).unwrap();
        assert_eq!(flat.loops().len(), 2);
        assert!((area(&flat) - area(&pieces[0])).abs() < 1e-3);
    }

    #[test]
    fn what_cannot_be_unrolled() {
        let unroll = |surface: Surface| Brep::from_surface(surface).unwrap().unrolled_face(0, &tolerance());
        assert!(unroll(Sphere::new(Plane::XY, 1.0).unwrap().into()).is_err());
        let p = |x: f64, y: f64, z: f64| Point3::new(x, y, z);
        let saddle = NurbsSurface::clamped_uniform(
            [1, 1],
            [2, 2],
            &[p(0.0, 0.0, 0.0), p(0.0, 1.0, 1.0), p(1.0, 0.0, 1.0), p(1.0, 1.0, 0.0)],
        );
        let twisted = unroll(saddle.unwrap().into());
        assert!(twisted.is_err_and(|e| e.to_string().contains("normal turns")));
        let flat = unroll(Surface::from(
            crate::PlaneSurface::new(Plane::YZ, Interval::UNIT, Interval::new(0.0, 2.0)).unwrap(),
        ));
        assert!((area(&flat.unwrap()) - 2.0).abs() < 1e-9);
    }
}
