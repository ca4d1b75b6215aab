//! What multiplies the control points of a span, and their differences, at one parameter: a surface uses one such set
//! for every row, a grid of points for every row and column.

use super::evaluate::{basis_sized, find_span, jet_weights, local};
use super::knots::MAX_DEGREE;

/// The weights of one parameter for any degree, in arrays that hold the highest.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Weights {
    /// The first control point that acts.
    pub(crate) span: usize,
    /// The degree + 1 basis functions.
    pub(crate) points: [f64; MAX_DEGREE + 1],
    /// The weights on the differences of neighbouring control points that give the derivatives of order 1 and 2.
    pub(crate) differences: [[f64; MAX_DEGREE]; 2],
}

impl Weights {
    /// Those at `t`, in span `span`.
    pub(crate) fn new(degree: usize, knots: &[f64], span: usize, t: f64) -> Self {
        let mut out = Self { span, points: [0.0; MAX_DEGREE + 1], differences: [[0.0; MAX_DEGREE]; 2] };
        match degree {
            1 => out.fill(local(knots, span).map(|u| jet_weights::<1, 2, 2>(u, t))),
            2 => out.fill(local(knots, span).map(|u| jet_weights::<2, 3, 4>(u, t))),
            3 => out.fill(local(knots, span).map(|u| jet_weights::<3, 4, 6>(u, t))),
            _ => out.triangle(degree, knots.get(span..span + 2 * degree).unwrap_or(&[]), t),
        }
        out
    }

    fn fill<const P: usize, const Q: usize>(&mut self, weights: Option<([f64; Q], [[f64; P]; 2])>) {
        let Some((points, [first, second])) = weights else { return };
        for (slot, x) in self.points.iter_mut().zip(points) {
            *slot = x;
        }
        for (slot, x) in self.differences[0].iter_mut().zip(first) {
            *slot = x;
        }
        for (slot, x) in self.differences[1].iter_mut().zip(second) {
            *slot = x;
        }
    }

    /// Any degree of 2 or more: the basis functions level by level; those of degree p − 1 and p − 2 give the
    /// derivatives (P&T, *The NURBS Book*, eq. 2.9, with the outermost difference left to the control points).
    fn triangle(&mut self, degree: usize, u: &[f64], t: f64) {
        if degree < 2 || u.len() < 2 * degree {
            return;
        }
        let n = &mut self.points;
        n[0] = 1.0;
        let (mut first, mut second) = ([0.0; MAX_DEGREE], [0.0; MAX_DEGREE]);
        for level in 1..=degree {
            if level + 1 == degree {
                second[..level].copy_from_slice(&n[..level]);
            }
            if level == degree {
                first[..level].copy_from_slice(&n[..level]);
            }
            let mut saved = 0.0;
            for i in 0..level {
                let a = u[degree - level + i];
                let (x, term) = ((t - a) / (u[degree + i] - a), n[i]);
                n[i] = saved + (1.0 - x) * term;
                saved = x * term;
            }
            n[level] = saved;
        }
        let (p, [d1, d2]) = (degree as f64, &mut self.differences);
        // Weights on second differences become weights on first ones.
        let mut before = 0.0;
        for i in 0..degree {
            let m = if i + 1 < degree { second[i] * (p - 1.0) / (u[i + degree] - u[i + 1]) } else { 0.0 };
            let scale = p / (u[i + degree] - u[i]);
            d1[i] = first[i] * scale;
            d2[i] = (before - m) * scale;
            before = m;
        }
    }
}

/// The weights at many parameters, each in the span that holds it from above.
pub(crate) fn weights_at(degree: usize, knots: &[f64], parameters: &[f64]) -> Vec<Weights> {
    parameters.iter().map(|&t| Weights::new(degree, knots, find_span(knots, degree, t), t)).collect()
}

/// The basis functions at many parameters with their spans, of fixed degree P.
pub(crate) fn bases_at<const P: usize, const Q: usize, const U: usize>(
    knots: &[f64],
    parameters: &[f64],
) -> Vec<(usize, [f64; Q])> {
    let at = |&t: &f64| {
        let j = find_span(knots, P, t);
        (j, local(knots, j).map_or([f64::NAN; Q], |u: &[f64; U]| basis_sized::<P, Q, U>(u, t)))
    };
    parameters.iter().map(at).collect()
}

#[cfg(test)]
mod tests {
    use super::Weights;
    use crate::{NurbsCurve, Point3};

    #[test]
    fn weights_give_points_and_derivatives() -> crate::Result<()> {
        for degree in 1..=7 {
            let points: Vec<_> =
                (0..12).map(|i| Point3::new(f64::from(i), f64::from(i * i % 7), f64::from(i % 3))).collect();
            let curve = NurbsCurve::clamped_uniform(degree, &points)?;
            for i in 0..=50 {
                let t = curve.domain().at(f64::from(i) / 50.0);
                let j = crate::span_index(curve.knots(), degree, t, false);
                let w = Weights::new(degree, curve.knots(), j, t);
                let (point, d) = curve.derivatives(t, 2, false);
                let mut sums = [crate::Vector3::ZERO; 3];
                for k in 0..=degree {
                    sums[0] += points[j + k].to_vector() * w.points[k];
                    if k < degree {
                        let step = points[j + k + 1] - points[j + k];
                        sums[1] += step * w.differences[0][k];
                        sums[2] += step * w.differences[1][k];
                    }
                }
                assert!((sums[0] - point.to_vector()).length() < 1e-13);
                assert!((sums[1] - d[0]).length() < 1e-11, "{degree} {t}");
                assert!((sums[2] - d[1]).length() < 1e-9, "{degree} {t} {:?} {:?}", sums[2], d[1]);
            }
        }
        Ok(())
    }
}
