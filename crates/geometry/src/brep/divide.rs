//! Breps cut along curves on them, and by planes.

use super::Brep;
use crate::brep::thresholds::ROUGH_LENGTH;
use crate::thresholds;
use crate::{ClosestOnSurface, Curve, Direction, Error, Interval, Plane, Point3, Result, Tolerance};

/// Places of a smooth stretch of a curve at which it is asked whether it lies on a surface.
const PLACES: usize = 48;
/// Halvings between two of them.
const HALVINGS: u32 = 40;

impl Brep {
    /// The parts into which curves cut a brep, as far as the curves lie on its faces within the tolerance. What still
    /// hangs together round the end of a cut stays together, and what no curve parts comes back alone.
    ///
    /// A curve is asked at many places of each smooth stretch whether it lies on a face; a part between two of them may
    /// be missed.
    ///
    /// # Errors
    /// As [`Brep::face_split`]; `go_on` said no.
    pub fn split_along(
        &self,
        curves: &[Curve],
        tolerance: &Tolerance,
        go_on: impl FnMut() -> bool,
    ) -> Result<Vec<Self>> {
        let limit = tolerance.positive_distance()?;
        let (pieces, cuts) = self.pieces_along(curves, tolerance, go_on)?;
        if cuts.is_empty() {
            return Ok(vec![self.clone()]);
        }
        let mut out = Vec::new();
        for joined in Self::join(&pieces, tolerance)?.breps {
            let mut opened = Vec::new();
            for edge in joined.interior_edges() {
                if let Some(curve) = joined.edge_as_curve(edge)?
                    && lies_along(&curve, &cuts, 4.0 * limit)?
                {
                    opened.push(edge);
                }
            }
            out.extend(joined.unjoined(&opened)?);
        }
        Ok(out)
    }

    /// The parts of a brep on either side of a plane, first those that its normal points away from; open where it was
    /// cut. A face in the plane goes with what lies behind it.
    ///
    /// # Errors
    /// The section cannot be found on every face; or as [`Brep::face_split`]; `go_on` said no.
    pub fn split_by_plane(
        &self,
        plane: &Plane,
        tolerance: &Tolerance,
        go_on: impl FnMut() -> bool,
    ) -> Result<[Vec<Self>; 2]> {
        let section = self.section(plane, tolerance)?;
        if !section.complete {
            return Err(Error::degenerate("section", "the search did not come to its end on every face"));
        }
        let (pieces, _) = self.pieces_along(&section.curves, tolerance, go_on)?;
        let mut sides = [Vec::new(), Vec::new()];
        for piece in pieces {
            let place = usize::from(piece.lies_above(plane, tolerance)?);
            sides[place].push(piece);
        }
        let [below, above] = sides;
        let joined = |pieces: Vec<Self>| {
            if pieces.is_empty() { Ok(Vec::new()) } else { Ok(Self::join(&pieces, tolerance)?.breps) }
        };
        Ok([joined(below)?, joined(above)?])
    }

    /// The faces cut along curves, and the stretches of the curves that lie on them.
    fn pieces_along(
        &self,
        curves: &[Curve],
        tolerance: &Tolerance,
        mut go_on: impl FnMut() -> bool,
    ) -> Result<(Vec<Self>, Vec<Curve>)> {
        let limit = tolerance.positive_distance()?;
        let (mut pieces, mut cuts) = (Vec::new(), Vec::new());
        for (face, _) in self.faces().iter().enumerate().filter(|(_, own)| !own.deleted) {
            if !go_on() {
                return Err(Error::Stopped);
            }
            let surface =
                self.face_surface(face).ok_or(Error::degenerate("brep", "a face has no surface"))?;
            let search = ClosestOnSurface::new(surface)?;
            let mut on = Vec::new();
            for curve in curves {
                on.extend(stretches_on(&search, curve, limit)?);
            }
            if on.is_empty() {
                pieces.push(self.sub_brep(&[face])?);
                continue;
            }
            let parts = self.face_split(face, &on, tolerance)?;
            let whole = parts.len() < 2;
            // What touches only the border of the face leaves it as it is.
            pieces.extend(if whole { vec![self.sub_brep(&[face])?] } else { parts });
            cuts.extend(on);
        }
        Ok((pieces, cuts))
    }

