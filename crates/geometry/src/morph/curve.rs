//! Curves under a map.

use super::Morph;
use crate::curve::traced::{Sample, sampled, shape, whole};
use crate::intersect::curve_plane;
use crate::morph::thresholds::AT_SEAM;
use crate::thresholds;
use crate::{Continuity, Curve, Error, Interval, Point3, Result, Tolerance, Vector3};

/// The step for directions, as a part of a stretch of the curve: central differences over it err by its square,
/// rounding by 10⁻¹⁶ over it.
const STEP: f64 = 1e-5;
/// About the fewest parts in which a whole curve is looked at.
const LEAST: usize = 64;

impl Curve {
    /// The image of the curve, fitted within `tolerance.absolute` of samples that are taken until they suffice (tested
    /// in the middle between each two). The image of a stretch is a line or an arc where all its samples lie on one,
    /// else a cubic; the curve's kinks and the map's seams separate stretches. The domain is the curve's, the
    /// parameter runs about as the length of the image.
    ///
    /// # Errors
    /// As the map's; the map tears the curve apart; or the image is a point.
    pub fn morphed(&self, morph: &dyn Morph, tolerance: &Tolerance) -> Result<Self> {
        tolerance.positive_distance()?;
        let domain = self.domain();
        let mut cuts = vec![domain.start, domain.end];
        cuts.extend(self.discontinuities(Continuity::G1, tolerance));
        for seam in morph.seams() {
            let meets = curve_plane(self, &seam, AT_SEAM)?;
            cuts.extend(meets.crossings);
            cuts.extend(meets.overlaps.iter().flat_map(|o| [o.start, o.end]));
        }
        cuts.retain(|t| domain.contains(*t));
        cuts.sort_by(f64::total_cmp);
        let apart = thresholds::SAME_PARAMETER * domain.length();
        cuts.dedup_by(|b, a| *b - *a <= apart);
        // A cut next to the end is the end.
        if let Some(last) = cuts.last_mut() {
            *last = domain.end;
        }
        let spans: Vec<f64> = self.pieces().iter().map(|p| p.whole.start).collect();
        let mut rows: Vec<Vec<Sample>> = Vec::with_capacity(cuts.len());
        for w in cuts.windows(2) {
            let range = Interval::new(w[0], w[1]);
            let inner = spans.iter().filter(|&&t| range.start < t && t < range.end).count();
            // A curve of few stretches is looked at closely, that a map which acts on a part is not overlooked.
            let parts = (2 * (inner + 1)).max(LEAST / cuts.len());
            rows.push(self.stretch(range, parts, morph, tolerance)?);
        }
        // One shape where one will do, as for a straight curve that is cut in two by a seam.
        let all: Vec<Sample> = rows.iter().flatten().copied().collect();
        let one = if rows.len() > 1 { shape(&all).ok().filter(is_simple) } else { None };
        let image = match one {
            Some(one) => one,
            None => whole(rows.iter().map(|row| shape(row)).collect::<Result<_>>()?)?,
        };
        Ok(image.with_domain(domain).unwrap_or(image))
    }

    /// The samples of one stretch, which has no kink inside.
    fn stretch(
        &self,
        range: Interval,
        parts: usize,
        morph: &dyn Morph,
        tolerance: &Tolerance,
    ) -> Result<Vec<Sample>> {
        let h = STEP * range.length();
        let at = |t: f64| morph.image(self.point_at(t));
        let formula = |t: f64| {
            let point =
                if t >= range.end { morph.image(self.derivatives(range.end, 0, true).0)? } else { at(t)? };
            // At the ends differences look inwards: beyond, curve and map may go on otherwise.
            let (places, points, change): ([f64; 3], [Point3; 3], Vector3) = if t - h < range.start {
                let [b, c] = [at(t + h)?, at(t + 2.0 * h)?];
                ([t, t + h, t + 2.0 * h], [point, b, c], (b - point) * 4.0 - (c - point))
            } else if t + h > range.end {
                let [a, b] = [at(t - 2.0 * h)?, at(t - h)?];
                ([t - 2.0 * h, t - h, t], [a, b, point], (point - b) * 4.0 - (point - a))
            } else {
                let [a, c] = [at(t - h)?, at(t + h)?];
                ([t - h, t, t + h], [a, point, c], c - a)
            };
            if torn(places, points, tolerance.absolute, at)? {
                return Err(tear());
            }
            Ok(Some(Sample { point, direction: change.unitized() }))
        };
        let mut rows = sampled(range.start, range.end, parts, 0.5 * tolerance.absolute, formula)?;
        if rows.len() > 1 {
            return Err(tear());
        }
        rows.pop().ok_or(Error::degenerate("deformed curve", "it has no length"))
    }
}

