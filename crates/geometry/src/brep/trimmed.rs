//! Faces from loops in the parameter plane, and what can be done with their trims.
//!
//! Trimming never changes a surface: the loops are cut out of regions of the parameter plane, and edges are their
//! images.

mod cells;
mod lift;
mod pull_back;
mod rim;
mod split;
mod unroll;

pub(super) use lift::followed;

use super::Brep;
use crate::brep::thresholds::WIDEST_GAP;
use crate::region::{FillRule, Region};
use crate::{
    BoundingBox, Curve, Direction, Error, Interval, Plane, Point3, PolylineCurve, Result, Surface, Tolerance,
    Vector3, Xform,
};

/// The domain of a surface as a closed curve in the parameter plane, counter-clockwise.
pub(super) fn frame(domains: [Interval; 2]) -> Result<Curve> {
    let [u, v] = domains;
    let corners =
        [(u.start, v.start), (u.end, v.start), (u.end, v.end), (u.start, v.end), (u.start, v.start)];
    Ok(PolylineCurve::new(corners.iter().map(|(u, v)| Point3::new(*u, *v, 0.0)).collect())?.into())
}

/// How far parameters may be off so that points are no more than `limit` off.
pub(super) fn flat_tolerance(surface: &Surface, limit: f64) -> f64 {
    let [u, v] = Direction::BOTH.map(|d| surface.domain(d));
    let mut fastest = 0.0_f64;
    for x in [0.0, 0.25, 0.5, 0.75, 1.0] {
        for y in [0.0, 0.25, 0.5, 0.75, 1.0] {
            let d = surface.derivatives(u.at(x), v.at(y), 1, surface.inner_quadrant(u.at(x), v.at(y)));
            fastest = fastest.max(d.get(1, 0).length()).max(d.get(0, 1).length());
        }
    }
    let widest = WIDEST_GAP * u.length().min(v.length());
    if fastest > 0.0 { (limit / fastest).min(widest) } else { widest }
}

impl Brep {
    /// The parts of a surface that closed curves in its parameter plane (x is u, y is v) enclose, each as a brep of
    /// one face: of nested curves every other ring. What lies outside the domain is cut off; where the surface closes,
    /// curves may reach over the seam by up to a period.
    ///
    /// # Errors
    /// A curve is open, the tolerance not above 0, or an edge cannot be followed within the tolerance.
    pub fn from_parameter_loops(
        surface: &Surface,
        loops: &[Curve],
        tolerance: &Tolerance,
    ) -> Result<Vec<Self>> {
        let limit = tolerance.positive_distance()?;
        let region = folded(surface, loops, limit)?;
        cells::of_region(surface, false, &region, tolerance)
    }

    /// The parts of a surface inside closed curves that lie on it or near it, each as a brep of one face; the curves
    /// are pulled to the surface. Of nested curves every other ring remains, so that inner ones make holes.
    ///
    /// # Errors
    /// A curve is open, runs round a closed surface, or leaps from one part of the surface to another when it is
    /// pulled; or as [`Brep::from_parameter_loops`].
    pub fn trimmed_surface(surface: &Surface, curves: &[Curve], tolerance: &Tolerance) -> Result<Vec<Self>> {
        let loops = surface.pulled_loops(curves, tolerance)?;
        Self::from_parameter_loops(surface, &loops, tolerance)
    }

    /// The region of the parameter plane that a face covers.
    ///
    /// # Errors
    /// The face does not exist, or its loops are so broken that they enclose nothing.
    pub fn face_region(&self, face: usize, tolerance: &Tolerance) -> Result<Region> {
        let surface = self.face_surface(face).ok_or_else(no_face)?;
        let limit = flat_tolerance(surface, tolerance.positive_distance()?);
        Region::new(&self.face_loops(face)?, FillRule::NonZero, &Plane::XY, limit)
    }

    /// The loops of a face as closed curves in the parameter plane, the outer one first.
    ///
    /// # Errors
    /// The face does not exist, or a loop has no curves.
    pub fn face_loops(&self, face: usize) -> Result<Vec<Curve>> {
        let own = self.faces().get(face).ok_or_else(no_face)?;
        let mut out = Vec::with_capacity(own.loops.len());
        for chain in own.loops.iter().filter_map(|l| self.loops().get(*l)) {
            let mut parts = Vec::with_capacity(chain.trims.len());
            for trim in &chain.trims {
                parts.extend(self.trim_as_curve(*trim)?);
            }
            if parts.is_empty() {
                return Err(Error::degenerate("loop", "it has no curves"));
            }
            out.push(crate::curve::chained(parts, 0.0));
        }
        Ok(out)
    }

    /// A face with all its holes and cuts undone: its whole surface.
    ///
    /// # Errors
    /// The face does not exist.
    pub fn untrimmed_face(&self, face: usize) -> Result<Self> {
        let surface = self.face_surface(face).ok_or_else(no_face)?;
        let whole = Self::from_surface(surface.clone())?;
        Ok(if self.is_reversed(face) { whole.flipped() } else { whole })
    }

    pub(super) fn is_reversed(&self, face: usize) -> bool {
        self.faces().get(face).is_some_and(|face| face.reversed)
    }

    /// A face with holes cut along closed curves that lie on it or near it; the surface stays as it is. Where a curve
    /// crosses the border of the face, only the part inside is cut away. There may be several pieces, or none.
    ///
    /// # Errors
    /// As [`Brep::trimmed_surface`]; the face does not exist.
    pub fn face_with_holes(&self, face: usize, curves: &[Curve], tolerance: &Tolerance) -> Result<Vec<Self>> {
        self.face_combined(face, curves, Region::difference, tolerance)
    }

