//! Hanging chains.

use katydid_elementary::Elementary;

use crate::thresholds;
use crate::{Curve, Error, KnotSpacing, NurbsCurve, Point3, PolylineCurve, Result, Vector3};

/// Below this argument sinh z / z is its series to the last place: the next term is z⁴/120.
const SERIES: f64 = 1e-4;
/// The parameter of the flattest chain: half of the digits, where sinh z / z − 1 is rounding.
const LEAST_PARAMETER: f64 = 1e-8;

/// The curve of a chain of a given length that hangs between two points: a·cosh(x/a).
///
/// The parameter a solves √(L² − h²) = 2a·sinh(d/2a), where h is how far apart the points are along gravity and d how
/// far across it. The result interpolates 97 points at equal steps across gravity, with the exact slopes at its ends: on
/// steep chains these steps are short where the chain bends. A chain between points one above the other hangs straight down and up again.
///
/// # Errors
/// A length that is not greater than the distance of the points, gravity without direction, or a number that is not
/// finite.
pub fn catenary(a: Point3, b: Point3, length: f64, gravity: Vector3) -> Result<Curve> {
    if !(a.is_finite() && b.is_finite() && length.is_finite()) {
        return Err(Error::NotFinite("catenary"));
    }
    let up = -gravity.unitized().ok_or(Error::degenerate("gravity", "it has no direction"))?;
    let chord = b - a;
    if !(length > chord.length() * (1.0 + thresholds::ROUNDING)) {
        let must = "greater than the distance of the points";
        return Err(Error::OutOfRange { what: "length of a catenary", value: length, must });
    }
    let rise = chord.dot(up);
    let across = chord - up * rise;
    let width = across.length();
    // Narrower than this the two strands are one to rounding.
    if width <= thresholds::SAME_POINT * length {
        let low = a - up * (0.5 * (length - rise));
        return Ok(PolylineCurve::new(vec![a, low, b])?.into());
    }
    let x_axis = across / width;
    let z = half_width((length * length - rise * rise).sqrt() / width);
    let scale = width / (2.0 * z);
    // The lowest point, measured from a: tanh of the middle between both ends is rise/length.
    let lowest = 0.5 * width - scale * (rise / length).area_tangent();
    let (first, last) = (-lowest / scale, (width - lowest) / scale);
    let steps = 96;
    let point = |k: i32| {
        if k == 0 {
            return a;
        } else if k == steps {
            return b;
        }
        let t = first + (last - first) * f64::from(k) / f64::from(steps);
        a + x_axis * (scale * (t - first))
            + up * (scale * (t.hyperbolic_cosine() - first.hyperbolic_cosine()))
    };
    let points: Vec<Point3> = (0..=steps).map(point).collect();
    let slope = |t: f64| x_axis / t.hyperbolic_cosine() + up * t.hyperbolic_tangent();
    let ends = [Some(slope(first)), Some(slope(last))];
    Ok(NurbsCurve::interpolate(3, &points, KnotSpacing::Chord, ends[0], ends[1])?.into())
}

/// The z with sinh(z)/z = `ratio`, which is above 1: bisection, with ends that hold the root.
fn half_width(ratio: f64) -> f64 {
    let (mut low, mut high) = (0.0, 1.0);
    let value = |z: f64| if z < SERIES { 1.0 + z * z / 6.0 } else { z.hyperbolic_sine() / z };
    while value(high) < ratio && high < 700.0 {
        high *= 2.0;
    }
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if value(middle) < ratio {
            low = middle;
        } else {
            high = middle;
        }
    }
    (0.5 * (low + high)).max(LEAST_PARAMETER)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_level_chain_has_the_closed_form() {
        // a = 2 over a width of 4: y = 2 cosh(x/2), length 4 sinh 1.
        let (a, b) = (Point3::new(-2.0, 0.0, 0.0), Point3::new(2.0, 0.0, 0.0));
        let chain = catenary(a, b, 4.0 * 1f64.sinh(), -Vector3::Z).unwrap();
        assert!((chain.length() - 4.0 * 1f64.sinh()).abs() < 1e-6);
        let domain = chain.domain();
        for k in 0..=50 {
            let p = chain.point_at(domain.at(f64::from(k) / 50.0));
            let y = 2.0 * ((p.x / 2.0).cosh() - 1f64.cosh());
            assert!((p.z - y).abs() < 1e-7, "{p:?} {y}");
        }
    }

    #[test]
    fn any_chain_has_its_length_and_ends() {
        for (b, length) in [
            ([3.0, 4.0, 5.0], 20.0),
            ([3.0, 4.0, -5.0], 7.2),
            ([1e-3, 0.0, 0.0], 10.0),
            ([1000.0, 0.0, 10.0], 1001.0),
            ([0.0, 0.0, 4.0], 10.0),
        ] {
            let (a, b) = (Point3::new(1.0, 2.0, 3.0), Point3::new(1.0, 2.0, 3.0) + Vector3::from(b));
            let chain = catenary(a, b, length, Vector3::new(0.0, 0.0, -9.81)).unwrap();
            assert!((chain.length() / length - 1.0).abs() < 1e-5, "{} {length}", chain.length());
            assert!(chain.start().distance_to(a) < 1e-12 && chain.end().distance_to(b) < 1e-12);
        }
    }

    #[test]
    fn impossible_chains() {
        let b = Point3::new(3.0, 0.0, 0.0);
        assert!(catenary(Point3::ORIGIN, b, 3.0, -Vector3::Z).is_err());
        assert!(catenary(Point3::ORIGIN, b, f64::NAN, -Vector3::Z).is_err());
        assert!(catenary(Point3::ORIGIN, b, 4.0, Vector3::ZERO).is_err());
    }
}
