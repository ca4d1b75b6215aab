//! Which side of a closed brep is the inside.

use katydid_elementary::Elementary;

use super::{Brep, CurvePart, Parts, Solidity, Trim};
use crate::brep::thresholds::NO_VOLUME;
use crate::quadrature::GAUSS_6;
use crate::{Curve, Direction, Interval, Point3, Surface};

/// Parts into which a range of a surface is divided where its pieces are fewer and no polynomials that the rule is
/// exact for.
const PARTS: usize = 4;
/// Parts into which each piece of a curved trim is divided.
const TRIM_PARTS: usize = 8;
/// The rule is exact for polynomials up to degree 11, and the density of a surface of degree p has degree 3p − 1.
const EXACT_DEGREE: usize = 4;

/// Gauss's rule of two points, for what many breaks divide finely.
const GAUSS_2: [[f64; 2]; 1] = [[0.577_350_269_189_625_7, 1.0]];
/// What is divided into more parts than this takes the short rule.
const MANY: usize = 12;

/// The rule for a range with so many breaks in it.
fn rule(breaks: &[f64]) -> &'static [[f64; 2]] {
    if breaks.len() > MANY { GAUSS_2.as_slice() } else { GAUSS_6.as_slice() }
}

/// The integral over a range, by a rule in each part between increasing breaks.
fn integral(range: Interval, breaks: &[f64], rule: &[[f64; 2]], mut f: impl FnMut(f64) -> f64) -> f64 {
    let [low, high] = [range.min(), range.max()];
    let mut sum = 0.0;
    let mut from = low;
    let inner = breaks.iter().copied().filter(|t| low < *t && *t < high);
    for to in inner.chain(std::iter::once(high)) {
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        for [x, weight] in rule {
            sum += weight * half * (f(middle - half * x) + f(middle + half * x));
        }
        from = to;
    }
    if range.start <= range.end { sum } else { -sum }
}

/// Whether a curve consists of polynomials that the rule is exact for.
fn is_plain(curve: &Curve) -> bool {
    match curve {
        Curve::Line(_) | Curve::Polyline(_) => true,
        Curve::Nurbs(c) => !c.is_rational() && c.degree() <= EXACT_DEGREE,
        Curve::Arc(_) => false,
        Curve::Poly(c) => c.segments().iter().all(is_plain),
    }
}

/// Where the integral over a direction is divided: at the knots, and evenly where the rule is not exact between few.
fn breaks(surface: &Surface, direction: Direction) -> Vec<f64> {
    let spans = surface.span_parameters(direction);
    let exact = match surface {
        Surface::Plane(_) => true,
        Surface::Sum(s) => s.curves().get(direction.index()).is_some_and(is_plain),
        Surface::Nurbs(s) => !s.is_rational() && s.degree(direction) <= EXACT_DEGREE,
        // As for a sum along what is turned; around the axis it is no polynomial.
        Surface::Revolution(s) => s.angle_direction() != direction && is_plain(s.profile()),
    };
    if exact || spans.len() > PARTS {
        return spans;
    }
    let domain = surface.domain(direction);
    let mut all = spans;
    all.extend((1..PARTS).map(|k| domain.at(k as f64 / PARTS as f64)));
    all.sort_by(f64::total_cmp);
    all
}

/// Where the integral along a trim is divided: where a straight one crosses the surface's knots, else evenly.
fn stops(surface: &Surface, curve: &Curve, part: &CurvePart) -> Vec<f64> {
    let domain = part.domain;
    if let Curve::Line(_) = curve {
        let (a, b) = (part.point_at(curve, domain.start).x, part.point_at(curve, domain.end).x);
        let mut out: Vec<f64> =
            breaks(surface, Direction::U).iter().map(|u| domain.at((u - a) / (b - a))).collect();
        out.retain(|t| t.is_finite());
        out.sort_by(f64::total_cmp);
        return out;
    }
    let count = TRIM_PARTS * curve.pieces().len().min(16);
    (1..count).map(|k| domain.at(k as f64 / count as f64)).collect()
}

/// Whether position · normal of a surface is the same all along v: of planes, and of curves drawn straight.
fn is_even_along_v(surface: &Surface) -> bool {
    match surface {
        Surface::Plane(_) => true,
        Surface::Sum(s) => matches!(s.curves(), [_, Curve::Line(_)]),
        _ => false,
    }
}