    /// The part of a face inside closed curves that lie on it or near it; the surface stays as it is.
    ///
    /// # Errors
    /// As [`Brep::trimmed_surface`]; the face does not exist.
    pub fn face_inside(&self, face: usize, curves: &[Curve], tolerance: &Tolerance) -> Result<Vec<Self>> {
        self.face_combined(face, curves, Region::intersection, tolerance)
    }

    fn face_combined(
        &self,
        face: usize,
        curves: &[Curve],
        combine: impl Fn(&Region, &Region, f64) -> Result<Region>,
        tolerance: &Tolerance,
    ) -> Result<Vec<Self>> {
        let surface = self.face_surface(face).ok_or_else(no_face)?;
        let loops = surface.pulled_loops(curves, tolerance)?;
        let limit = tolerance.positive_distance()?;
        let tool = folded(surface, &loops, limit)?;
        let own = self.face_region(face, tolerance)?;
        let left = combine(&own, &tool, flat_tolerance(surface, limit))?;
        cells::of_region(surface, self.is_reversed(face), &left, tolerance)
    }

    /// Another surface trimmed as a face is, by share of the domains: the loops are the same in parameters from 0 to
    /// 1.
    ///
    /// # Errors
    /// The face does not exist, or an edge cannot be followed within the tolerance.
    pub fn copied_trims(&self, face: usize, target: &Surface, tolerance: &Tolerance) -> Result<Vec<Self>> {
        let surface = self.face_surface(face).ok_or_else(no_face)?;
        let [from, to] = [surface, target].map(|s| Direction::BOTH.map(|d| s.domain(d)));
        let scale = [0, 1].map(|k: usize| to[k].length() / from[k].length());
        let x = Vector3::new(scale[0], 0.0, 0.0);
        let y = Vector3::new(0.0, scale[1], 0.0);
        let origin =
            Point3::new(to[0].start - from[0].start * scale[0], to[1].start - from[1].start * scale[1], 0.0);
        let map = Xform::from_columns(x, y, Vector3::Z, origin);
        let mut loops = Vec::new();
        for curve in self.face_loops(face)? {
            loops.push(lift::in_parameter_plane(&curve.transformed(&map)?)?);
        }
        Self::from_parameter_loops(target, &loops, tolerance)
    }

    /// Another surface trimmed along the edges of a face, which are pulled to it.
    ///
    /// # Errors
    /// The face does not exist; or as [`Brep::trimmed_surface`].
    pub fn retrimmed(&self, face: usize, target: &Surface, tolerance: &Tolerance) -> Result<Vec<Self>> {
        let own = self.faces().get(face).ok_or_else(no_face)?;
        let mut curves = Vec::new();
        for chain in own.loops.iter().filter_map(|l| self.loops().get(*l)) {
            let mut parts = Vec::new();
            for trim in chain.trims.iter().filter_map(|t| self.trims().get(*t)) {
                let Some(edge) = trim.edge else { continue };
                let Some(curve) = self.edge_as_curve(edge)? else { continue };
                parts.push(if trim.reversed { curve.reversed() } else { curve });
            }
            let gap = 10.0 * tolerance.absolute;
            curves.extend(crate::join_curves(&parts, gap, true));
        }
        Self::trimmed_surface(target, &curves, tolerance)
    }
}

pub(super) fn no_face() -> Error {
    Error::Invalid { what: "brep", why: "there is no such face".into() }
}

/// What loops enclose of a surface's domain: those that reach over a seam come in again on the other side.
fn folded(surface: &Surface, loops: &[Curve], limit: f64) -> Result<Region> {
    let domains = Direction::BOTH.map(|d| surface.domain(d));
    let flat = flat_tolerance(surface, limit);
    let whole = Region::new(&[frame(domains)?], FillRule::Any, &Plane::XY, flat)?;
    let bounds = loops.iter().map(Curve::bounding_box).reduce(|a, b| a.union(&b));
    let Some(bounds) = bounds else { return Ok(whole) };
    let mut all: Option<Region> = None;
    for by in over_seams(surface, &bounds, flat) {
        let moved = loops.iter().map(|c| c.transformed(&by)).collect::<Result<Vec<_>>>()?;
        let inside = Region::new(&moved, FillRule::EvenOdd, &Plane::XY, flat)?.intersection(&whole, flat)?;
        all = Some(match all {
            Some(before) => before.symmetric_difference(&inside, flat)?,
            None => inside,
        });
    }
    Ok(all.unwrap_or(whole))
}

/// The moves by periods that bring what reaches over a seam in again on the other side; first none at all.
fn over_seams(surface: &Surface, bounds: &BoundingBox, flat: f64) -> Vec<Xform> {
    let reach = [(bounds.min.x, bounds.max.x), (bounds.min.y, bounds.max.y)];
    let [x, y] = Direction::BOTH.map(|d| {
        let (domain, (low, high)) = (surface.domain(d), reach[d.index()]);
        let mut out = vec![0.0];
        if surface.is_closed(d) {
            if low < domain.start - flat {
                out.push(domain.length());
            }
            if high > domain.end + flat {
                out.push(-domain.length());
            }
        }
        out
    });
    x.iter().flat_map(|&x| y.iter().map(move |&y| Xform::translation(Vector3::new(x, y, 0.0)))).collect()
}
