//! The speed |C′| along single spans, in a form that is cheap to evaluate and to integrate.

use katydid_elementary::Elementary;

use crate::NurbsCurve;
use crate::bernstein::binomial;
use crate::curve::thresholds::SAFE_SIZE;
use crate::quadrature::gauss_kronrod_31;

/// Halving a piece more often than this gains nothing: the parts are as short as rounding allows.
const DEEPEST: u32 = 50;
/// Parts a piece may be cut into. A cusp needs some 25 parts, and no polynomial has more cusps than its degree; the
/// bound stops input that is bad everywhere.
const MOST_PARTS: u32 = 2_000;

/// Polynomial vectors in the scaled Bernstein form: the value at x is the sum of cₖ xᵏ (1 − x)ⁿ⁻ᵏ.
#[inline(always)]
fn horner<const N: usize>(c: &[[f64; N]], x: f64) -> [f64; N] {
    let y = 1.0 - x;
    let Some((&first, rest)) = c.split_first() else { return [0.0; N] };
    let (mut sum, mut power) = (first, 1.0);
    for c in rest {
        power *= x;
        sum = std::array::from_fn(|k| sum[k] * y + power * c[k]);
    }
    sum
}

/// The hodographs of spans.
#[derive(Debug, Clone, Default)]
pub(crate) struct Hodographs {
    numerators: Vec<[f64; 3]>,
    weights: Vec<[f64; 1]>,
    scratch: Vec<[f64; 4]>,
}

/// Where the hodograph of a span lies in [`Hodographs`].
#[derive(Debug, Clone, Copy)]
pub(crate) struct Place {
    numerator: (u32, u32),
    weight: (u32, u32),
    scale: f64,
}

/// The hodograph of one span, by x in 0…1 over the span: the numerator over the square of the weight.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Speed<'s> {
    numerator: &'s [[f64; 3]],
    weight: &'s [[f64; 1]],
    /// Keeps squares from overflow.
    scale: f64,
}

impl Hodographs {
    pub(crate) fn clear(&mut self) {
        self.numerators.clear();
        self.weights.clear();
    }

    /// Adds the hodograph of a span. For rational ones the numerator A′w − Aw′ in Bernstein form, of degree 2p − 2
    /// from differences of control points only, so that places far from the origin lose no digits (derived from the
    /// product rule; compare T. Sederberg & X. Wang, *Rational hodographs*, CAGD 4, 1987).
    pub(crate) fn push(&mut self, curve: &NurbsCurve, j: usize) -> Place {
        let p = curve.degree();
        self.scratch.clear();
        curve.push_bezier(j, &mut self.scratch);
        let points = &self.scratch;
        let (n0, w0) = (self.numerators.len(), self.weights.len());
        let plain = points.iter().all(|c| c[3] == points[0][3]);
        if plain {
            for (k, c) in points.windows(2).enumerate() {
                let s = p as f64 * binomial(p - 1, k) / c[0][3];
                self.numerators.push(std::array::from_fn(|i| s * (c[1][i] - c[0][i])));
            }
        } else {
            let largest = points.iter().fold(0.0_f64, |m, c| m.max(c[3]));
            let places: [[f64; 4]; crate::MAX_DEGREE + 1] = std::array::from_fn(|i| match points.get(i) {
                Some(&[x, y, z, w]) => [x / w, y / w, z / w, w / largest * binomial(p, i)],
                None => [0.0; 4],
            });
            for k in 0..=2 * p - 2 {
                let mut sum = [0.0; 3];
                for i in (k + 1).saturating_sub(p)..=k / 2 {
                    let (a, b) = (&places[i], &places[k + 1 - i]);
                    let s = (k + 1 - 2 * i) as f64 * a[3] * b[3];
                    sum = std::array::from_fn(|c| sum[c] + s * (b[c] - a[c]));
                }
                self.numerators.push(sum);
            }
            self.weights.extend(places.iter().take(p + 1).map(|c| [c[3]]));
        }
        let largest = self.numerators[n0..].iter().flatten().fold(0.0_f64, |m, x| m.max(x.abs()));
        let scale =
            if largest > SAFE_SIZE[0] && largest < SAFE_SIZE[1] || largest == 0.0 { 1.0 } else { largest };
        if scale != 1.0 {
            self.numerators[n0..].iter_mut().flatten().for_each(|x| *x /= scale);
        }
        let range = |from: usize, to: usize| (from as u32, to as u32);
        Place { numerator: range(n0, self.numerators.len()), weight: range(w0, self.weights.len()), scale }
    }

