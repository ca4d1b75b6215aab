//! The numbers by which openNURBS takes things for zero or for the same, and what it takes for a number.

use katydid_geometry::{Interval, Plane, Point3, Vector3};

use super::Verdict;

/// 2⁻³²: what counts as zero among coordinates.
pub(super) const ZERO: f64 = 2.328_306_436_538_696_3e-10;
/// 2⁻⁴²: how far equal coordinates may be apart, as a fraction of their sum.
const RELATIVE: f64 = 2.273_736_754_432_320_6e-13;
/// 2⁻²⁶: the square root of the machine epsilon.
pub(super) const ROOT: f64 = 1.490_116_119_384_765_6e-8;
/// The machine epsilon, 2⁻⁵².
const EPSILON: f64 = f64::EPSILON;
/// What stands for a number that is not set; so does its negative, and nothing beyond is a number.
const UNSET: f64 = 1.234_321_012_343_21e308;

/// Whether something is a number, and set.
pub(super) fn is_set(x: f64) -> bool {
    x.is_finite() && x.abs() < UNSET
}

/// A point's coordinates are numbers.
pub(super) fn point(p: Point3, what: &str) -> Verdict {
    if [p.x, p.y, p.z].into_iter().all(is_set) {
        return Ok(());
    }
    Err(format!("a coordinate of {what} is not a number"))
}

/// An interval with a start before its end.
pub(super) fn increasing(interval: Interval, what: &str) -> Verdict {
    if is_set(interval.start) && is_set(interval.end) && interval.start < interval.end {
        return Ok(());
    }
    Err(format!("{what} does not increase ({} to {})", interval.start, interval.end))
}

/// Whether points are one to openNURBS.
pub(super) fn coincide(p: Point3, q: Point3) -> bool {
    [(p.x, q.x), (p.y, q.y), (p.z, q.z)].into_iter().all(|(a, b)| {
        let apart = (a - b).abs();
        apart <= ZERO || apart <= (a.abs() + b.abs()) * RELATIVE
    })
}

/// Whether a vector has the length 1.
pub(super) fn is_unit(v: Vector3) -> bool {
    (v.length() - 1.0).abs() <= ROOT
}

/// A plane with right-handed axes of length 1, whose equation holds at its origin. `offset` is the last number of the
/// equation where it is not the one that follows from the plane.
pub(super) fn plane(plane: &Plane, offset: Option<f64>) -> Verdict {
    let Plane { origin, x_axis: x, y_axis: y, z_axis: z } = *plane;
    let d = offset.unwrap_or_else(|| -(z.x * origin.x + z.y * origin.y + z.z * origin.z));
    if ![z.x, z.y, z.z, d].into_iter().all(is_set) || z == Vector3::ZERO {
        return Err("the equation of its plane is none".into());
    }
    let off = (z.x * origin.x + z.y * origin.y + z.z * origin.z + d).abs();
    let greatest = [origin.x, origin.y, origin.z].into_iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let size = greatest + d.abs();
    let limit = if size > 1000.0 { size * EPSILON * 10.0 } else { ZERO };
    if off.is_nan() || off > limit.max(ZERO) {
        return Err("the origin of its plane does not lie in it".into());
    }
    let square = [x.dot(y), y.dot(z), z.dot(x)].into_iter().all(|dot| dot.abs() <= ROOT);
    if !([x, y, z].into_iter().all(is_unit) && square && x.cross(y).dot(z) > ROOT) {
        return Err("the axes of its plane are not square, or not of length 1".into());
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn planes_are_square() {
        assert_eq!(plane(&Plane::XY, None), Ok(()));
        assert!(plane(&Plane::XY, Some(1.0)).is_err());
        assert!(plane(&Plane { x_axis: Vector3::X * 1.001, ..Plane::XY }, None).is_err());
        assert!(plane(&Plane { z_axis: -Vector3::Z, ..Plane::XY }, None).is_err());
        let far = Plane { origin: Point3::new(1e7, -1e7, 1e7), ..Plane::XY };
        assert_eq!(plane(&far, Some(-1e7 - 1e-9)), Ok(()));
    }

    #[test]
    fn coordinates_coincide_by_difference_or_by_ratio() {
        let p = Point3::new(1e6, 0.0, 0.0);
        assert!(coincide(p, Point3::new(1e6 + 1e-7, 1e-10, 0.0)));
        assert!(!coincide(p, Point3::new(1e6, 1e-9, 0.0)));
        assert!(!is_set(-UNSET) && !is_set(f64::NAN) && is_set(0.0));
    }
}