/// Whether v runs along the rulings of a cylinder or cone, or a segment that is turned otherwise. There position · normal is
/// a square of v: place, and derivative by the angle, change evenly, that by v not at all. The short rule is exact.
fn is_square_along_v(surface: &Surface) -> bool {
    matches!(surface, Surface::Revolution(s)
        if s.angle_direction() == Direction::U && matches!(s.profile(), Curve::Line(_)))
}

/// The places at which a whole turn is looked at.
const TURN_PLACES: usize = 4;

/// Whether a straight trim goes round a surface of revolution once, all at one height. Along such a one position · normal is a
/// constant and a sine of the angle, whatever the origin, and their sum over any even division of the turn in three or more
/// is exact.
fn is_whole_turn(surface: &Surface, curve: &Curve, part: &CurvePart) -> bool {
    let (Surface::Revolution(s), Curve::Line(_)) = (surface, curve) else { return false };
    if s.angle_direction() != Direction::U || !s.is_full_turn() {
        return false;
    }
    let [a, b] = [part.domain.start, part.domain.end].map(|t| part.point_at(curve, t));
    let domain = surface.domain(Direction::U);
    a.y == b.y && [a.x.min(b.x), a.x.max(b.x)] == [domain.min(), domain.max()]
}

/// A third of position · normal, by the area of parameters.
fn density(surface: &Surface, u: f64, v: f64, origin: Point3) -> f64 {
    let d = surface.derivatives(u, v, 1, surface.inner_quadrant(u, v));
    (d.point() - origin).dot(d.get(1, 0).cross(d.get(0, 1))) / 3.0
}

impl Parts {
    /// The volume that the faces enclose, positive when their normals point outwards, to a few digits: by the
    /// divergence theorem over each face, and by Green's theorem along its trims.
    fn flux_of_faces(&self, origin: Point3) -> f64 {
        let mut volume = 0.0;
        for face in self.faces.iter().filter(|face| !face.deleted) {
            let Some(surface) = self.face_surface(face) else { continue };
            let trims = face.loops.iter().filter_map(|l| self.loops.get(*l)).flat_map(|chain| &chain.trims);
            let trims = trims.filter_map(|t| self.trims.get(*t));
            let flux: f64 = if surface.is_affine() {
                let [u, v] = Direction::BOTH.map(|d| surface.domain(d).start);
                let density = density(surface, u, v, origin);
                trims.map(|trim| self.flat_flux(trim, surface, origin, density)).sum()
            } else {
                trims.map(|trim| self.flux(trim, surface, origin)).sum()
            };
            volume += if face.reversed { -flux } else { flux };
        }
        volume
    }

    /// The share of a trim where what is integrated is the same everywhere: exact for straight ones and arcs.
    fn flat_flux(&self, trim: &Trim, surface: &Surface, origin: Point3, density: f64) -> f64 {
        let part = &trim.part;
        let Some(curve @ (Curve::Line(_) | Curve::Arc(_))) = self.trim_curve(trim) else {
            return self.flux(trim, surface, origin);
        };
        let [p, q] = [part.domain.start, part.domain.end].map(|t| part.point_at(curve, t));
        let floor = surface.domain(Direction::V).start;
        let below_chord = (q.x - p.x) * (0.5 * (p.y + q.y) - floor);
        let beyond_chord = if let Curve::Arc(c) = curve {
            // The segment between arc and chord: r²/2 (α − sin α), to the right of the chord where the arc turns left.
            let turned = c.arc.angle.length() / c.domain.length() * part.range.length();
            let left = c.arc.circle.plane.z_axis.z * if part.reversed { -1.0 } else { 1.0 };
            0.5 * c.arc.circle.radius * c.arc.circle.radius * left * (turned.sine() - turned)
        } else {
            0.0
        };
        -density * (below_chord + beyond_chord)
    }

