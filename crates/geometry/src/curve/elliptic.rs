//! Ellipses and parts of them, exact and recognised.

use crate::curve::thresholds::{NO_ELLIPSE, NO_PIVOT, OVER_TURN, WHOLE_ELLIPSE};
use std::f64::consts::TAU;

use katydid_elementary::Elementary;

use super::Curve;
use crate::{Ellipse, Interval, NurbsCurve, Plane, Point3, Result, Vector3, Xform};

impl Ellipse {
    /// The part between two eccentric angles in radians as an exact rational curve over `domain`: the affine image of
    /// the arc of a circle, so it has the arc's spans and weights. A range of more than a turn gives the full ellipse,
    /// a decreasing one the part walked backwards.
    ///
    /// # Errors
    /// The angles are equal or not finite, or the domain does not increase.
    pub fn arc_to_nurbs(&self, angle: Interval, domain: Interval) -> Result<NurbsCurve> {
        let unit = crate::Circle::new(Plane::XY, 1.0)?;
        let arc = crate::Arc::new(unit, angle)?;
        let (x, y, z, o) =
            (self.plane.x_axis * self.rx, self.plane.y_axis * self.ry, self.plane.z_axis, self.plane.origin);
        let image = Xform {
            rows: [[x.x, y.x, z.x, o.x], [x.y, y.y, z.y, o.y], [x.z, y.z, z.z, o.z], [0.0, 0.0, 0.0, 1.0]],
        };
        arc.to_nurbs(domain)?.transformed(&image)
    }
}

impl Curve {
    /// The ellipse that a closed curve is within `tolerance`, its longer radius along x, turning as the curve does;
    /// `None` when it is none. A circle is an ellipse with equal radii.
    ///
    /// The conic through points of the curve by least squares, then the distance of every piece at 3p + 2 points (a
    /// piece of degree p has at most 4p in common with another conic).
    pub fn as_ellipse(&self, tolerance: f64) -> Option<Ellipse> {
        if !self.is_closed() {
            return None;
        }
        let (ellipse, angle) = self.as_elliptic_arc(tolerance)?;
        ((angle.length() - TAU).abs() < WHOLE_ELLIPSE).then_some(ellipse)
    }

    /// The part of an ellipse that the curve is within `tolerance`, with its range of eccentric angles, increasing;
    /// `None` when it is none. Straight curves are none.
    pub fn as_elliptic_arc(&self, tolerance: f64) -> Option<(Ellipse, Interval)> {
        if let Self::Arc(c) = self {
            let ellipse = Ellipse::new(c.arc.circle.plane, c.arc.circle.radius, c.arc.circle.radius).ok()?;
            return Some((ellipse, c.arc.angle));
        }
        let plane = self.plane(tolerance)?;
        if self.is_linear(tolerance) {
            return None;
        }
        let pieces = self.pieces();
        let mut samples: Vec<(f64, f64, Point3)> = Vec::new();
        for piece in &pieces {
            let steps = match piece.shape {
                super::piece::Shape::Span(c, _) => 4 * c.degree() + 2,
                _ => 4,
            };
            for k in 0..=steps {
                let p = piece.point(piece.own.at(k as f64 / steps as f64));
                let [x, y, _] = plane.coordinates(p);
                samples.push((x, y, p));
            }
        }
        let ellipse = fitted(&samples, &plane)?;
        let mut last: Option<f64> = None;
        let mut first = 0.0;
        for &(_, _, p) in &samples {
            let [x, y, z] = ellipse.plane.coordinates(p);
            let angle = (y / ellipse.ry).arctangent_of(x / ellipse.rx);
            // First-order distance: the implicit function over its gradient.
            let (u, v) = (x / ellipse.rx, y / ellipse.ry);
            let value = u * u + v * v - 1.0;
            let gradient = 2.0 * (u / ellipse.rx).hypotenuse(v / ellipse.ry);
            if !(value.abs() <= tolerance * gradient && z.abs() <= tolerance) {
                return None;
            }
            match last {
                None => {
                    first = angle;
                    last = Some(angle);
                }
                Some(before) => {
                    let step = angle - before;
                    let angle = angle - (step / TAU).round() * TAU;
                    let slack = tolerance / ellipse.ry;
                    if angle < before - slack {
                        return None;
                    }
                    last = Some(angle.max(before));
                }
            }
        }
        let end = last?;
        (end > first && end - first <= TAU + OVER_TURN).then(|| {
            let end = if self.is_closed() { first + TAU } else { end };
            (ellipse, Interval::new(first, end))
        })
    }
}