    pub(crate) fn get(&self, place: Place) -> Speed<'_> {
        let range = |(a, b): (u32, u32)| a as usize..b as usize;
        Speed {
            numerator: self.numerators.get(range(place.numerator)).unwrap_or(&[]),
            weight: self.weights.get(range(place.weight)).unwrap_or(&[]),
            scale: place.scale,
        }
    }
}

impl Speed<'_> {
    /// The speed at x.
    pub(crate) fn at(self, x: f64) -> f64 {
        let d = horner(self.numerator, x);
        let length = (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]).sqrt() * self.scale;
        if self.weight.is_empty() {
            return length;
        }
        let [w] = horner(self.weight, x);
        length / (w * w)
    }

    /// The length over a…b by the 31-point rule, and how far the 15-point rule is from it.
    pub(crate) fn rule(self, a: f64, b: f64) -> (f64, f64) {
        let norm = |d: [f64; 3]| (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]).sqrt();
        // Fixed sizes let the compiler unroll: lines, quadratics, cubics, quartics and quintics without weights.
        macro_rules! plain {
            ($n:literal) => {
                if let Ok(c) = <&[[f64; 3]; $n]>::try_from(self.numerator)
                    && self.weight.is_empty()
                {
                    let (value, error) = gauss_kronrod_31(|x| norm(horner(c, x)), a, b);
                    return (value * self.scale, error * self.scale);
                }
            };
        }
        macro_rules! rational {
            ($n:literal, $w:literal) => {
                if let (Ok(c), Ok(w)) =
                    (<&[[f64; 3]; $n]>::try_from(self.numerator), <&[[f64; 1]; $w]>::try_from(self.weight))
                {
                    let speed = |x: f64| {
                        let [w] = horner(w, x);
                        norm(horner(c, x)) / (w * w)
                    };
                    let (value, error) = gauss_kronrod_31(speed, a, b);
                    return (value * self.scale, error * self.scale);
                }
            };
        }
        plain!(1);
        plain!(2);
        plain!(3);
        plain!(4);
        plain!(5);
        rational!(3, 3);
        rational!(5, 4);
        rational!(7, 5);
        gauss_kronrod_31(|x| self.at(x), a, b)
    }

    /// The length over 0…1. Parts are halved until the two rules agree to `relative` of the part's length or of
    /// `floor`, whichever is more; `leaf` gets each part, in order, with its length.
    pub(crate) fn measure(self, relative: f64, floor: f64, mut leaf: impl FnMut(f64, f64, f64)) -> f64 {
        let mut stack = [(0.0, 1.0, 0_u32); DEEPEST as usize + 2];
        let (mut top, mut parts, mut sum) = (1, 0, 0.0);
        while top > 0 {
            top -= 1;
            let (a, b, depth) = stack[top];
            let (value, error) = self.rule(a, b);
            parts += 1;
            // The finer value is far better than the difference tells; (200 e)^1.5 is QUADPACK's estimate of how far.
            let estimate =
                if value > 0.0 { error.min(value * (200.0 * error / value).raised_to(1.5)) } else { error };
            let fine = !(estimate > relative * value.max(floor));
            if fine || depth >= DEEPEST || parts >= MOST_PARTS {
                sum += value;
                leaf(a, b, value);
                continue;
            }
            let middle = 0.5 * (a + b);
            stack[top] = (middle, b, depth + 1);
            stack[top + 1] = (a, middle, depth + 1);
            top += 2;
        }
        sum
    }
}

#[cfg(test)]
mod tests {
    use super::Hodographs;
    use crate::{NurbsCurve, Point3};

    #[test]
    fn speed_is_the_length_of_the_velocity() {
        for degree in 1..8 {
            let points: Vec<Point3> = (0..degree + 4)
                .map(|i| Point3::new(i as f64, (i as f64 * 1.3).sin(), (i as f64 * 0.7).cos()))
                .collect();
            let knots: Vec<f64> = (0..points.len() + degree - 1).map(|i| (i as f64).powf(1.2)).collect();
            let weights: Vec<f64> = (0..points.len()).map(|i| 1.0 + 0.3 * (i as f64).cos()).collect();
            let plain = NurbsCurve::new(degree, points.clone(), knots.clone()).unwrap();
            let rational = NurbsCurve::with_weights(degree, &points, &weights, knots.clone()).unwrap();
            for curve in [plain, rational] {
                for j in curve.spans() {
                    let mut store = Hodographs::default();
                    let place = store.push(&curve, j);
                    let (a, b) = (knots[j + degree - 1], knots[j + degree]);
                    for x in [0.0, 0.3, 0.5, 1.0] {
                        let want = curve.velocity(j, a + (b - a) * x).length() * (b - a);
                        let have = store.get(place).at(x);
                        assert!((want - have).abs() < 1e-12 * (1.0 + want), "{want} {have}");
                    }
                }
            }
        }
    }
}
