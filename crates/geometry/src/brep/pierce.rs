//! Where curves meet breps, and what of curves on surfaces lies within trims.

use super::inside::{ClosestOnBrep, Sheet};
use super::trimmed;
use crate::brep::thresholds::INSIDE_ENDS;
use crate::intersect::curve_with_surface;
use crate::thresholds;
use crate::{Curve, Interval, Point3, Result, Surface, Vector3};

/// A point that a curve and a brep have in common.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BrepCrossing {
    /// The parameter on the curve.
    pub t: f64,
    /// The point.
    pub point: Point3,
    /// The face; on an edge one of those beside it.
    pub face: usize,
    /// The parameters on the face's surface.
    pub uv: [f64; 2],
    /// The normal of the face there, as the face is turned; `None` where the surface has none.
    pub normal: Option<Vector3>,
}

/// All that a curve and a brep have in common.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct BrepPiercing {
    /// The points, in the order of the curve; a point on an edge is one.
    pub crossings: Vec<BrepCrossing>,
    /// The ranges of the curve that lie in faces, in order.
    pub overlaps: Vec<Interval>,
    /// Whether the search came to its end on every face.
    pub complete: bool,
}

/// Samples of a curve between which it is taken to keep to one side of the trims, for each smooth piece.
const SAMPLES: usize = 24;
/// The most samples of one curve.
const MOST: usize = 2_000;
/// Halvings from a sample to the border.
const HALVINGS: usize = 46;

impl ClosestOnBrep {
    /// All points and stretches that a curve has in common with the faces, within `tolerance`, trims respected.
    ///
    /// # Errors
    /// The tolerance is not finite and above 0, or a number overflows.
    pub fn curve_crossings(&self, curve: &Curve, tolerance: f64) -> Result<BrepPiercing> {
        let mut out = BrepPiercing { complete: true, ..BrepPiercing::default() };
        let around = curve.bounding_box();
        for sheet in self.sheets() {
            if sheet.bounds.distance_to_box(&around) > tolerance {
                continue;
            }
            let Some(surface) = self.brep().face_surface(sheet.face) else { continue };
            let found = curve_with_surface(curve, surface, tolerance)?;
            out.complete &= found.complete;
            for c in &found.crossings {
                if sheet.covers(c.u, c.v) || self.near_loop(sheet, c.point, tolerance)? {
                    let normal = surface.normal_at(c.u, c.v);
                    let normal = normal.map(|n| if sheet.reversed { -n } else { n });
                    let (uv, face) = ([c.u, c.v], sheet.face);
                    out.crossings.push(BrepCrossing { t: c.t, point: c.point, face, uv, normal });
                }
            }
            for overlap in &found.overlaps {
                out.overlaps.extend(self.covered(sheet, surface, curve, overlap.t, tolerance)?);
            }
        }
        let least = thresholds::SAME_PARAMETER * curve.domain().length();
        out.overlaps.sort_by(|a, b| a.start.total_cmp(&b.start));
        out.overlaps = merged(std::mem::take(&mut out.overlaps), least);
        out.crossings.sort_by(|a, b| a.t.total_cmp(&b.t));
        let overlaps = &out.overlaps;
        out.crossings.retain(|c| !overlaps.iter().any(|o| o.start - least <= c.t && c.t <= o.end + least));
        // Both faces beside an edge have found what lies on it.
        let same = |a: &BrepCrossing, b: &BrepCrossing| a.point.distance_to(b.point) <= 2.0 * tolerance;
        out.crossings.dedup_by(|b, a| same(a, b));
        // The start of a closed curve is its end.
        let first = out.crossings.first().copied();
        if curve.is_closed() && out.crossings.len() > 1 {
            out.crossings.pop_if(|last| first.is_some_and(|first| same(&first, last)));
        }
        Ok(out)
    }

    /// The parts of a curve on the surface of a face that lie within its trims, in order. It is asked at many places
    /// of each smooth piece; a part between two of them may be missed.
    ///
    /// # Errors
    /// There is no such face, or a number overflows.
    pub fn curve_on_face(&self, face: usize, curve: &Curve) -> Result<Vec<Curve>> {
        self.curve_within(face, curve, 0.0)
    }

