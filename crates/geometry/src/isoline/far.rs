use super::metaballs::Ball;
use crate::Point2;

/// The degree of the polynomial.
const DEGREE: usize = 8;
/// A ball is far from a square when it is this many half diagonals from the middle. There the terms left out are off by
/// less than 1e-5 of the ball's strength: along a line through the middle at distance d of the ball, the n-th term of
/// 1/r² is at most (n + 1)/d² · (s/d)ⁿ (Chebyshev polynomials of the second kind), s the way from the middle.
const FAR: f64 = 5.0;

/// The field of far balls near a place: a Taylor polynomial.
#[derive(Debug, Clone, Copy)]
pub(super) struct Far {
    middle: Point2,
    /// By degree n, then by the power j of y: the factor of xⁿ⁻ʲyʲ.
    terms: [[f64; DEGREE + 1]; DEGREE + 1],
}

impl Far {
    pub(super) fn about(middle: Point2) -> Self {
        Self { middle, terms: [[0.0; DEGREE + 1]; DEGREE + 1] }
    }

    /// The squared distance from which on a ball is far, from the middle of a square of a given half side.
    pub(super) fn squared_distance(half: f64) -> f64 {
        2.0 * FAR * FAR * half * half
    }

    /// Adds a ball. Its field f = charge/q, q = d² + 2·dx·x + 2·dy·y + x² + y², fulfils q·f = charge, which gives the
    /// terms of each degree from the two before.
    pub(super) fn add(&mut self, ball: &Ball) {
        let (dx, dy) = (self.middle.x - ball.x, self.middle.y - ball.y);
        let inverse = 1.0 / (dx * dx + dy * dy + ball.off);
        let (a, b) = (-2.0 * dx * inverse, -2.0 * dy * inverse);
        // Shifted by two, so that there are terms before the first: 0.
        let (mut before, mut last) = ([0.0; DEGREE + 3], [0.0; DEGREE + 3]);
        last[2] = ball.charge * inverse;
        self.terms[0][0] += last[2];
        for degree in self.terms.iter_mut().skip(1) {
            let mut next = [0.0; DEGREE + 3];
            for j in 0..=DEGREE {
                next[j + 2] = a * last[j + 2] + b * last[j + 1] - inverse * (before[j + 2] + before[j]);
                degree[j] += next[j + 2];
            }
            (before, last) = (last, next);
        }
    }

    pub(super) fn at(&self, p: Point2) -> f64 {
        let (x, y) = (p.x - self.middle.x, p.y - self.middle.y);
        let (mut sum, mut powers) = (self.terms[0][0], [0.0; DEGREE + 1]);
        powers[0] = 1.0;
        let mut top = 1.0;
        for (n, degree) in self.terms.iter().enumerate().skip(1) {
            powers.iter_mut().for_each(|p| *p *= x);
            top *= y;
            powers[n] = top;
            sum += degree.iter().zip(&powers).map(|(c, p)| c * p).sum::<f64>();
        }
        sum
    }

    /// The same polynomial about another place.
    pub(super) fn moved(&self, middle: Point2) -> Self {
        let (x, y) = (middle.x - self.middle.x, middle.y - self.middle.y);
        let mut out = Self { middle, ..*self };
        // The factor of xⁱyʲ is in degree i + j: Horner's scheme along i, then along j.
        for k in 0..DEGREE {
            for n in (k..DEGREE).rev() {
                for j in 0..=n - k {
                    out.terms[n][j] += x * out.terms[n + 1][j];
                }
            }
        }
        for k in 0..DEGREE {
            for n in (k..DEGREE).rev() {
                for j in k..=n {
                    out.terms[n][j] += y * out.terms[n + 1][j + 1];
                }
            }
        }
        out
    }

    /// Its value in the middle, and how far values in a square about it can be from that.
    pub(super) fn range(&self, half: f64) -> [f64; 2] {
        let (mut spread, mut power) = (0.0, 1.0);
        for degree in self.terms.iter().skip(1) {
            power *= half;
            spread += power * degree.iter().map(|c| c.abs()).sum::<f64>();
        }
        [self.terms[0][0], spread]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn as_the_balls_themselves() {
        let mut far = Far::about(Point2::new(1.0, -2.0));
        let half = 1.0;
        let least = Far::squared_distance(half).sqrt();
        let mut balls = Vec::new();
        for k in 0..40 {
            let (angle, away) = (f64::from(k) * 0.7, least * (1.0 + f64::from(k % 5)));
            let off = f64::from(k % 3) * 4.0;
            let ball = Ball { x: 1.0 + away * angle.cos(), y: -2.0 + away * angle.sin(), off, charge: 1.0 };
            far.add(&ball);
            balls.push(ball);
        }
        let again = far.moved(Point2::new(1.3, -2.4));
        let [middle, spread] = far.range(half);
        for (u, v) in [(0.0, 0.0), (1.0, 1.0), (-1.0, 1.0), (0.3, -0.9), (1.0, -1.0)] {
            let p = Point2::new(1.0 + u, -2.0 + v);
            let exact: f64 = balls.iter().map(|b| b.charge / b.squared_distance(p)).sum();
            assert!((far.at(p) / exact - 1.0).abs() < 1e-5);
            assert!((far.at(p) - again.at(p)).abs() < 1e-12 * exact);
            assert!((exact - middle).abs() <= spread + 1e-5 * exact);
        }
        // One ball as near as may be, the worst place.
        let ball =
            Ball { x: 1.0 + least * 0.5_f64.sqrt(), y: -2.0 + least * 0.5_f64.sqrt(), off: 0.0, charge: 1.0 };
        let mut one = Far::about(Point2::new(1.0, -2.0));
        one.add(&ball);
        let p = Point2::new(2.0, -1.0);
        assert!((one.at(p) * ball.squared_distance(p) - 1.0).abs() < 1e-5);
    }
}
