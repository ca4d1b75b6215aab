//! The two faces along an edge, and the ball between them.

use katydid_elementary::Elementary;

use super::FilletRail;
use super::joint::Fans;
use super::names::Names;
use super::newton::{jacobian, linear, solve};
use crate::brep::fillet::thresholds::{DISTINCT, LEAST_ANGLE, TOUCH_SINE};
use crate::thresholds;
use crate::{Brep, ClosestOnSurface, Curve, Direction, Point3, Result, Surface, Tolerance, Vector3};

/// Places along an edge where its faces are looked at.
const LOOKS: usize = 9;
/// In how many steps the ball grows when it is not found at once.
const GROWTH: u32 = 12;

/// The unknowns of a station: the parameters of both contacts, and the radius.
pub(super) type Unknowns = [f64; 5];

/// The radius at both ends of an edge. Between different ones it runs along a cubic that starts and ends level, so that
/// strips that meet at the ends go on in each other without a kink.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Radius(pub [f64; 2]);

impl Radius {
    pub(super) fn is_constant(self) -> bool {
        self.0[0] == self.0[1]
    }

    /// The radius at a share of the edge.
    fn at(self, x: f64) -> f64 {
        let x = x.clamp(0.0, 1.0);
        let [a, b] = self.0;
        if self.is_constant() { a } else { a + (b - a) * x * x * (3.0 - 2.0 * x) }
    }

    pub(super) fn at_end(self, at_end: bool) -> f64 {
        self.0[usize::from(at_end)]
    }

    pub(super) fn largest(self) -> f64 {
        self.0[0].max(self.0[1])
    }

    fn fault(self) -> Option<f64> {
        self.0.into_iter().find(|r| !r.is_finite() || *r <= 0.0)
    }
}

/// Two faces that meet along an edge at an angle.
pub(super) struct Wedge<'a> {
    pub edge: usize,
    names: &'a Names,
    pub curve: Curve,
    pub trims: [usize; 2],
    pub faces: [usize; 2],
    pub surfaces: [&'a Surface; 2],
    /// On which side of each surface the ball lies: 1 on the side of its normal, −1 on the other.
    pub sides: [f64; 2],
    pub size: f64,
    pub radius: Radius,
    rail: FilletRail,
    steps: Unknowns,
    /// Whether the contacts keep pace with the edge, instead of the ball's centre: between roundings that bend more than
    /// the ball a centre that does so would let them run backwards.
    pub by_contacts: bool,
    /// In which directions the surfaces close.
    closed: [[bool; 2]; 2],
    /// Parameters on both surfaces, and the ways from the edge into both faces, half-way along the edge.
    middle: ([[f64; 2]; 2], [Vector3; 2]),
}

/// The ball at one place of an edge.
#[derive(Debug, Clone, Copy)]
pub(super) struct Station {
    pub unknowns: Unknowns,
    pub contacts: [Point3; 2],
    pub centre: Point3,
    pub radius: f64,
}

impl Station {
    /// The unit vectors from the centre to the contacts.
    pub(super) fn arms(&self) -> [Vector3; 2] {
        self.contacts.map(|c| (c - self.centre) / self.radius)
    }
}

impl<'a> Wedge<'a> {
    pub(super) fn new(
        fans: &Fans<'a>,
        edge: usize,
        radius: Radius,
        rail: FilletRail,
        tolerance: &Tolerance,
    ) -> Result<Self> {
        let Fans { brep, names } = *fans;
        let Some(own) = brep.edges().get(edge).filter(|own| !own.deleted) else {
            let last = brep.edges().len();
            return Err(names.refused(edge, &format!("there is no such edge; the shape has {last} edges")));
        };
        if let Some(radius) = radius.fault() {
            return Err(names.refused(edge, &format!("its radius is {radius}, which must be greater than 0")));
        }
        let &[first, second] = own.trims.as_slice() else {
            let why = match own.trims.len() {
                0 | 1 => "it is naked: only one face ends there",
                _ => "more than two faces meet there",
            };
            return Err(names.refused(edge, why));
        };
        let trims = [first, second];
        let found = || -> Option<_> {
            let faces = [brep.face_of(first)?, brep.face_of(second)?];
            let surfaces = [brep.face_surface(faces[0])?, brep.face_surface(faces[1])?];
            Some((faces, surfaces, brep.edge_as_curve(edge).ok()??))
        };
        let (faces, surfaces, curve) =
            found().ok_or_else(|| names.refused(edge, "it has no faces or no curve"))?;
        if faces[0] == faces[1] {
            return Err(names.refused(edge, "it is a seam of one face"));
        }
        let extent = curve.bounding_box().diagonal().length();
        let steps = {
            let [u1, v1, u2, v2] =
                [(0, Direction::U), (0, Direction::V), (1, Direction::U), (1, Direction::V)]
                    .map(|(k, d): (usize, _)| thresholds::DIFFERENCE_STEP * surfaces[k].domain(d).length());
            [u1, v1, u2, v2, thresholds::DIFFERENCE_STEP * radius.largest()]
        };
        let mut wedge = Self {
            edge,
            names,
            curve,
            trims,
            faces,
            surfaces,
            sides: [0.0; 2],
            size: extent + radius.largest(),
            radius,
            rail,
            steps,
            by_contacts: false,
            closed: surfaces.map(|surface| Direction::BOTH.map(|d| surface.is_closed(d))),
            middle: ([[0.0; 2]; 2], [Vector3::ZERO; 2]),
        };
        wedge.look(brep, tolerance)?;
        Ok(wedge)
    }

