//! Strips of straight lines between a face and its edges.

use super::rule::{Work, integral};
use super::{Frame, Measure};
use crate::brep::thresholds::LEAST_RANGE;
use crate::quadrature::GAUSS_6;
use crate::{Curve, Interval, Point3, Quadrant, Result, Surface, Vector3};

/// A strip of straight lines.
pub(super) struct Strip {
    pub(super) near: Near,
    pub(super) far: Far,
}

/// The side of a strip on a face.
pub(super) enum Near {
    /// The image of a curve of the parameter plane.
    Image(Curve),
    /// A point alone.
    Point(Point3),
}

/// The side of a strip along an edge.
pub(super) enum Far {
    /// A curve in space, and which of its parameters belong to those of the near side: linear between pairs, and the
    /// same on both sides where there are none.
    Curve { curve: Curve, pairs: Vec<[f64; 2]> },
    /// A point alone.
    Point(Point3),
}

/// A point and the derivative there.
type Jet = [Vector3; 2];

impl Strip {
    /// The share of the strip in the volume and its moments, to a tolerance; positive where it goes on outward from a
    /// face whose normal points out. `stops` says where a curve of the parameter plane is not smooth on the surface.
    pub(super) fn integral(
        &self,
        surface: &Surface,
        frame: Frame,
        stops: &[f64],
        tolerance: f64,
        work: &mut Work<'_>,
    ) -> Result<[f64; 10]> {
        let breaks = self.breaks(stops);
        let (sum, error) = integral(&breaks, tolerance, &mut |t| {
            work.check()?;
            work.take(2 * GAUSS_6.len() as u64)?;
            let [a, by_a] = frame.local(self.near(surface, t));
            let [b, by_b] = frame.local(self.far(t));
            let across = b - a;
            let mut sum = [0.0; 10];
            // Of the fourth degree at most, and so exact.
            for [x, weight] in GAUSS_6 {
                for share in [0.5 - 0.5 * x, 0.5 + 0.5 * x] {
                    let found =
                        Measure::Volume.density(a + across * share, across, by_a + (by_b - by_a) * share);
                    sum.iter_mut().zip(found).for_each(|(sum, v)| *sum += 0.5 * weight * v);
                }
            }
            Ok(sum)
        })?;
        work.error += error;
        Ok(sum)
    }

    /// The near side in the parameter plane, if it is a curve.
    pub(super) fn flat(&self) -> Option<&Curve> {
        match &self.near {
            Near::Image(flat) => Some(flat),
            Near::Point(_) => None,
        }
    }

    /// Where either side is not smooth.
    fn breaks(&self, stops: &[f64]) -> Vec<f64> {
        let mut out = stops.to_vec();
        let domain = match (&self.near, &self.far) {
            (Near::Image(flat), _) => flat.domain(),
            (Near::Point(_), Far::Curve { curve, .. }) => curve.domain(),
            (Near::Point(_), Far::Point(_)) => Interval::new(0.0, 0.0),
        };
        out.extend([domain.start, domain.end]);
        if let Far::Curve { curve, pairs } = &self.far {
            out.extend(pairs.iter().map(|pair| pair[0]));
            let ends = pairs.first().zip(pairs.last()).filter(|_| pairs.len() == 2);
            for place in curve.pieces().iter().map(|piece| piece.whole.start) {
                match ends {
                    Some(([a, c], [b, d])) => out.push(a + (b - a) * (place - c) / (d - c)),
                    None if pairs.is_empty() => out.push(place),
                    None => {}
                }
            }
        }
        out.retain(|t| domain.start <= *t && *t <= domain.end);
        out.sort_by(f64::total_cmp);
        out.dedup_by(|a, b| (*a - *b).abs() <= LEAST_RANGE * domain.length());
        out
    }

    fn near(&self, surface: &Surface, t: f64) -> Jet {
        match &self.near {
            Near::Point(point) => [point.to_vector(), Vector3::ZERO],
            Near::Image(flat) => {
                let [uv, slope] = flat.jet_at::<2>(t, false);
                let d = surface.derivatives(uv.x, uv.y, 1, Quadrant::NorthEast);
                [d.point().to_vector(), d.get(1, 0) * slope.x + d.get(0, 1) * slope.y]
            }
        }
    }

    fn far(&self, t: f64) -> Jet {
        let (curve, pairs) = match &self.far {
            Far::Point(point) => return [point.to_vector(), Vector3::ZERO],
            Far::Curve { curve, pairs } => (curve, pairs),
        };
        let after = pairs.partition_point(|pair| pair[0] <= t).clamp(1, pairs.len().max(2) - 1);
        let Some(([a, c], [b, d])) = pairs.get(after - 1).zip(pairs.get(after)).map(|(x, y)| (*x, *y)) else {
            return curve.jet_at::<2>(t, false);
        };
        let pace = (d - c) / (b - a);
        let [place, slope] = curve.jet_at::<2>(c + (t - a) * pace, false);
        [place, slope * pace]
    }
}

impl Frame {
    fn local(self, [place, slope]: Jet) -> Jet {
        [(place - self.centre.to_vector()) / self.size, slope / self.size]
    }
}