    /// The share of a trim in the integral of a third of position · normal over its face.
    fn flux(&self, trim: &Trim, surface: &Surface, origin: Point3) -> f64 {
        let Some(curve) = self.trim_curve(trim) else { return 0.0 };
        let part = &trim.part;
        if let Curve::Line(line) = curve
            && line.line.from.x == line.line.to.x
        {
            return 0.0;
        }
        let even = is_even_along_v(surface);
        let rows = if even { Vec::new() } else { breaks(surface, Direction::V) };
        let along_rows = if is_square_along_v(surface) { GAUSS_2.as_slice() } else { rule(&rows) };
        let floor = surface.domain(Direction::V).start;
        let density = |u: f64, v: f64| density(surface, u, v, origin);
        let speed = part.range.length() / part.domain.length() * if part.reversed { -1.0 } else { 1.0 };
        let share = |t: f64| {
            let [place, slope] = curve.jet_at::<2>(part.to_curve_parameter(t), false);
            let slope = slope.x * speed;
            // Between the floor and itself there is nothing.
            if slope == 0.0 || place.y == floor {
                return 0.0;
            }
            if even {
                return slope * (place.y - floor) * density(place.x, floor);
            }
            slope * integral(Interval::new(floor, place.y), &rows, along_rows, |v| density(place.x, v))
        };
        if is_whole_turn(surface, curve, part) {
            let step = (part.domain.end - part.domain.start) / TURN_PLACES as f64;
            let places = (0..TURN_PLACES).map(|k| part.domain.start + step * (k as f64 + 0.5));
            return -step * places.map(share).sum::<f64>();
        }
        let stops = stops(surface, curve, part);
        -integral(part.domain, &stops, rule(&stops), share)
    }
}

impl Brep {
    /// Which way the normals of a closed brep point, by the sign of its volume; unknown for one that is not closed or
    /// encloses next to nothing.
    pub fn solid_orientation(&self) -> Solidity {
        if !self.is_solid() {
            return Solidity::Unknown;
        }
        let Some(bounds) = self.bounds_of_corners().or_else(|| self.bounds_of_faces()) else {
            return Solidity::Unknown;
        };
        let size = bounds.diagonal().length();
        let volume = self.parts().flux_of_faces(bounds.center());
        if !(volume.abs() > NO_VOLUME * size.powi(3)) {
            Solidity::Unknown
        } else if volume > 0.0 {
            Solidity::Outward
        } else {
            Solidity::Inward
        }
    }

    /// The volume of a closed brep to a few digits, positive when its normals point outwards; 0 where it has no faces.
    pub(super) fn rough_volume(&self) -> f64 {
        let bounds = self.bounds_of_corners().or_else(|| self.bounds_of_faces());
        bounds.map_or(0.0, |b| self.parts().flux_of_faces(b.center()))
    }

    /// The box around the vertices of a polyhedron, whose faces are flat and edges straight.
    fn bounds_of_corners(&self) -> Option<crate::BoundingBox> {
        let parts = self.parts();
        let live = parts.faces.iter().filter(|face| !face.deleted);
        let flat = live.clone().all(|face| parts.face_surface(face).is_some_and(Surface::is_affine));
        let edges = parts.edges.iter().filter(|edge| !edge.deleted);
        let straight = edges.clone().all(|edge| matches!(parts.edge_curve(edge), Some(Curve::Line(_))));
        let corners = parts.vertices.iter().filter(|vertex| !vertex.deleted).map(|vertex| vertex.point);
        if flat && straight { crate::BoundingBox::from_points(corners) } else { None }
    }

    /// The same faces seen from the other side.
    #[must_use]
    pub fn flipped(self) -> Self {
        let mut parts = self.into_parts();
        parts.faces.iter_mut().for_each(|face| face.reversed = !face.reversed);
        parts.solidity = match parts.solidity {
            Solidity::Unknown => Solidity::Unknown,
            Solidity::Outward => Solidity::Inward,
            Solidity::Inward => Solidity::Outward,
        };
        if let Some(regions) = &mut parts.regions {
            regions.sides.iter_mut().for_each(|side| side.direction = -side.direction);
        }
        Self { parts }
    }

    /// A closed brep with its normals outward, and what is known of its inside written down; any other as it is.
    #[must_use]
    pub fn turned_outward(self) -> Self {
        match self.solid_orientation() {
            Solidity::Inward => self.flipped().with_solidity(Solidity::Outward),
            known => self.with_solidity(known),
        }
    }

    fn with_solidity(mut self, solidity: Solidity) -> Self {
        self.parts.solidity = solidity;
        self
    }
}
