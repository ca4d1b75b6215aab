//! Points along a curve at equal lengths or distances.

use katydid_elementary::Elementary;

use super::piece::Shape;
use super::{ArcLength, Curve};
use crate::bernstein::{first_rise, squared_distance, value};
use crate::thresholds;
use crate::{Error, Point3, Result};

/// More points than this are refused before memory is asked for.
const MOST: f64 = 1e7;

impl Curve {
    /// The parameters that cut the curve into `count` parts of equal length: count + 1 of them with both ends on an
    /// open curve, count on a closed one, the seam first.
    ///
    /// # Errors
    /// A count of 0 or above 10⁷, or a curve without length.
    pub fn divide_by_count(&self, count: usize) -> Result<Vec<f64>> {
        if count == 0 || count as f64 > MOST {
            return Err(Error::OutOfRange {
                what: "number of segments",
                value: count as f64,
                must: "from 1 to 10000000",
            });
        }
        let measure = ArcLength::new(self);
        let total = measure.total();
        if !(total > 0.0) {
            return Err(Error::degenerate("curve", "it has no length to divide"));
        }
        let domain = self.domain();
        let mut out = Vec::with_capacity(count + 1);
        out.push(domain.start);
        out.extend((1..count).map(|i| measure.parameter_at(total * i as f64 / count as f64)));
        if !self.is_closed() {
            out.push(domain.end);
        }
        Ok(out)
    }

    /// The parameters at steps of `length` along the curve from its start, which is the first. A last, shorter piece
    /// gets no end; a closed curve has its seam once.
    ///
    /// # Errors
    /// The length is not finite and greater than 0, or gives more than 10⁷ points.
    pub fn divide_by_length(&self, length: f64) -> Result<Vec<f64>> {
        check_step("length", length)?;
        let measure = ArcLength::new(self);
        let total = measure.total();
        if total / length > MOST {
            return Err(Error::OutOfRange {
                what: "length",
                value: length,
                must: "long enough to give at most 10000000 points",
            });
        }
        // A step that ends within rounding of the end reaches it.
        let count = (total / length * (1.0 + thresholds::ROUNDING)).floor() as usize;
        let closed = self.is_closed();
        let steps = (0..=count).map(|i| length * i as f64);
        Ok(steps
            .filter(|&s| !(closed && s > 0.0 && s >= total * (1.0 - thresholds::ROUNDING)))
            .map(|s| measure.parameter_at(s))
            .collect())
    }

    /// The parameters of points `distance` apart in a straight line, from the start on: each is the first along the
    /// curve at that distance from the one before. What is left at the end gets no point.
    ///
    /// # Errors
    /// The distance is not finite and greater than 0, or goes into the curve's length more than a million times.
    pub fn divide_by_distance(&self, distance: f64) -> Result<Vec<f64>> {
        check_step("distance", distance)?;
        let refused = Err(Error::OutOfRange {
            what: "distance",
            value: distance,
            must: "long enough to give at most 1000000 points",
        });
        // No chord is longer than its part of the curve, so this bounds the number of points.
        if self.length() / distance > 1e6 {
            return refused;
        }
        let beziers = self.located_beziers();
        let domain = self.domain();
        let mut out = vec![domain.start];
        let (mut piece, mut after, mut from) = (0, 0.0, self.start());
        'points: loop {
            while let Some(part) = beziers.get(piece) {
                let c = squared_distance(&part.points, from);
                let squared = distance * distance;
                // A hair less, so that a curve that ends at the distance reaches it.
                let bar = squared * (1.0 - thresholds::FEW_ROUNDINGS);
                let excess: Vec<f64> = c.iter().map(|c| c[0] - bar * c[1]).collect();
                // A gap between pieces may leap over the distance: then the next piece starts beyond it.
                let found = if after == 0.0 && excess.first().is_some_and(|&x| x >= 0.0) {
                    Some(0.0)
                } else {
                    first_rise(&excess, after)
                };
                if let Some(x) = found {
                    let (point, t) = part.at(x);
                    if t >= domain.end
                        && self.is_closed()
                        && point.distance_to(self.start()) <= thresholds::SAME_POINT * distance
                    {
                        break 'points;
                    }
                    if out.len() > 1_000_000 {
                        return refused;
                    }
                    out.push(t);
                    (from, after) = (point, x);
                    continue 'points;
                }
                piece += 1;
                after = 0.0;
            }
            break;
        }
        Ok(out)
    }

    /// The curve as Bézier curves that know their place on it.
    pub(super) fn located_beziers(&self) -> Vec<LocatedBezier<'_>> {
        let mut out = Vec::new();
        for piece in self.pieces() {
            let beziers = piece.beziers();
            let count = beziers.len();
            for (k, points) in beziers.into_iter().enumerate() {
                out.push(LocatedBezier { points, piece, part: k, parts: count });
            }
        }
        out
    }
}

/// A Bézier curve and where it lies on the whole.
pub(super) struct LocatedBezier<'a> {
    /// The homogeneous control points.
    pub(super) points: Vec<[f64; 4]>,
    piece: super::piece::Piece<'a>,
    part: usize,
    parts: usize,
}

impl LocatedBezier<'_> {
    /// Whether it is part of an arc.
    pub(super) fn is_circular(&self) -> bool {
        matches!(self.piece.shape, Shape::Arc(_))
    }

    /// The point at x in 0…1 and the curve's parameter there.
    pub(super) fn at(&self, x: f64) -> (Point3, f64) {
        let point = crate::nurbs::project(value(&self.points, x));
        let own = match self.piece.shape {
            // Inside an arc the rational parameter is not the angle: read the angle off the point.
            Shape::Arc(arc) if x > 0.0 && x < 1.0 => {
                let (low, high) = (arc.angle.at(self.part as f64 / self.parts as f64), arc.angle.end);
                let [u, v, _] = arc.circle.plane.coordinates(point);
                let turn = std::f64::consts::TAU;
                let angle = v.arctangent_of(u);
                (angle + ((low - angle) / turn).ceil() * turn).min(high)
            }
            _ => self.piece.own.at((self.part as f64 + x) / self.parts as f64),
        };
        (point, self.piece.whole_parameter(own))
    }
}

fn check_step(what: &'static str, value: f64) -> Result<()> {
    if value > 0.0 && value.is_finite() {
        Ok(())
    } else {
        Err(Error::OutOfRange { what, value, must: "finite and greater than 0" })
    }
}
