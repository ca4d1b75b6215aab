//! The Bézier form of single spans, in place and without allocation.

use super::NurbsCurve;
use super::curve::Controls;
use super::evaluate::mix;

/// Turns the control points that act in a span into those of its Bézier form.
///
/// `knots` are the 2·degree knots around the span, which lies between the two in the middle. The degree is
/// `points.len() − 1`. Each half of the work inserts one end of the span until it has full multiplicity; what is
/// left behind at every step is a blossom with one more argument at that end (L. Ramshaw, *Blossoming: a
/// connect-the-dots approach to splines*, DEC SRC report 19, 1987).
pub(crate) fn span_to_bezier<const N: usize>(knots: &[f64], points: &mut [[f64; N]]) {
    let Some(p) = points.len().checked_sub(1) else { return };
    if p == 0 || knots.len() != 2 * p {
        return;
    }
    let (a, b) = (knots[p - 1], knots[p]);
    if knots[0] < a {
        for level in 1..=p {
            for i in 0..=p - level {
                let (low, high) = (knots[i + level - 1], knots[i + p]);
                points[i] = mix(&points[i], &points[i + 1], (a - low) / (high - low));
            }
        }
    }
    if knots[2 * p - 1] > b {
        for level in 1..=p {
            for i in (level..=p).rev() {
                let x = (b - a) / (knots[i + p - level] - a);
                points[i] = mix(&points[i - 1], &points[i], x);
            }
        }
    }
}

impl NurbsCurve {
    /// Appends the homogeneous control points of the Bézier form of span `j` to a list.
    pub(crate) fn push_bezier(&self, j: usize, out: &mut Vec<[f64; 4]>) {
        let p = self.degree;
        let Some(knots) = self.knots.get(j..j + 2 * p) else { return };
        let start = out.len();
        match &self.controls {
            Controls::Plain(points) => {
                let local = points.get(j..=j + p).unwrap_or(&[]);
                out.extend(local.iter().map(|&[x, y, z]| [x, y, z, 1.0]));
            }
            Controls::Rational(points) => out.extend_from_slice(points.get(j..=j + p).unwrap_or(&[])),
        }
        if let Some(points) = out.get_mut(start..) {
            span_to_bezier(knots, points);
            if let Controls::Plain(_) = self.controls {
                points.iter_mut().for_each(|p| p[3] = 1.0);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::{NurbsCurve, Point3};

    #[test]
    fn the_same_as_by_trimming() {
        for degree in 1..6 {
            let points: Vec<Point3> = (0..degree + 6)
                .map(|i| Point3::new(i as f64, (i as f64 * 1.3).sin(), (i as f64 * 0.7).cos()))
                .collect();
            let mut knots: Vec<f64> = (0..points.len() + degree - 1).map(|i| (i as f64).powf(1.2)).collect();
            knots[degree + 2] = knots[degree + 1];
            if degree == 1 {
                knots[degree + 2] += 0.5;
            }
            let weights: Vec<f64> = (0..points.len()).map(|i| 1.0 + 0.3 * (i as f64).cos()).collect();
            let plain = NurbsCurve::new(degree, points.clone(), knots.clone()).unwrap();
            let rational = NurbsCurve::with_weights(degree, &points, &weights, knots).unwrap();
            for curve in [plain, rational] {
                for j in curve.spans() {
                    let mut found = Vec::new();
                    curve.push_bezier(j, &mut found);
                    for (a, b) in found.iter().flatten().zip(curve.bezier_points(j).iter().flatten()) {
                        assert!((a - b).abs() < 1e-12, "{a} {b}");
                    }
                }
            }
        }
    }
}
