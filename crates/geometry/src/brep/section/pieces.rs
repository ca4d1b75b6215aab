//! What a plane cuts out of one face.

use super::super::build::with_ends;
use super::super::inside::Sheet;
use super::{BrepSection, BrepSections, EdgeContacts, lies_in};
use crate::thresholds;
use crate::{Curve, Line, Plane, Point3, Result, Surface, intersect::surface_plane};

/// A face and a plane that comes near it.
pub(super) struct Cut<'a> {
    pub(super) sections: &'a BrepSections,
    pub(super) sheet: &'a Sheet,
    pub(super) plane: &'a Plane,
    pub(super) contacts: &'a [EdgeContacts],
}

/// Places on a stretch where it is asked whether it lies in the face.
const PLACES: [f64; 5] = [0.5, 0.03, 0.97, 0.27, 0.71];
/// Halvings towards the border of the face where no edge told it.
const HALVINGS: usize = 44;

impl Cut<'_> {
    /// Adds the curves of the face to a section.
    pub(super) fn add_to(&self, out: &mut BrepSection) -> Result<()> {
        let brep = self.sections.brep();
        let Some(surface) = brep.face_surface(self.sheet.face) else { return Ok(()) };
        let noise = self.sections.noise(self.plane);
        if lies_in(surface, self.plane, 10.0 * noise) {
            return Ok(());
        }
        // Where the edges of the face meet the plane.
        let edges = brep.trims_of(self.sheet.face);
        let edges = edges.iter().filter_map(|t| brep.trims().get(*t)?.edge);
        let mut ends: Vec<(Point3, f64)> = Vec::new();
        let mut flat: Vec<&Curve> = Vec::new();
        for edge in edges {
            let Some(found) = self.contacts.get(edge) else { continue };
            let off = brep.edges().get(edge).map_or(0.0, |e| e.tolerance.max(0.0));
            ends.extend(found.points.iter().map(|p| (*p, off)));
            flat.extend(found.stretches.iter().map(|(_, curve)| curve));
        }
        let whole = match surface {
            Surface::Plane(own) => self.line(own.plane(), &ends).into_iter().collect(),
            other => {
                let section = surface_plane(other, self.plane, &self.sections.tolerance)?;
                out.complete &= section.complete;
                section.curves
            }
        };
        for curve in whole {
            out.curves.extend(self.inside(&curve, &ends, &flat)?);
        }
        Ok(())
    }

    /// The line in which a flat face meets the plane, from its first edge to its last.
    fn line(&self, own: &Plane, ends: &[(Point3, f64)]) -> Option<Curve> {
        let way = own.z_axis.cross(self.plane.z_axis).unitized()?;
        let (first, _) = ends.first()?;
        let place = |p: &Point3| (*p - *first).dot(way);
        let along = ends.iter().map(|(p, _)| (place(p), *p));
        let low = along.clone().min_by(|a, b| a.0.total_cmp(&b.0))?;
        let high = along.max_by(|a, b| a.0.total_cmp(&b.0))?;
        (high.0 - low.0 > self.sections.noise(self.plane)).then(|| Line::new(low.1, high.1).into())
    }

    /// Whether a point of the section lies in the face.
    fn covers(&self, p: Point3) -> Result<bool> {
        let brep = self.sections.brep();
        let [u, v] = match brep.face_surface(self.sheet.face) {
            Some(Surface::Plane(flat)) => flat.parameters_of(p),
            _ => {
                let near = self.sheet.closest(brep)?.nearest(p)?;
                [near.u, near.v]
            }
        };
        Ok(self.sheet.covers(u, v))
    }

    /// The parts of a curve on the surface that lie in the face, ending exactly where its edges meet the plane; not
    /// those along edges that lie in the plane, which are counted by themselves.
    fn inside(&self, curve: &Curve, ends: &[(Point3, f64)], flat: &[&Curve]) -> Result<Vec<Curve>> {
        let tolerance = self.sections.tolerance.absolute;
        let domain = curve.domain();
        let least = thresholds::SAME_PARAMETER * domain.length();
        let mut stops = vec![domain.start, domain.end];
        for (p, off) in ends {
            if let Some(near) = curve.closest_point_within(*p, 4.0 * (tolerance + off))? {
                stops.push(near.parameter);
            }
        }
        stops.sort_by(f64::total_cmp);
        stops.dedup_by(|a, b| *a - *b <= least);
        if let Some(last) = stops.last_mut() {
            *last = domain.end;
        }
        let mut runs: Vec<[f64; 2]> = Vec::new();
        for w in stops.windows(2) {
            if self.runs_along(curve, [w[0], w[1]], flat)? {
                continue;
            }
            for run in self.runs([w[0], w[1]], curve)? {
                match runs.last_mut() {
                    Some(last) if run[0] - last[1] <= least => last[1] = run[1],
                    _ => runs.push(run),
                }
            }
        }
        let mut out = Vec::new();
        for [a, b] in runs {
            let whole = a <= domain.start && domain.end <= b;
            let range = crate::Interval::new(a, b);
            let Ok(part) = (if whole { Ok(curve.clone()) } else { curve.trimmed(range) }) else { continue };
            if whole && part.is_closed() {
                out.push(part);
                continue;
            }
            let found = [part.start(), part.end()].map(|p| nearest_end(p, ends, 10.0 * tolerance));
            // What is no longer than the gap that is closed at its ends is part of it.
            if found[0] == found[1] && part.length() <= 20.0 * tolerance {
                continue;
            }
            out.push(with_ends(&part, found)?);
        }
        Ok(out)
    }

    /// The parts of a stretch between two edges that lie in the face: mostly all of it or nothing.
    fn runs(&self, [a, b]: [f64; 2], curve: &Curve) -> Result<Vec<[f64; 2]>> {
        let mut known = Vec::with_capacity(PLACES.len());
        for place in PLACES {
            let t = a + (b - a) * place;
            known.push((t, self.covers(curve.point_at(t))?));
        }
        known.sort_by(|x, y| x.0.total_cmp(&y.0));
        let short =
            curve.point_at(a).distance_to(curve.point_at(b)) <= 10.0 * self.sections.tolerance.absolute;
        if known.iter().all(|k| k.1) || (short && known.get(2).is_some_and(|k| k.1)) {
            return Ok(vec![[a, b]]);
        }
        if !known.iter().any(|k| k.1) || short {
            return Ok(Vec::new());
        }
        let mut cuts = vec![a];
        for w in known.windows(2) {
            let ((mut low, inside), (mut high, other)) = (w[0], w[1]);
            if inside == other {
                continue;
            }
            for _ in 0..HALVINGS {
                let middle = 0.5 * (low + high);
                if self.covers(curve.point_at(middle))? == inside {
                    low = middle;
                } else {
                    high = middle;
                }
            }
            cuts.push(0.5 * (low + high));
        }
        cuts.push(b);
        let first = known.first().is_some_and(|k| k.1);
        let runs = cuts.windows(2).enumerate().filter(|(k, _)| (k % 2 == 0) == first);
        Ok(runs.map(|(_, w)| [w[0], w[1]]).collect())
    }

    /// Whether a stretch is one of an edge in the plane.
    fn runs_along(&self, curve: &Curve, [a, b]: [f64; 2], flat: &[&Curve]) -> Result<bool> {
        let near = 2.0 * self.sections.tolerance.absolute;
        for edge in flat {
            let mut all = true;
            for x in [0.5, 0.2, 0.8] {
                all = all && edge.closest_point_within(curve.point_at(a + (b - a) * x), near)?.is_some();
            }
            if all {
                return Ok(true);
            }
        }
        Ok(false)
    }
}

/// The end of an edge nearest to a point within reach, else the point itself.
fn nearest_end(p: Point3, ends: &[(Point3, f64)], reach: f64) -> Point3 {
    let near = ends.iter().filter(|(q, off)| q.distance_to(p) <= reach + 4.0 * off);
    let best = near.min_by(|a, b| a.0.distance_to(p).total_cmp(&b.0.distance_to(p)));
    best.map_or(p, |(q, _)| *q)
}
