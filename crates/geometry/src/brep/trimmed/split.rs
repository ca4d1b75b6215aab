//! Faces cut along curves and along lines of constant parameter, and surfaces cut down.

use super::super::Brep;
use super::{cells, flat_tolerance, frame, no_face, over_seams};
use crate::region::{FillRule, Region};
use crate::{Curve, Direction, Interval, Plane, Result, Surface, Tolerance};

impl Surface {
    /// The part of the surface over ranges of both parameters, as an untrimmed brep with these ranges as its domains;
    /// ranges are cut down to the domain.
    ///
    /// # Errors
    /// A range has no part of the domain.
    pub fn isotrimmed(&self, u: Interval, v: Interval) -> Result<Brep> {
        let part = |d: Direction, range: Interval| {
            range
                .ordered()
                .intersection(self.domain(d))
                .filter(|r| r.is_increasing())
                .ok_or(crate::Error::degenerate("part of a surface", "its range lies outside the domain"))
        };
        let (u, v) = (part(Direction::U, u)?, part(Direction::V, v)?);
        Brep::from_surface(self.sub_surface(u, v)?)
    }
}

impl Brep {
    /// A face cut along curves, open or closed, that lie on it or near it and are pulled to it. Each piece is a brep of
    /// one face on the same surface. Stretches that separate nothing, because the curves end inside a piece, leave no
    /// trace: a face that nothing cuts through comes back alone.
    ///
    /// # Errors
    /// The face does not exist, a curve leaps from one part of the surface to another when it is pulled, the curves
    /// meet too often, or an edge cannot be followed within the tolerance.
    pub fn face_split(&self, face: usize, curves: &[Curve], tolerance: &Tolerance) -> Result<Vec<Self>> {
        let surface = self.face_surface(face).ok_or_else(no_face)?;
        let flat = flat_tolerance(surface, tolerance.positive_distance()?);
        let mut cutters = Vec::with_capacity(curves.len());
        for curve in curves {
            let pulled = surface.parameter_curve(curve, tolerance)?;
            for by in over_seams(surface, &pulled.bounding_box(), flat) {
                cutters.push(pulled.transformed(&by)?);
            }
        }
        let mut out = Vec::new();
        for piece in self.face_region(face, tolerance)?.split(&cutters, flat)? {
            out.extend(cells::of_region(surface, self.is_reversed(face), &piece, tolerance)?);
        }
        Ok(out)
    }

    /// A face cut along lines of constant parameter: along those of constant u at the first list, of constant v at the
    /// second. Each piece is a brep of one face on the same surface.
    ///
    /// # Errors
    /// The face does not exist, a parameter is not finite, or an edge cannot be followed within the tolerance.
    pub fn face_split_at(&self, face: usize, cuts: [&[f64]; 2], tolerance: &Tolerance) -> Result<Vec<Self>> {
        let surface = self.face_surface(face).ok_or_else(no_face)?;
        let flat = flat_tolerance(surface, tolerance.positive_distance()?);
        let own = self.face_region(face, tolerance)?;
        let strips = Direction::BOTH.map(|d| {
            let domain = surface.domain(d);
            let mut stops = vec![domain.start];
            stops.extend(cuts[d.index()].iter().copied().filter(|t| domain.start < *t && *t < domain.end));
            stops.push(domain.end);
            stops.sort_by(f64::total_cmp);
            stops.dedup();
            stops
        });
        let mut out = Vec::new();
        for u in strips[0].windows(2) {
            for v in strips[1].windows(2) {
                let ranges = [Interval::new(u[0], u[1]), Interval::new(v[0], v[1])];
                let tile = Region::new(&[frame(ranges)?], FillRule::Any, &Plane::XY, flat)?;
                let part = own.intersection(&tile, flat)?;
                out.extend(cells::of_region(surface, self.is_reversed(face), &part, tolerance)?);
            }
        }
        Ok(out)
    }

    /// A face on the smallest part of its surface that holds its loops; the trims stay as they are.
    ///
    /// # Errors
    /// The face does not exist.
    pub fn shrunk_face(&self, face: usize, tolerance: &Tolerance) -> Result<Self> {
        let surface = self.face_surface(face).ok_or_else(no_face)?;
        let flat = flat_tolerance(surface, tolerance.positive_distance()?);
        let own = self.face_region(face, tolerance)?;
        let bounds = own.curves().iter().map(crate::Curve::bounding_box).reduce(|a, b| a.union(&b));
        let Some(bounds) = bounds else { return self.sub_brep(&[face]) };
        let reach = [(bounds.min.x, bounds.max.x), (bounds.min.y, bounds.max.y)];
        let mut small = surface.clone();
        for d in Direction::BOTH {
            let (domain, (low, high)) = (surface.domain(d), reach[d.index()]);
            let range = Interval::new(
                if low - domain.start <= flat { domain.start } else { low },
                if domain.end - high <= flat { domain.end } else { high },
            );
            if range != domain && range.is_increasing() {
                small = small.trimmed(d, range)?;
            }
        }
        let mut parts = cells::of_region(&small, self.is_reversed(face), &own, tolerance)?;
        match (parts.pop(), parts.len()) {
            (Some(only), 0) => Ok(only),
            _ => self.sub_brep(&[face]),
        }
    }
}
