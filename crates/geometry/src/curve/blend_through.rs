//! Curves that lead from one curve end to another by way of a point.

use katydid_elementary::Elementary;

use super::Curve;
use super::blend::blend_between;
use crate::curve::thresholds::{FIRST_DAMPING, LEAST_DAMPING};
use crate::thresholds;
use crate::{Error, Point3, Result, Vector3};

/// Steps of the search; a dozen is usual.
const STEPS: usize = 80;
/// Bulges stay between exp(−REACH) and exp(REACH).
const REACH: f64 = 5.0;

impl Curve {
    /// The blend of [`Curve::blend_to`] whose bulges are chosen so that it comes as near to `point` as it can, and how
    /// near that is. Of the bulges that do equally well (there is a family of them in the plane) it finds those next
    /// to 1. In the plane a blend reaches points on the outer side of its chord; in space it mostly passes by.
    ///
    /// The nearest point of the blend is pulled to `point` by damped Gauss–Newton steps (K. Levenberg, 1944) in the
    /// logarithms of the bulges, which stay between e⁻⁵ and e⁵. The result is a local optimum.
    ///
    /// # Errors
    /// As [`Curve::blend_to`], or a point that is not finite.
    pub fn blend_through(&self, next: &Self, orders: [u8; 2], point: Point3) -> Result<(Self, f64)> {
        if !point.is_finite() {
            return Err(Error::NotFinite("point to blend through"));
        }
        let blend = |x: [f64; 2]| -> Result<Self> {
            Ok(blend_between(self, next, orders, x.map(f64::exponential))?.into())
        };
        let mut x = [0.0_f64; 2];
        let mut best = blend(x)?;
        let mut near = best.closest_point(point)?;
        let scale = self.end().distance_to(next.start());
        let mut damping = FIRST_DAMPING;
        for _ in 0..STEPS {
            if near.distance <= thresholds::ROUNDING * scale {
                break;
            }
            let miss = near.point - point;
            // Only what moves the curve sideways counts: along itself it may slide.
            let along = best.tangent_at(near.parameter).unwrap_or(Vector3::ZERO);
            let mut columns = [Vector3::ZERO; 2];
            for (k, column) in columns.iter_mut().enumerate() {
                const STEP: f64 = 1e-6;
                let mut there = x;
                there[k] += STEP;
                let moved = (blend(there)?.point_at(near.parameter) - near.point) / STEP;
                *column = moved - along * moved.dot(along);
            }
            let [a, b] = columns;
            let size = a.length_squared() + b.length_squared();
            if !(size > 0.0) {
                break;
            }
            let mut better = false;
            while damping < 1e6 {
                let (p, q, r) =
                    (a.length_squared() + damping * size, a.dot(b), b.length_squared() + damping * size);
                let (f, g) = (-a.dot(miss), -b.dot(miss));
                let determinant = p * r - q * q;
                let step = [(f * r - g * q) / determinant, (g * p - f * q) / determinant];
                let there: [f64; 2] =
                    std::array::from_fn(|k| (x[k] + step[k].clamp(-1.0, 1.0)).clamp(-REACH, REACH));
                let curve = blend(there)?;
                let found = curve.closest_point(point)?;
                if found.distance < near.distance {
                    better = near.distance - found.distance > thresholds::FEW_ROUNDINGS * scale;
                    (x, best, near) = (there, curve, found);
                    damping = (damping * 0.1).max(LEAST_DAMPING);
                    break;
                }
                damping *= 10.0;
            }
            if !better {
                break;
            }
        }
        Ok((best, near.distance))
    }
}

#[cfg(test)]
mod tests {
    use crate::{Curve, Line, Point3};

    fn line(a: [f64; 3], b: [f64; 3]) -> Curve {
        Line::new(a.into(), b.into()).into()
    }

    #[test]
    fn a_blend_through_a_point() {
        let (a, b) = (line([0.0, -1.0, 0.0], [0.0; 3]), line([4.0, 0.0, 0.0], [4.0, -1.0, 0.0]));
        // The middle of the cubic stands at ¾ of its legs, and those are 4/3 times the bulge.
        let top = Point3::new(2.0, 2.0, 0.0);
        let (curve, miss) = a.blend_through(&b, [1, 1], top).unwrap();
        assert!(miss < 1e-9, "{miss}");
        assert!(curve.point_at(0.5).distance_to(top) < 1e-6);
        assert!((curve.length() - a.blend_to(&b, [1, 1], [2.0, 2.0]).unwrap().length()).abs() < 1e-4);
        for order in [1, 2] {
            let (_, miss) = a.blend_through(&b, [order; 2], Point3::new(1.2, 1.7, 0.0)).unwrap();
            assert!(miss < 1e-9, "{order}: {miss}");
        }
        // Straight blends cannot bend, and out of the plane there is no way.
        let (_, miss) = a.blend_through(&b, [0, 0], top).unwrap();
        assert_eq!(miss, 2.0);
        let (_, miss) = a.blend_through(&b, [1, 1], Point3::new(2.0, 2.0, 1.0)).unwrap();
        assert!((miss - 1.0).abs() < 1e-6);
        assert!(a.blend_through(&b, [1, 1], Point3::new(f64::NAN, 0.0, 0.0)).is_err());
    }
}
