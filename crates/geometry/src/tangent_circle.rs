//! Circles that touch curves.

use crate::{Circle, Curve, Error, Plane, Point3, Result, Vector3};

/// A circle is found when its distances from the curves differ by no more than this part of the tolerance.
const FOUND: f64 = 1e-3;

/// A circle in a plane that touches several curves of that plane: for two of them, of all such circles the one whose
/// centre is near `guess`; for three, the one found from there.
///
/// Newton's method on the differences of the distances to the curves, from the guess on. Each step moves the centre
/// within the plane by the least that makes the linearised differences zero.
///
/// # Errors
/// Other than two or three curves, a guess that leads nowhere, and curves that are touched in one place.
pub fn touching_circle(curves: &[&Curve], plane: &Plane, guess: Point3, tolerance: f64) -> Result<Circle> {
    if !(2..=3).contains(&curves.len()) {
        return Err(Error::Invalid { what: "tangent circle", why: format!("for {} curves", curves.len()) });
    }
    let lost = || Error::degenerate("tangent circle", "none was found from this point");
    let mut center = plane.closest_point(guess);
    for _ in 0..100 {
        let mut away = Vec::with_capacity(curves.len());
        for curve in curves {
            let near = curve.closest_point(center)?.point;
            let v = center - near;
            // On a curve itself any side will do: leave it along the plane.
            let u = v.unitized().unwrap_or(plane.x_axis);
            away.push((v.length(), u.dot(plane.x_axis), u.dot(plane.y_axis)));
        }
        let Some(&(d0, x0, y0)) = away.first() else { return Err(lost()) };
        let rows: Vec<[f64; 3]> = away.iter().skip(1).map(|(d, x, y)| [x - x0, y - y0, d - d0]).collect();
        if rows.iter().all(|row| row[2].abs() <= FOUND * tolerance) {
            let radius = d0;
            if !(radius > tolerance) {
                return Err(Error::degenerate("tangent circle", "the curves meet at the point"));
            }
            return Circle::new(plane.with_origin(center), radius);
        }
        let (sx, sy) = match *rows.as_slice() {
            // One condition: straight towards where it holds.
            [[x, y, f]] => {
                let g = x * x + y * y;
                (-f * x / g, -f * y / g)
            }
            [[a, b, f], [c, d, g]] => {
                let determinant = a * d - b * c;
                ((-f * d + g * b) / determinant, (-a * g + c * f) / determinant)
            }
            _ => return Err(lost()),
        };
        let step: Vector3 = plane.x_axis * sx + plane.y_axis * sy;
        if !step.is_finite() {
            return Err(lost());
        }
        // A step beyond the reach of the curves is cut: the distances bend there.
        let most = 2.0 * (d0 + away.iter().map(|a| a.0).fold(0.0, f64::max));
        let length = step.length();
        center += if length > most { step * (most / length) } else { step };
    }
    Err(lost())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Line, LineCurve};

    fn line(a: [f64; 3], b: [f64; 3]) -> Curve {
        LineCurve::new(Line::new(a.into(), b.into())).into()
    }

    #[test]
    fn three_lines_have_an_incircle() {
        let sides = [
            line([0.0, 0.0, 0.0], [4.0, 0.0, 0.0]),
            line([4.0, 0.0, 0.0], [0.0, 3.0, 0.0]),
            line([0.0, 3.0, 0.0], [0.0, 0.0, 0.0]),
        ];
        let curves: Vec<&Curve> = sides.iter().collect();
        let circle = touching_circle(&curves, &Plane::XY, Point3::new(0.5, 2.0, 7.0), 1e-6).unwrap();
        assert!((circle.radius - 1.0).abs() < 1e-8);
        assert!(circle.center().distance_to(Point3::new(1.0, 1.0, 0.0)) < 1e-8);
    }

    #[test]
    fn circles_are_touched() {
        let at = |x: f64, r: f64| -> Curve {
            Circle::new(Plane::XY.with_origin(Point3::new(x, 0.0, 0.0)), r).unwrap().into()
        };
        let (a, b) = (at(-5.0, 1.0), at(5.0, 2.0));
        let guess = Point3::new(0.0, 6.0, 0.0);
        let circle = touching_circle(&[&a, &b], &Plane::XY, guess, 1e-6).unwrap();
        let d = |x: f64| circle.center().distance_to(Point3::new(x, 0.0, 0.0));
        assert!((d(-5.0) - 1.0 - circle.radius).abs() < 1e-8);
        assert!((d(5.0) - 2.0 - circle.radius).abs() < 1e-8);
        assert!(circle.center().distance_to(guess) < 1.0);
        let ground = line([-9.0, -3.0, 0.0], [9.0, -3.0, 0.0]);
        let circle = touching_circle(&[&a, &b, &ground], &Plane::XY, Point3::ORIGIN, 1e-6).unwrap();
        assert!((circle.center().y + 3.0 - circle.radius).abs() < 1e-8);
        assert!(touching_circle(&[&a], &Plane::XY, guess, 1e-6).is_err());
        assert!(touching_circle(&[&a, &a, &a], &Plane::XY, guess, 1e-6).is_ok());
    }
}