/// The ellipse through samples in a plane: A x² + B xy + C y² + D x + E y = 1 about their mean, by least squares; its
/// plane turns with the samples.
fn fitted(samples: &[(f64, f64, Point3)], plane: &Plane) -> Option<Ellipse> {
    let n = samples.len() as f64;
    let (mx, my) = samples.iter().fold((0.0, 0.0), |s, p| (s.0 + p.0 / n, s.1 + p.1 / n));
    let size = samples.iter().map(|p| (p.0 - mx).abs().max((p.1 - my).abs())).fold(0.0, f64::max);
    if !(size > 0.0) {
        return None;
    }
    // Six unknowns with the constant, scale fixed by A + C = 1: works wherever the mean lies.
    let mut a = [[0.0; 6]; 5];
    for &(x, y, _) in samples {
        let (x, y) = ((x - mx) / size, (y - my) / size);
        // A(x² − y²) + Bxy + Dx + Ey + F = −y², with C = 1 − A.
        let row = [x * x - y * y, x * y, x, y, 1.0];
        for i in 0..5 {
            for j in 0..5 {
                a[i][j] += row[i] * row[j];
            }
            a[i][5] += row[i] * -y * y;
        }
    }
    let s = solve5(a)?;
    let (ca, cb, cc, cd, ce, cf) = (s[0], s[1], 1.0 - s[0], s[2], s[3], s[4]);
    let determinant = 4.0 * ca * cc - cb * cb;
    if !(determinant > NO_ELLIPSE) {
        return None;
    }
    let (x0, y0) = ((cb * ce - 2.0 * cc * cd) / determinant, (cb * cd - 2.0 * ca * ce) / determinant);
    let level = -(ca * x0 * x0 + cb * x0 * y0 + cc * y0 * y0 + cd * x0 + ce * y0 + cf);
    // The axes are those of the quadratic form.
    let half = 0.5 * cb.arctangent_of(ca - cc);
    let (sin, cos) = half.sine_cosine();
    let big = ca * cos * cos + cb * cos * sin + cc * sin * sin;
    let small = ca * sin * sin - cb * cos * sin + cc * cos * cos;
    let (r_big, r_small) = ((level / big).sqrt() * size, (level / small).sqrt() * size);
    let center = plane.at(mx + size * x0, my + size * y0, 0.0);
    // `big` belongs to direction (cos, sin) and is the larger coefficient, hence the shorter radius.
    let long = plane.x_axis * -sin + plane.y_axis * cos;
    let z = plane.z_axis;
    let turn: Vector3 = samples.windows(2).map(|w| (w[0].2 - center).cross(w[1].2 - center)).sum();
    let z = if turn.dot(z) < 0.0 { -z } else { z };
    let frame = Plane::from_axes(center, long, z.cross(long)).ok()?;
    Ellipse::new(frame, r_small, r_big).ok()
}

/// Gaussian elimination with partial pivoting.
fn solve5(mut a: [[f64; 6]; 5]) -> Option<[f64; 5]> {
    for k in 0..5 {
        let pivot = (k..5).max_by(|&i, &j| a[i][k].abs().total_cmp(&a[j][k].abs()))?;
        a.swap(k, pivot);
        if !(a[k][k].abs() > NO_PIVOT) {
            return None;
        }
        for i in k + 1..5 {
            let factor = a[i][k] / a[k][k];
            for j in k..6 {
                a[i][j] -= factor * a[k][j];
            }
        }
    }
    let mut x = [0.0; 5];
    for k in (0..5).rev() {
        let rest: f64 = (k + 1..5).map(|j| a[k][j] * x[j]).sum();
        x[k] = (a[k][5] - rest) / a[k][k];
    }
    Some(x)
}