    /// Finds out on which sides of the faces the ball lies, from the angle of the faces all along the edge.
    fn look(&mut self, brep: &Brep, tolerance: &Tolerance) -> Result<()> {
        let domain = self.curve.domain();
        let feet = [ClosestOnSurface::new(self.surfaces[0])?, ClosestOnSurface::new(self.surfaces[1])?];
        let least = tolerance.angle.clamp(LEAST_ANGLE, 0.5).sine();
        for n in 0..LOOKS {
            // The middle last, so that what it tells stays.
            let x = if n + 1 == LOOKS { 0.5 } else { (n as f64 + 0.5) / LOOKS as f64 };
            let t = domain.at(x);
            let p = self.curve.point_at(t);
            let tangent = self.curve.tangent_at(t).ok_or_else(|| self.refused("it has no direction"))?;
            let mut ways = [Vector3::ZERO; 2];
            let mut normals = [Vector3::ZERO; 2];
            let mut places = [[0.0; 2]; 2];
            for k in 0..2 {
                let place = self.foot(k, brep, &feet[k], t, p)?;
                let normal = self
                    .normal(k, place[0], place[1])
                    .ok_or_else(|| self.refused("a face has no normal along it"))?;
                let reversed = brep.trims().get(self.trims[k]).is_some_and(|trim| trim.reversed);
                // A face lies to the left of its trims.
                let way = normal.cross(if reversed { -tangent } else { tangent });
                (ways[k], normals[k], places[k]) = (way, normal, place);
            }
            let heights = [normals[0].dot(ways[1]), normals[1].dot(ways[0])];
            if heights.iter().any(|h| h.abs() < least) {
                let why = if ways[0].dot(ways[1]) < 0.0 {
                    "its faces meet smoothly: there is nothing to round"
                } else {
                    "its faces lie upon each other"
                };
                return Err(self.refused(why));
            }
            let sides = heights.map(f64::signum);
            if n > 0 && sides != self.sides {
                return Err(self
                    .refused("it is convex in one part and concave in another, which is not supported yet"));
            }
            self.sides = sides;
            self.middle = (places, ways);
        }
        Ok(())
    }

    /// The parameters of a point of the edge on one surface, on the turn on which the trim runs.
    fn foot(&self, k: usize, brep: &Brep, index: &ClosestOnSurface, t: f64, p: Point3) -> Result<[f64; 2]> {
        let found = index.nearest(p)?;
        let mut place = [found.u, found.v];
        let x = self.curve.domain().normalized(t);
        let trim = brep.trims().get(self.trims[k]);
        let along = trim.map(|own| own.part.domain.at(if own.reversed { 1.0 - x } else { x }));
        let near = along.and_then(|s| brep.trim_point(self.trims[k], s));
        if let Some(near) = near {
            for (n, d) in Direction::BOTH.into_iter().enumerate() {
                let at = if n == 0 { near.x } else { near.y };
                let period = self.surfaces[k].domain(d).length();
                if self.surfaces[k].is_closed(d) {
                    place[n] += ((at - place[n]) / period).round() * period;
                }
            }
        }
        Ok(place)
    }

    /// Parameters over a seam brought back to the domain.
    fn inside(&self, k: usize, u: f64, v: f64) -> [f64; 2] {
        let mut place = [u, v];
        for d in Direction::BOTH {
            let (n, domain) = (d.index(), self.surfaces[k].domain(d));
            if self.closed[k][n] && !domain.contains(place[n]) {
                place[n] = domain.wrapped(place[n]);
            }
        }
        place
    }

    fn point(&self, k: usize, u: f64, v: f64) -> Point3 {
        let [u, v] = self.inside(k, u, v);
        self.surfaces[k].point_at(u, v)
    }