    /// Whether a face lies on the side that the normal of a plane points to, by its farthest point of some.
    fn lies_above(&self, plane: &Plane, tolerance: &Tolerance) -> Result<bool> {
        let surface = self.face_surface(0).ok_or(Error::degenerate("brep", "a face has no surface"))?;
        let height = |p: Point3| (p - plane.origin).dot(plane.z_axis);
        let mut farthest = 0.0_f64;
        let mut note = |p: Point3| {
            let h = height(p);
            if h.abs() > farthest.abs() {
                farthest = h;
            }
        };
        for edge in 0..self.edges().len() {
            let Some(curve) = self.edge_as_curve(edge)? else { continue };
            let domain = curve.domain();
            (0..=16).for_each(|k| note(curve.point_at(domain.at(f64::from(k) / 16.0))));
        }
        // A dome has its whole border in the plane.
        let region = self.face_region(0, tolerance)?;
        let bounds = region.curves().iter().map(Curve::bounding_box).reduce(|a, b| a.union(&b));
        let mut inside = None;
        if let Some(bounds) = bounds {
            let flat = thresholds::SAME_POINT * bounds.diagonal().length();
            for i in 1..16 {
                for j in 1..16 {
                    let (x, y) = (f64::from(i) / 16.0, f64::from(j) / 16.0);
                    let u = bounds.min.x + x * (bounds.max.x - bounds.min.x);
                    let v = bounds.min.y + y * (bounds.max.y - bounds.min.y);
                    if region.contains(Point3::new(u, v, 0.0), flat.max(f64::MIN_POSITIVE))?
                        == crate::Containment::Inside
                    {
                        note(surface.point_at(u, v));
                        inside = Some([u, v]);
                    }
                }
            }
        }
        if farthest.abs() > tolerance.absolute {
            return Ok(farthest > 0.0);
        }
        // In the plane itself: behind it lies what its normal points away from.
        let [u, v] = inside.unwrap_or(Direction::BOTH.map(|d| surface.domain(d).middle()));
        let normal = surface.normal_at(u, v).unwrap_or(plane.z_axis);
        Ok((normal.dot(plane.z_axis) < 0.0) != self.is_reversed(0))
    }
}

/// The stretches of a curve that lie within a distance of a surface.
fn stretches_on(search: &ClosestOnSurface, curve: &Curve, limit: f64) -> Result<Vec<Curve>> {
    let is_on = |t: f64| -> Result<bool> { Ok(search.nearest(curve.point_at(t))?.distance <= limit) };
    let mut all: Vec<Interval> = Vec::new();
    for stretch in curve.smooth_stretches() {
        let mut found: Vec<Interval> = Vec::new();
        let mut from = None;
        let mut before: Option<(f64, bool)> = None;
        for k in 0..=PLACES {
            let t = stretch.at((k as f64 / PLACES as f64)
                .clamp(thresholds::SAME_PARAMETER, 1.0 - thresholds::SAME_PARAMETER));
            let now = is_on(t)?;
            match before {
                None if now => from = Some(stretch.start),
                Some((last, was)) if was != now => {
                    let (mut low, mut high) = (last, t);
                    for _ in 0..HALVINGS {
                        let middle = 0.5 * (low + high);
                        if is_on(middle)? == was { low = middle } else { high = middle }
                    }
                    match from.take() {
                        Some(start) => found.push(Interval::new(start, low)),
                        None => from = Some(high),
                    }
                }
                _ => {}
            }
            before = Some((t, now));
        }
        found.extend(from.map(|start| Interval::new(start, stretch.end)));
        // Behind a corner a curve that leaves the surface is near it for a little while.
        let is_long = |range: &Interval| {
            let reach = curve.point_at(range.start).distance_to(curve.point_at(range.end));
            *range == stretch || reach > 2.0 * limit
        };
        all.extend(found.into_iter().filter(is_long));
    }
    // Neighbouring stretches are one.
    let mut joined: Vec<Interval> = Vec::new();
    for range in all {
        match joined.last_mut() {
            Some(last) if last.end == range.start => last.end = range.end,
            _ => joined.push(range),
        }
    }
    let whole = curve.domain();
    let mut out = Vec::new();
    for range in joined {
        let part = if range == whole { curve.clone() } else { curve.trimmed(range)? };
        if part.length_within(ROUGH_LENGTH) > 2.0 * limit {
            out.push(part);
        }
    }
    Ok(out)
}