fn tear() -> Error {
    Error::Invalid { what: "deformation of a curve", why: "the map tears the curve apart".into() }
}

/// Whether the map leaps between three close places: it goes much farther between two of them than between the others,
/// and still does so over a millionth of the way.
fn torn(
    places: [f64; 3],
    points: [Point3; 3],
    tolerance: f64,
    at: impl Fn(f64) -> Result<Point3>,
) -> Result<bool> {
    let steps = [points[0].distance_to(points[1]), points[1].distance_to(points[2])];
    let (wide, narrow) = (steps[0].max(steps[1]), steps[0].min(steps[1]));
    if !(wide > tolerance && narrow < 0.1 * wide) {
        return Ok(false);
    }
    let i = usize::from(steps[1] > steps[0]);
    let (mut low, mut high) = ((places[i], points[i]), (places[i + 1], points[i + 1]));
    for _ in 0..20 {
        let t = 0.5 * (low.0 + high.0);
        let middle = (t, at(t)?);
        if low.1.distance_to(middle.1) > middle.1.distance_to(high.1) { high = middle } else { low = middle }
    }
    Ok(low.1.distance_to(high.1) > 0.5 * wide)
}

fn is_simple(curve: &Curve) -> bool {
    matches!(curve, Curve::Line(_) | Curve::Arc(_))
}

/// A map given by a function, for tests.
#[cfg(test)]
pub(super) struct By<F>(pub(super) F);

#[cfg(test)]
impl<F: Fn(Point3) -> Point3> Morph for By<F> {
    fn image(&self, p: Point3) -> Result<Point3> {
        Ok(self.0(p))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Circle, Line, NurbsCurve, Plane, PolylineCurve};

    fn wave() -> Curve {
        let points = [[0.0, 0.0, 0.0], [1.0, 2.0, 0.0], [3.0, -1.0, 1.0], [4.0, 0.0, 0.0], [5.0, 1.0, 2.0]];
        NurbsCurve::clamped_uniform(3, &points.map(Point3::from)).unwrap().into()
    }

    /// The largest distance of images of points of the curve from the image of the curve.
    fn miss(curve: &Curve, image: &Curve, map: impl Fn(Point3) -> Point3) -> f64 {
        (0..=400)
            .map(|k| {
                let p = map(curve.point_at(curve.domain().at(f64::from(k) / 400.0)));
                image.closest_point(p).unwrap().distance
            })
            .fold(0.0, f64::max)
    }

    #[test]
    fn images_are_within_the_tolerance() {
        let map = |p: Point3| Point3::new(p.x + (0.7 * p.y).sin(), p.y + 0.1 * p.x * p.x, p.z + (p.x).cos());
        let circle: Curve = Circle::new(Plane::XY, 2.0).unwrap().into();
        let corner: Curve = PolylineCurve::new(
            [[0.0, 0.0, 0.0], [3.0, 0.0, 0.0], [3.0, 2.0, 1.0]].map(Point3::from).to_vec(),
        )
        .unwrap()
        .into();
        for curve in [wave(), circle, corner] {
            for absolute in [1e-2, 1e-4, 1e-6] {
                let tolerance = Tolerance { absolute, ..Tolerance::default() };
                let image = curve.morphed(&By(map), &tolerance).unwrap();
                assert!(miss(&curve, &image, map) <= absolute, "{curve:?}");
                assert_eq!(image.is_closed(), curve.is_closed());
                assert!((image.domain().start - curve.domain().start).abs() < 1e-12);
                assert!((image.domain().end - curve.domain().end).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn straight_images_are_lines() {
        let line: Curve = Line::new(Point3::ORIGIN, Point3::new(4.0, 2.0, 0.0)).into();
        let image = line.morphed(&By(|p: Point3| p + Vector3::Z * 3.0), &Tolerance::default()).unwrap();
        assert!(matches!(image, Curve::Line(_)));
        assert!(image.end().distance_to(Point3::new(4.0, 2.0, 3.0)) < 1e-15);
    }

    #[test]
    fn a_tear_is_told_and_so_is_a_point() {
        let line: Curve = Line::new(Point3::ORIGIN, Point3::new(4.0, 0.3, 0.0)).into();
        let torn =
            line.morphed(&By(|p: Point3| if p.x > 1.3 { p + Vector3::Y } else { p }), &Tolerance::default());
        assert!(torn.unwrap_err().to_string().contains("tears"));
        assert!(line.morphed(&By(|_| Point3::ORIGIN), &Tolerance::default()).is_err());
        let none = Tolerance { absolute: 0.0, ..Tolerance::default() };
        assert!(line.morphed(&By(|p| p), &none).is_err());
    }
}