    /// As [`Self::curve_on_face`], with what is nearer to an edge than a distance.
    pub(super) fn curve_within(&self, face: usize, curve: &Curve, near_edges: f64) -> Result<Vec<Curve>> {
        let sheet = self.sheets().iter().find(|s| s.face == face).ok_or_else(trimmed::no_face)?;
        let surface = self.brep().face_surface(face).ok_or_else(trimmed::no_face)?;
        let domain = curve.domain();
        let mut out = Vec::new();
        for range in self.covered(sheet, surface, curve, domain, near_edges)? {
            let whole = range.start <= domain.start && domain.end <= range.end;
            if whole {
                out.push(curve.clone());
            } else if let Ok(part) = curve.trimmed(range) {
                out.push(part);
            }
        }
        Ok(out)
    }

    /// The parts of a range of a curve on a surface that lie within the trims of its face, or nearer to its edges than
    /// a distance: along an edge, rounding decides what the trims say. Where a part leaves the face across an edge it
    /// ends there.
    fn covered(
        &self,
        sheet: &Sheet,
        surface: &Surface,
        curve: &Curve,
        range: Interval,
        near_edges: f64,
    ) -> Result<Vec<Interval>> {
        let close = |t: f64, distance: f64| -> Result<bool> {
            crate::cancellation::check()?;
            let p = curve.point_at(t);
            let [u, v] = match surface {
                Surface::Plane(flat) => flat.parameters_of(p),
                _ => {
                    let near = sheet.closest(self.brep())?.nearest(p)?;
                    // Beyond the surface's end the nearest place lies on its edge.
                    if distance > 0.0 && near.distance > 2.0 * distance {
                        return Ok(false);
                    }
                    [near.u, near.v]
                }
            };
            Ok(sheet.covers(u, v) || (distance > 0.0 && self.near_loop(sheet, p, distance)?))
        };
        let inside = |t: f64| close(t, near_edges);
        let rounding = (thresholds::SAME_POINT * sheet.bounds.diagonal().length()).min(near_edges);
        let count = (SAMPLES * curve.pieces().len()).clamp(SAMPLES, MOST);
        // Not at the very ends, which often lie on the border.
        let places = (0..=count).map(|k| {
            let share = k as f64 / count as f64;
            range.at(share.clamp(INSIDE_ENDS, 1.0 - INSIDE_ENDS))
        });
        let mut found: Vec<Interval> = Vec::new();
        let mut before: Option<(f64, bool)> = None;
        let mut from = None;
        for t in places {
            let now = inside(t)?;
            match before {
                None if now => from = Some(range.start),
                Some((last, was)) if was != now => {
                    let (mut low, mut high) = (last, t);
                    for _ in 0..HALVINGS {
                        let middle = 0.5 * (low + high);
                        if inside(middle)? == was { low = middle } else { high = middle }
                    }
                    let at = 0.5 * (low + high);
                    match from.take() {
                        Some(start) if was => found.push(Interval::new(start, at)),
                        _ => from = Some(at),
                    }
                }
                _ => {}
            }
            before = Some((t, now));
        }
        found.extend(from.map(|start| Interval::new(start, range.end)));
        if near_edges > 0.0 {
            // Up to the edge itself, where the part does not go on beside it.
            let step = range.length() / count as f64;
            let sure = |t: f64| close(t, rounding);
            for part in &mut found {
                let inward = (0.5 * part.length()).min(step);
                part.start = Self::edge_between(curve, [part.start, part.start + inward], near_edges, &sure)?;
                part.end = Self::edge_between(curve, [part.end, part.end - inward], near_edges, &sure)?;
            }
        }
        Ok(found)
    }

    /// The place, from the first parameter to the second, at which the curve comes to be surely on the face: the first
    /// parameter itself when it is there already, or when that is not within some distances of it.
    fn edge_between(
        curve: &Curve,
        [from, to]: [f64; 2],
        distance: f64,
        sure: &impl Fn(f64) -> Result<bool>,
    ) -> Result<f64> {
        if sure(from)? || !sure(to)? {
            return Ok(from);
        }
        let (mut low, mut high) = (from, to);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if sure(middle)? { high = middle } else { low = middle }
        }
        let near = curve.point_at(high).distance_to(curve.point_at(from)) <= 10.0 * distance;
        Ok(if near { high } else { from })
    }
}

/// Increasing ranges with those that meet made one.
fn merged(ranges: Vec<Interval>, least: f64) -> Vec<Interval> {
    let mut out: Vec<Interval> = Vec::new();
    for range in ranges {
        match out.last_mut() {
            Some(last) if range.start <= last.end + least => last.end = last.end.max(range.end),
            _ => out.push(range),
        }
    }
    out
}