    /// The unit normal of a surface, also beyond its domain.
    fn normal(&self, k: usize, u: f64, v: f64) -> Option<Vector3> {
        let surface = self.surfaces[k];
        let [u, v] = self.inside(k, u, v);
        let d = surface.derivatives(u, v, 1, surface.inner_quadrant(u, v));
        d.get(1, 0).cross(d.get(0, 1)).unitized()
    }

    fn station_of(&self, x: &Unknowns) -> Option<(Station, [Point3; 2])> {
        let contacts = [self.point(0, x[0], x[1]), self.point(1, x[2], x[3])];
        let normals = [self.normal(0, x[0], x[1])?, self.normal(1, x[2], x[3])?];
        let centres = [0, 1].map(|k: usize| contacts[k] + normals[k] * (self.sides[k] * x[4]));
        let centre = centres[0].lerp(centres[1], 0.5);
        Some((Station { unknowns: *x, contacts, centre, radius: x[4] }, centres))
    }

    /// The equations of a station: both offsets meet, in the plane square to the edge; and what the rails ask for.
    fn residual(&self, x: &Unknowns, t: f64, radius: f64) -> Option<Unknowns> {
        let (station, centres) = self.station_of(x)?;
        let apart = centres[0] - centres[1];
        let [p, velocity] = self.curve.jet_at::<2>(t, t > self.curve.domain().middle());
        let tangent = velocity.unitized()?;
        let p = p.to_point();
        let [a, b] = station.contacts;
        let wanted = match self.rail {
            FilletRail::RollingBall => x[4] - radius,
            FilletRail::DistanceFromEdge => 0.5 * (a.distance_to(p) + b.distance_to(p)) - radius,
            FilletRail::DistanceBetweenRails => a.distance_to(b) - radius,
        };
        let pace = if self.by_contacts { a.lerp(b, 0.5) } else { station.centre };
        Some([apart.x, apart.y, apart.z, (pace - p).dot(tangent), wanted])
    }

    /// The ball at a parameter of the edge, from what it is nearby.
    pub(super) fn station(&self, t: f64, near: &Unknowns) -> Option<Station> {
        self.grown(t, near, self.radius_at(t))
    }

    fn radius_at(&self, t: f64) -> f64 {
        self.radius.at(self.curve.domain().normalized(t))
    }

    fn grown(&self, t: f64, near: &Unknowns, radius: f64) -> Option<Station> {
        let x = solve(*near, &self.steps, self.size, |x| self.residual(x, t, radius))?;
        let station = self.station_of(&x)?.0;
        let distinct = station.contacts[0].distance_to(station.contacts[1]) > DISTINCT * radius;
        (x[4] > 0.0 && distinct).then_some(station)
    }

    /// The ball half-way along the edge.
    pub(super) fn first(&self) -> Result<Station> {
        let t = self.curve.domain().middle();
        let whole = self.radius_at(t);
        let (places, ways) = &self.middle;
        let half = 0.5 * ways[0].angle_to(ways[1]).unwrap_or(1.0);
        let guess = |radius: f64| -> Option<Unknowns> {
            let ball = match self.rail {
                FilletRail::RollingBall => radius,
                FilletRail::DistanceFromEdge => radius * half.tangent(),
                FilletRail::DistanceBetweenRails => 0.5 * radius / half.cosine(),
            };
            let reach = ball / half.tangent();
            let mut x = [0.0, 0.0, 0.0, 0.0, ball];
            for k in 0..2 {
                let surface = self.surfaces[k];
                let [u, v] = places[k];
                let d = surface.derivatives(u, v, 1, surface.inner_quadrant(u, v));
                let (a, b) = (d.get(1, 0), d.get(0, 1));
                let way = ways[k] * reach;
                let slopes = [[a.dot(a), a.dot(b)], [a.dot(b), b.dot(b)]];
                let [du, dv] = linear(slopes, [a.dot(way), b.dot(way)])?;
                x[2 * k] = u + du;
                x[2 * k + 1] = v + dv;
            }
            Some(x)
        };
        let at_once = guess(whole).and_then(|x| self.grown(t, &x, whole));
        let found = at_once.filter(|s| self.is_beside(s)).or_else(|| {
            let mut near: Option<Unknowns> = None;
            for k in 1..=GROWTH {
                let radius = whole * f64::from(k) / f64::from(GROWTH);
                let from = match near {
                    Some(x) => x,
                    None => guess(radius)?,
                };
                near = Some(self.grown(t, &from, radius)?.unknowns);
            }
            self.station_of(&near?).map(|(station, _)| station)
        });
        found.filter(|s| self.is_beside(s)).ok_or_else(|| self.too_large())
    }

