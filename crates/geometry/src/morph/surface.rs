//! Surfaces under a map.

use super::Morph;
use crate::{Direction, NurbsSurface, Point3, Result, Surface, Tolerance};

/// No image has more control points than this.
const MOST: usize = 40_000;

/// The surface with its control points mapped.
pub(super) fn by_controls(surface: &NurbsSurface, morph: &dyn Morph) -> Result<NurbsSurface> {
    let points = surface.control_points().into_iter().map(|p| morph.image(p)).collect::<Result<Vec<_>>>()?;
    let knots = Direction::BOTH.map(|d| surface.knots(d).to_vec());
    if surface.is_rational() {
        NurbsSurface::with_weights(surface.degrees(), surface.counts(), &points, &surface.weights(), knots)
    } else {
        NurbsSurface::new(surface.degrees(), surface.counts(), points, knots)
    }
}

impl Surface {
    /// The image of the surface: its NURBS form with the control points mapped, after its spans have been halved so
    /// often that it is within `tolerance.absolute` of the exact image in the corners and
    /// middles of every patch and its edges. The domains stay.
    ///
    /// Moved control points miss by the square of the span's size times the curvature of the map: each halving
    /// quarters it. With 40,000 control points it ends, near enough or not.
    ///
    /// # Errors
    /// As the map's, and when the surface has no NURBS form.
    pub fn morphed(&self, morph: &dyn Morph, tolerance: &Tolerance) -> Result<Self> {
        tolerance.positive_distance()?;
        let mut source = self.to_nurbs()?;
        let plain = by_controls(&source, morph)?;
        let size = source.hull_box().min.distance_to(source.hull_box().max);
        if is_near(&source, &plain, morph, 1e-12 * size)? {
            // The map is affine where the surface is.
            return Ok(plain.into());
        }
        for direction in Direction::BOTH {
            source = source.clamped(direction)?;
            // Straight spans cannot bend.
            let degree = source.degree(direction);
            if degree < 3 {
                source = source.raised_to(direction, 3)?;
            }
        }
        loop {
            let image = by_controls(&source, morph)?;
            if is_near(&source, &image, morph, tolerance.absolute)? {
                return Ok(image.into());
            }
            let mut next = source.clone();
            for direction in Direction::BOTH {
                let spans = source.span_parameters(direction);
                let middles: Vec<f64> = spans.windows(2).map(|w| 0.5 * (w[0] + w[1])).collect();
                next = next.refined(direction, &middles)?;
            }
            if next.point_count() > MOST {
                return Ok(image.into());
            }
            source = next;
        }
    }
}

/// Whether the image follows the map at the quarters of all patches, of few patches in more places.
fn is_near(source: &NurbsSurface, image: &NurbsSurface, morph: &dyn Morph, tolerance: f64) -> Result<bool> {
    let spans = Direction::BOTH.map(|d| source.span_parameters(d));
    let parts = if spans[0].len() * spans[1].len() <= 100 { 8 } else { 2 };
    let [us, vs] = spans.map(|spans| {
        let part = |w: &[f64], k: u32| w[0] + (w[1] - w[0]) * (f64::from(k) / f64::from(parts));
        let mut out: Vec<f64> = spans.windows(2).flat_map(|w| (0..parts).map(move |k| part(w, k))).collect();
        out.extend(spans.last());
        out
    });
    for &u in &us {
        for &v in &vs {
            let wanted: Point3 = morph.image(source.point_at(u, v))?;
            if !(wanted.distance_to(image.point_at(u, v)) <= tolerance) {
                return Ok(false);
            }
        }
    }
    Ok(true)
}

#[cfg(test)]
mod tests {
    use super::super::curve::By;
    use super::*;
    use crate::{Interval, Plane, PlaneSurface, Sphere, Vector3};

    #[test]
    fn surfaces_follow_the_map() {
        let map = |p: Point3| Point3::new(p.x, p.y + 0.05 * p.x * p.x, p.z + 0.3 * (0.5 * p.x).sin());
        let ball: Surface = Sphere::around(Point3::new(1.0, 0.0, 0.0), 1.0).unwrap().into();
        let sheet: Surface =
            PlaneSurface::new(Plane::XY, Interval::new(0.0, 6.0), Interval::new(0.0, 3.0)).unwrap().into();
        let tolerance = Tolerance::default();
        for surface in [ball, sheet] {
            let image = surface.morphed(&By(map), &tolerance).unwrap();
            let nurbs = surface.to_nurbs().unwrap();
            let [du, dv] = Direction::BOTH.map(|d| nurbs.domain(d));
            for i in 0..=17 {
                for j in 0..=13 {
                    let (u, v) = (du.at(f64::from(i) / 17.0), dv.at(f64::from(j) / 13.0));
                    let miss = map(nurbs.point_at(u, v)).distance_to(image.point_at(u, v));
                    assert!(miss <= 1.5 * tolerance.absolute, "{miss}");
                }
            }
        }
    }

    #[test]
    fn an_affine_map_keeps_degree_and_count() {
        let sheet: Surface = PlaneSurface::new(Plane::XY, Interval::UNIT, Interval::UNIT).unwrap().into();
        let image = sheet.morphed(&By(|p: Point3| p + Vector3::Z * p.x), &Tolerance::default()).unwrap();
        let Surface::Nurbs(image) = image else { panic!("a NURBS surface") };
        assert_eq!((image.degrees(), image.counts()), ([1, 1], [2, 2]));
    }
}
