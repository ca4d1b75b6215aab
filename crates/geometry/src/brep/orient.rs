//! Which side of a closed brep is the inside.

use super::{Brep, CurvePart, Parts, Solidity, Trim};
use crate::quadrature::GAUSS_6;
use crate::{Curve, Direction, Interval, Point3, Surface};

/// Parts into which a range is divided where it has no knots to say.
const PARTS: usize = 8;

/// The integral over a range, by parts.
fn integral(range: Interval, breaks: &[f64], mut f: impl FnMut(f64) -> f64) -> f64 {
    let [low, high] = [range.min(), range.max()];
    let inner = breaks.iter().copied().filter(|t| low < *t && *t < high);
    let stops: Vec<f64> = std::iter::once(low).chain(inner).chain(std::iter::once(high)).collect();
    let mut sum = 0.0;
    for w in stops.windows(2) {
        let (middle, half) = (0.5 * (w[0] + w[1]), 0.5 * (w[1] - w[0]));
        for [x, weight] in GAUSS_6 {
            sum += weight * half * (f(middle - half * x) + f(middle + half * x));
        }
    }
    if range.start <= range.end { sum } else { -sum }
}

/// The knots of a direction, or even parts where there are few.
fn breaks(surface: &Surface, direction: Direction) -> Vec<f64> {
    let spans = surface.span_parameters(direction);
    if spans.len() > PARTS {
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
    let count = PARTS * curve.pieces().len().min(16);
    (1..count).map(|k| domain.at(k as f64 / count as f64)).collect()
}

impl Parts {
    /// The volume that the faces enclose, positive when their normals point outwards, to a few digits: by the
    /// divergence theorem over each face, and by Green's theorem along its trims.
    fn rough_volume(&self, origin: Point3) -> f64 {
        let mut volume = 0.0;
        for face in self.faces.iter().filter(|face| !face.deleted) {
            let Some(surface) = self.face_surface(face) else { continue };
            let trims = face.loops.iter().filter_map(|l| self.loops.get(*l)).flat_map(|chain| &chain.trims);
            let flux: f64 =
                trims.filter_map(|t| self.trims.get(*t)).map(|trim| self.flux(trim, surface, origin)).sum();
            volume += if face.reversed { -flux } else { flux };
        }
        volume
    }

    /// The share of a trim in the integral of a third of position · normal over its face.
    fn flux(&self, trim: &Trim, surface: &Surface, origin: Point3) -> f64 {
        let Some(curve) = self.trim_curve(trim) else { return 0.0 };
        let part = &trim.part;
        let rows = breaks(surface, Direction::V);
        let floor = surface.domain(Direction::V).start;
        let density = |u: f64, v: f64| {
            let d = surface.derivatives(u, v, 1, surface.inner_quadrant(u, v));
            (d.point() - origin).dot(d.get(1, 0).cross(d.get(0, 1))) / 3.0
        };
        let speed = part.range.length() / part.domain.length() * if part.reversed { -1.0 } else { 1.0 };
        -integral(part.domain, &stops(surface, curve, part), |t| {
            let [place, slope] = curve.jet_at::<2>(part.to_curve_parameter(t), false);
            let slope = slope.x * speed;
            if slope == 0.0 {
                return 0.0;
            }
            slope * integral(Interval::new(floor, place.y), &rows, |v| density(place.x, v))
        })
    }
}

impl Brep {
    /// Which way the normals of a closed brep point, by the sign of its volume; unknown for one that is not closed or
    /// encloses next to nothing.
    pub fn solid_orientation(&self) -> Solidity {
        let Some(bounds) = self.bounds_of_faces().filter(|_| self.is_solid()) else {
            return Solidity::Unknown;
        };
        let size = bounds.diagonal().length();
        let volume = self.parts().rough_volume(bounds.center());
        if !(volume.abs() > 1e-9 * size.powi(3)) {
            Solidity::Unknown
        } else if volume > 0.0 {
            Solidity::Outward
        } else {
            Solidity::Inward
        }
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