/// Whether a curve runs along one of some others.
fn lies_along(curve: &Curve, others: &[Curve], limit: f64) -> Result<bool> {
    let domain = curve.domain();
    'others: for other in others {
        for share in [0.13, 0.31, 0.5, 0.77, 0.94] {
            if other.closest_point_within(curve.point_at(domain.at(share)), limit)?.is_none() {
                continue 'others;
            }
        }
        return Ok(true);
    }
    Ok(false)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::brep::testing::{area, cube};
    use crate::{Circle, PolylineCurve, Sphere, Vector3, construct};
    use std::f64::consts::PI;

    fn areas(breps: &[Brep]) -> Vec<f64> {
        let mut areas: Vec<f64> = breps.iter().map(area).collect();
        areas.sort_by(f64::total_cmp);
        areas
    }

    fn near(found: &[f64], wanted: &[f64], within: f64) {
        assert_eq!(found.len(), wanted.len(), "{found:?}");
        assert!(found.iter().zip(wanted).all(|(a, b)| (a - b).abs() < within), "{found:?} {wanted:?}");
    }

    fn tolerance() -> Tolerance {
        Tolerance { absolute: 1e-4, ..Tolerance::default() }
    }

    #[test]
    fn boxes_and_balls_are_cut_by_planes() {
        let plane = Plane::XY.with_origin(Point3::new(0.0, 0.0, 1.0));
        let [below, above] = cube().split_by_plane(&plane, &tolerance(), || true).unwrap();
        // Floor and walls; lid and walls: open both.
        near(&areas(&below), &[2.0 + 6.0], 1e-6);
        near(&areas(&above), &[2.0 + 12.0], 1e-6);
        assert!(!below[0].is_solid());
        // A plane that touches a face, and one beside.
        let top = Plane::XY.with_origin(Point3::new(0.0, 0.0, 3.0));
        let [below, above] = cube().split_by_plane(&top, &tolerance(), || true).unwrap();
        near(&areas(&below), &[22.0], 1e-6);
        assert!(above.is_empty() && below[0].is_solid());
        let ball = construct::sphere(&Sphere::around(Point3::ORIGIN, 2.0).unwrap()).unwrap();
        for normal in [Vector3::Z, Vector3::X, Vector3::new(1.0, 2.0, -0.5)] {
            let up = normal.unitized().unwrap();
            let plane = Plane::from_normal(Point3::ORIGIN + up * 0.5, up).unwrap();
            let [below, above] = ball.split_by_plane(&plane, &tolerance(), || true).unwrap();
            // Archimedes: the area of a zone is that of the cylinder about it.
            near(&areas(&below), &[4.0 * PI * 2.5], 1e-2);
            near(&areas(&above), &[4.0 * PI * 1.5], 1e-2);
        }
        assert!(cube().split_by_plane(&plane, &tolerance(), || false).is_err());
    }

    #[test]
    fn boxes_are_cut_along_curves() {
        // Round three corners of the box: a corner comes off.
        let round = |points: &[[f64; 3]]| -> Curve {
            PolylineCurve::new(points.iter().map(|p| Point3::from(*p)).collect()).unwrap().into()
        };
        let corner = round(&[[0.5, 0.0, 0.0], [0.0, 0.5, 0.0], [0.0, 0.0, 0.5], [0.5, 0.0, 0.0]]);
        let parts = cube().split_along(&[corner], &tolerance(), || true).unwrap();
        near(&areas(&parts), &[0.375, 22.0 - 0.375], 1e-6);
        // A disc in a side.
        let disc = Circle::new(Plane::XY.with_origin(Point3::new(0.5, 1.0, 3.0)), 0.25).unwrap();
        let parts = cube().split_along(&[disc.into()], &tolerance(), || true).unwrap();
        near(&areas(&parts), &[PI / 16.0, 22.0 - PI / 16.0], 1e-6);
        // A cut that does not go round parts nothing; nor does a curve elsewhere.
        let slit = round(&[[0.5, 0.0, 3.0], [0.5, 2.0, 3.0]]);
        assert_eq!(cube().split_along(&[slit], &tolerance(), || true).unwrap().len(), 1);
        let away = round(&[[5.0, 0.0, 3.0], [5.0, 2.0, 3.0]]);
        assert_eq!(cube().split_along(&[away], &tolerance(), || true).unwrap(), [cube()]);
    }
}