    /// Whether the contacts half-way along the edge lie on the faces' side of it.
    fn is_beside(&self, station: &Station) -> bool {
        let p = self.curve.point_at(self.curve.domain().middle());
        (0..2).all(|k| (station.contacts[k] - p).dot(self.middle.1[k]) > 0.0)
    }

    /// The refusal of the edge by name.
    pub(super) fn refused(&self, why: &str) -> crate::Error {
        self.names.refused(self.edge, why)
    }

    /// The ball where both faces touch each other at an end of the edge.
    pub(super) fn touching(&self, t: f64) -> Option<Station> {
        let p = self.curve.point_at(t);
        let mut unknowns = [0.0, 0.0, 0.0, 0.0, self.radius_at(t)];
        let mut normals = [Vector3::ZERO; 2];
        for k in 0..2 {
            let near = ClosestOnSurface::new(self.surfaces[k]).ok()?.nearest(p).ok()?;
            (unknowns[2 * k], unknowns[2 * k + 1]) = (near.u, near.v);
            normals[k] = self.normal(k, near.u, near.v)? * self.sides[k];
        }
        let middle = (normals[0] + normals[1]).unitized()?;
        let touch = normals[0].cross(normals[1]).length() <= TOUCH_SINE;
        let centre = p + middle * unknowns[4];
        touch.then_some(Station { unknowns, contacts: [p; 2], centre, radius: unknowns[4] })
    }

    pub(super) fn too_large(&self) -> crate::Error {
        self.refused(&format!("the radius {} is too large for its faces", self.radius.largest()))
    }

    /// Whether the ball lies behind both faces: then the edge loses material, or else it gains some.
    pub(super) fn is_convex(&self, brep: &Brep) -> bool {
        (self.sides[0] < 0.0) != brep.is_reversed(self.faces[0])
    }

    /// The derivative of the unknowns along the edge.
    pub(super) fn slope(&self, x: &Unknowns, t: f64) -> Option<Unknowns> {
        let slopes = jacobian(x, &self.steps, |x| self.residual(x, t, self.radius_at(t)))?;
        let step = thresholds::DIFFERENCE_STEP * self.curve.domain().length();
        let ahead = self.residual(x, t + step, self.radius_at(t + step))?;
        let behind = self.residual(x, t - step, self.radius_at(t - step))?;
        let along: Unknowns = std::array::from_fn(|k| (behind[k] - ahead[k]) / (2.0 * step));
        let solved = linear(slopes, along)?;
        Some(std::array::from_fn(|k| solved[k] * self.steps[k]))
    }

    /// The station that unknowns stand for, solved or not.
    pub(super) fn of(&self, x: &Unknowns) -> Option<Station> {
        self.station_of(x).map(|(station, _)| station)
    }

    /// Whether the surfaces bend away from the ball, or less than it does, at its contacts: otherwise it would not fit.
    pub(super) fn fits(&self, station: &Station) -> bool {
        (0..2).all(|k| {
            let [u, v] = [station.unknowns[2 * k], station.unknowns[2 * k + 1]];
            let [hu, hv] = [self.steps[2 * k], self.steps[2 * k + 1]];
            let offset = |u: f64, v: f64| {
                let reach = self.sides[k] * station.radius;
                Some(self.point(k, u, v) + self.normal(k, u, v)? * reach)
            };
            let turned = || {
                let a = offset(u + hu, v)? - offset(u - hu, v)?;
                let b = offset(u, v + hv)? - offset(u, v - hv)?;
                Some(a.cross(b).dot(self.normal(k, u, v)?))
            };
            turned().is_some_and(|sense| sense > 0.0)
        })
    }

    /// The curvature of a surface at its contact along the way on which the arc leaves it, as a vector.
    pub(super) fn bend(&self, station: &Station, k: usize, way: Vector3) -> Vector3 {
        let [u, v] = self.inside(k, station.unknowns[2 * k], station.unknowns[2 * k + 1]);
        let surface = self.surfaces[k];
        let d = surface.derivatives(u, v, 2, surface.inner_quadrant(u, v));
        let (a, b) = (d.get(1, 0), d.get(0, 1));
        let slopes = [[a.dot(a), a.dot(b)], [a.dot(b), b.dot(b)]];
        let Some([p, q]) = linear(slopes, [a.dot(way), b.dot(way)]) else { return Vector3::ZERO };
        let Some(normal) = a.cross(b).unitized() else { return Vector3::ZERO };
        let second = d.get(2, 0) * (p * p) + d.get(1, 1) * (2.0 * p * q) + d.get(0, 2) * (q * q);
        normal * second.dot(normal)
    }
}
