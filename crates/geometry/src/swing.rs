//! Arcs that swing from circle to circle.

use crate::thresholds;
use crate::{Arc, Circle, Curve, Error, Plane, Point3, PolyCurve, Result};

/// What [`swing_arcs`] gives.
#[derive(Debug, Clone, PartialEq)]
pub struct SwingArcs {
    /// The curve that passes the first circle on the left.
    pub left: Curve,
    /// The curve that passes it on the right.
    pub right: Curve,
    /// The circles, one about each centre.
    pub circles: Vec<Circle>,
}

/// The two smooth curves that wind through a row of circles, each of which touches the next.
///
/// The first circle has the given radius, and each other one the radius with which it touches the one before on the
/// line between the centres: from outside, or, when the next centre lies within it, from inside. A curve goes half
/// round the first circle to where it touches the second, round that on the other side, and so on; it ends on the
/// last circle opposite to where it came in. Centres are projected into the plane.
///
/// # Errors
/// Fewer than two centres, two following ones in one place, a radius that is not above 0 or for which a circle would
/// shrink to a point, or more than a million centres.
pub fn swing_arcs(centers: &[Point3], plane: &Plane, radius: f64) -> Result<SwingArcs> {
    if !(radius > 0.0 && radius.is_finite()) {
        return Err(Error::OutOfRange { what: "radius", value: radius, must: "finite and greater than 0" });
    }
    if !(2..=1_000_000).contains(&centers.len()) {
        return Err(Error::OutOfRange {
            what: "number of centres",
            value: centers.len() as f64,
            must: "from 2 to a million",
        });
    }
    let flat: Vec<Point3> = centers.iter().map(|c| plane.closest_point(*c)).collect();
    let mut circles = vec![Circle::new(plane.with_origin(flat[0]), radius)?];
    // A radius below 0 is that of a circle which holds the one before.
    let mut signed = radius;
    let mut joints = Vec::with_capacity(flat.len() + 1);
    for w in flat.windows(2) {
        let way = w[1] - w[0];
        let length = way.length();
        let along =
            way.unitized().ok_or(Error::degenerate("centres", "two following ones are in one place"))?;
        if joints.is_empty() {
            joints.push(w[0] - along * signed);
        }
        joints.push(w[0] + along * signed);
        signed = length - signed;
        if !(signed.abs() > thresholds::ROUNDING * length) {
            return Err(Error::degenerate("circle", "it would shrink to a point: choose another radius"));
        }
        circles.push(Circle::new(plane.with_origin(w[1]), signed.abs())?);
    }
    if let (Some(last), Some(&center)) = (joints.last().copied(), flat.last()) {
        joints.push(center + (center - last));
    }
    let curve = |side: f64| -> Result<Curve> {
        let first = joints.get(..2).unwrap_or(&[]);
        let &[start, touch] = first else {
            return Err(Error::degenerate("centres", "there are too few"));
        };
        let mut heading = plane.z_axis.cross(touch - start) * side;
        let mut arcs: Vec<Curve> = Vec::with_capacity(circles.len());
        for w in joints.windows(2) {
            if w[0].distance_to(w[1]) <= thresholds::ROUNDING * w[0].to_vector().length().max(radius) {
                continue;
            }
            let arc = Arc::from_start_direction_end(w[0], heading, w[1])?;
            let curve = Curve::from(arc);
            let end = curve.domain().end;
            heading = curve.tangent_at(end).unwrap_or(heading);
            arcs.push(curve);
        }
        Ok(PolyCurve::new(arcs)?.into())
    };
    Ok(SwingArcs { left: curve(1.0)?, right: curve(-1.0)?, circles })
}

#[cfg(test)]
mod tests {
    use super::swing_arcs;
    use crate::{Plane, Point3};

    fn p(x: f64, y: f64) -> Point3 {
        Point3::new(x, y, 0.0)
    }

    #[test]
    fn waves_along_a_line() {
        let swing = swing_arcs(&[p(0.0, 0.0), p(3.0, 0.0), p(6.0, 0.0)], &Plane::XY, 1.0).unwrap();
        let radii: Vec<f64> = swing.circles.iter().map(|c| c.radius).collect();
        assert_eq!(radii, [1.0, 2.0, 1.0]);
        let half_turns = std::f64::consts::PI * 4.0;
        assert!((swing.left.length() - half_turns).abs() < 1e-9);
        assert!((swing.right.length() - half_turns).abs() < 1e-9);
        let top = swing.left.closest_point(p(0.0, 1.0)).unwrap();
        assert!(top.distance < 1e-9);
        // On the other side of the second circle.
        assert!(swing.left.closest_point(p(3.0, -2.0)).unwrap().distance < 1e-9);
        assert!(swing.right.closest_point(p(3.0, 2.0)).unwrap().distance < 1e-9);
    }

    #[test]
    fn corners_are_smooth() {
        let centers = [p(0.0, 0.0), p(5.0, 0.0), p(5.0, 4.0), p(-1.0, 7.0)];
        let swing = swing_arcs(&centers, &Plane::XY, 2.0).unwrap();
        for curve in [&swing.left, &swing.right] {
            let kinks = curve.discontinuities(crate::Continuity::G1, &crate::Tolerance::default());
            assert!(kinks.is_empty(), "{kinks:?}");
        }
        assert!(swing_arcs(&centers[..1], &Plane::XY, 2.0).is_err());
        assert!(swing_arcs(&centers, &Plane::XY, 5.0).is_err());
        assert!(swing_arcs(&centers, &Plane::XY, f64::NAN).is_err());
    }
}
