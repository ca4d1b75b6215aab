//! Another parameter by a linear-fractional map, which leaves the shape, and with it the weights of the ends.

use katydid_elementary::Elementary;

use super::NurbsCurve;
use crate::{Error, Result};

impl NurbsCurve {
    /// The same shape and domain with the parameter changed by s′ = c·s / ((c − 1)·s + 1) on the normalised domain
    /// 0…1: a `factor` above 1 pushes points towards the end of the domain. Rational from then on.
    ///
    /// E. T. Y. Lee & M. L. Lucian, *Möbius reparametrization of rational B-splines*, CAGD 8 (1991); weights scaled as
    /// openNURBS has them (`ON_ReparameterizeRationalNurbsCurve`).
    ///
    /// # Errors
    /// The factor is not a finite number greater than 0, an unclamped knot vector reaches the pole of the map, or
    /// numbers overflow.
    pub fn reparametrized(&self, factor: f64) -> Result<Self> {
        let scaled = self.moebius(factor)?;
        // Up to a common factor that openNURBS leaves in: the end weight stays, the first grows by c^degree.
        let common = factor.powi(self.degree as i32);
        let points = scaled.homogeneous_points().iter().map(|p| p.map(|x| x * common)).collect();
        Self::rational(self.degree, points, scaled.knots)
    }

    /// The same shape and domain with given weights at the two ends. Where both change by one factor the parameter
    /// stays; otherwise it is changed by [`NurbsCurve::reparametrized`]'s map. The curve is clamped first.
    ///
    /// # Errors
    /// A weight is not a finite number greater than 0, or numbers overflow.
    pub fn with_end_weights(&self, start: f64, end: f64) -> Result<Self> {
        for (what, value) in [("weight at the start", start), ("weight at the end", end)] {
            if !(value > 0.0 && value.is_finite()) {
                return Err(Error::OutOfRange { what, value, must: "finite and greater than 0" });
            }
        }
        let curve = if self.is_clamped() { self.to_rational() } else { self.clamped()?.to_rational() };
        let weights = curve.weights();
        let (Some(&first), Some(&last)) = (weights.first(), weights.last()) else {
            return Err(Error::degenerate("NURBS curve", "it has no control points"));
        };
        let factor = start / first;
        let c = (last * factor / end).raised_to(1.0 / self.degree as f64);
        let moved = if (c - 1.0).abs() <= 4.0 * f64::EPSILON { curve } else { curve.moebius(c)? };
        let mut points: Vec<[f64; 4]> =
            moved.homogeneous_points().iter().map(|p| p.map(|x| x * factor)).collect();
        // The weights asked for, to the last bit; the points stay where they are.
        let ends = points.len() - 1;
        for (i, weight) in [(0, start), (ends, end)] {
            if let Some(p) = points.get_mut(i) {
                let adjust = weight / p[3];
                *p = [p[0] * adjust, p[1] * adjust, p[2] * adjust, weight];
            }
        }
        Self::rational(self.degree, points, moved.knots)
    }

    /// The map on knots and homogeneous control points; the first control point of a clamped curve stays.
    fn moebius(&self, c: f64) -> Result<Self> {
        if !(c > 0.0 && c.is_finite()) {
            return Err(Error::OutOfRange {
                what: "reparametrization factor",
                value: c,
                must: "finite and greater than 0",
            });
        }
        let domain = self.domain();
        let s: Vec<f64> = self.knots.iter().map(|&k| domain.normalized(k)).collect();
        let weight = |s: f64| (c - 1.0) * s + 1.0;
        if !s.iter().all(|&s| weight(s) > 0.0) {
            return Err(Error::degenerate(
                "knot vector",
                "a knot outside the domain lies beyond the map's pole",
            ));
        }
        let knots = s.iter().zip(&self.knots).map(|(&s, &k)| {
            if k == domain.start || k == domain.end { k } else { domain.at(c * s / weight(s)) }
        });
        let points = self.homogeneous_points();
        let points = points.iter().zip(s.windows(self.degree)).map(|(p, w)| {
            let product: f64 = w.iter().map(|&s| weight(s)).product();
            p.map(|x| x / product)
        });
        Self::rational(self.degree, points.collect(), knots.collect())
    }
}

#[cfg(test)]
mod tests {
    use crate::{NurbsCurve, Point3};

    #[test]
    fn the_shape_stays() {
        let points = [(0.0, 0.0), (1.0, 2.0), (3.0, 2.0), (4.0, -1.0), (6.0, 0.0)];
        let points = points.iter().map(|&(x, y)| Point3::new(x, y, 0.5)).collect();
        let curve = NurbsCurve::new(3, points, vec![0.0, 0.0, 0.0, 0.7, 2.0, 2.0, 2.0]).unwrap();
        for c in [0.2, 1.0, 5.0] {
            let moved = curve.reparametrized(c).unwrap();
            for s in [0.0, 0.1, 0.35, 0.8, 1.0] {
                let t = 2.0 * c * s / ((c - 1.0) * s + 1.0);
                assert!(moved.point_at(t).distance_to(curve.point_at(2.0 * s)) < 1e-14);
            }
        }
        let weighted = curve.with_end_weights(0.5, 3.0).unwrap();
        assert_eq!((weighted.weight(0), weighted.weight(4)), (Some(0.5), Some(3.0)));
        for s in [0.0, 0.2, 0.5, 0.9, 1.0] {
            let found = crate::Curve::from(weighted.clone()).closest_point(curve.point_at(2.0 * s)).unwrap();
            assert!(found.distance < 1e-14);
        }
        assert!(curve.reparametrized(0.0).is_err() && curve.with_end_weights(1.0, f64::NAN).is_err());
    }
}
