//! Circles seen from any side, and conics, as ellipses with their axes.

use katydid_elementary::Elementary;

use super::path::Place;

/// The places center + u·cos t + v·sin t: an ellipse by two conjugate radii.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Ellipse {
    pub(super) center: Place,
    pub(super) u: Place,
    pub(super) v: Place,
}

/// The half axes of an ellipse, and the angle of the larger one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Axes {
    pub(super) major: f64,
    pub(super) minor: f64,
    pub(super) degrees: f64,
}

/// An ellipse whose axes differ by more than this is a line.
const THINNEST: f64 = 1e-9;
/// One whose axes differ by no more than this share is a circle, which has no angle.
const ROUNDEST: f64 = 1e-12;

impl Ellipse {
    pub(super) fn at(&self, angle: f64) -> Place {
        let (sin, cos) = angle.sine_cosine();
        [0, 1].map(|i| self.center[i] + self.u[i] * cos + self.v[i] * sin)
    }

    /// Twice the signed area of the triangle of its radii: above 0 when angles grow from x to y of the page.
    pub(super) fn turn(&self) -> f64 {
        self.u[0] * self.v[1] - self.u[1] * self.v[0]
    }

    /// The half axes, by the singular values of the matrix [u v] (closed form for two rows, derived); nothing for a
    /// line.
    pub(super) fn axes(&self) -> Option<Axes> {
        let ([a, c], [b, d]) = (self.u, self.v);
        let (e, f, g, h) = ((a + d) / 2.0, (a - d) / 2.0, (c + b) / 2.0, (c - b) / 2.0);
        let (q, r) = (e.hypotenuse(h), f.hypotenuse(g));
        let (major, minor) = (q + r, (q - r).abs());
        if minor <= THINNEST * major {
            return None;
        }
        if minor >= major * (1.0 - ROUNDEST) {
            return Some(Axes { major, minor: major, degrees: 0.0 });
        }
        let angle = (h.arctangent_of(e) + g.arctangent_of(f)) / 2.0;
        Some(Axes { major, minor, degrees: angle.to_degrees() })
    }

    /// The angles between two at which the ellipse, seen as a line, turns back.
    pub(super) fn turns(&self, from: f64, to: f64) -> Vec<f64> {
        let along =
            if self.u[0].hypotenuse(self.u[1]) > self.v[0].hypotenuse(self.v[1]) { self.u } else { self.v };
        let dot = |a: Place| a[0] * along[0] + a[1] * along[1];
        let first = dot(self.v).arctangent_of(dot(self.u));
        let (low, high) = (from.min(to), from.max(to));
        let pi = std::f64::consts::PI;
        let start = ((low - first) / pi).ceil();
        let angles = (0..8).map(|k| first + (start + f64::from(k)) * pi);
        let mut angles: Vec<f64> = angles.take_while(|angle| *angle < high).collect();
        if from > to {
            angles.reverse();
        }
        angles
    }
}

/// A rational Bézier curve of degree 2 as a part of an ellipse between −half and half of an angle; nothing where it is a
/// parabola, a hyperbola, or too near to one of them (standard form after Piegl & Tiller, The NURBS Book, section 7.3).
pub(super) fn conic([p0, p1, p2]: [Place; 3], weights: &[f64]) -> Option<(Ellipse, f64)> {
    const NEAR_PARABOLA: f64 = 1e-6;
    let &[w0, w1, w2] = weights else { return None };
    let w = w1 / (w0 * w2).sqrt();
    let rest = 1.0 - w * w;
    // NaN when the outer weights differ in sign.
    if !(w > 0.0 && rest > NEAR_PARABOLA) {
        return None;
    }
    let center = [0, 1].map(|i| ((p0[i] + p2[i]) / 2.0 - w * w * p1[i]) / rest);
    let shoulder = [0, 1].map(|i| ((p0[i] + p2[i]) / 2.0 + w * p1[i]) / (1.0 + w));
    let u = [0, 1].map(|i| shoulder[i] - center[i]);
    let v = [0, 1].map(|i| (p2[i] - p0[i]) / (2.0 * rest.sqrt()));
    let ellipse = Ellipse { center, u, v };
    ellipse.axes().map(|_| (ellipse, w.arccosine()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_of_an_ellipse_by_conjugate_radii() {
        // Half axes 5 and 2, turned by 30°, told by radii at 40° and 130° of the parameter.
        let turn = 30_f64.to_radians();
        let place = |t: f64| {
            let (x, y) = (5.0 * t.cos(), 2.0 * t.sin());
            [x * turn.cos() - y * turn.sin(), x * turn.sin() + y * turn.cos()]
        };
        let t = 40_f64.to_radians();
        let ellipse = Ellipse { center: [0.0; 2], u: place(t), v: place(t + std::f64::consts::FRAC_PI_2) };
        let axes = ellipse.axes().unwrap();
        assert!((axes.major - 5.0).abs() < 1e-12 && (axes.minor - 2.0).abs() < 1e-12, "{axes:?}");
        assert!((axes.degrees - 30.0).abs() < 1e-9, "{axes:?}");
    }

    #[test]
    fn a_quarter_of_a_circle_is_found_in_its_bezier_form() {
        let w = 0.5_f64.sqrt();
        let (ellipse, half) = conic([[3.0, 0.0], [3.0, 3.0], [0.0, 3.0]], &[2.0, 2.0 * w, 2.0]).unwrap();
        assert!(ellipse.center.iter().all(|x| x.abs() < 1e-12));
        assert!((half - std::f64::consts::FRAC_PI_4).abs() < 1e-12);
        let axes = ellipse.axes().unwrap();
        assert!((axes.major - 3.0).abs() < 1e-12 && axes.minor == axes.major);
        assert!(conic([[0.0; 2], [1.0, 1.0], [2.0, 0.0]], &[1.0, 1.0, 1.0]).is_none(), "a parabola");
        assert!(conic([[0.0; 2], [1.0, 1.0], [2.0, 0.0]], &[1.0, 3.0, 1.0]).is_none(), "a hyperbola");
        assert!(conic([[0.0; 2], [1.0, 0.0], [2.0, 0.0]], &[1.0, 0.5, 1.0]).is_none(), "a line");
    }
}
