//! Arcs that touch two circles.

use crate::{Arc, Circle, Error, Result};

impl Circle {
    /// The two arcs of a radius that touch this circle and another one from outside and lead from this to that, as a
    /// rounded notch between the two does: first the one on the left of the way from centre to centre, seen with
    /// this circle's normal up. The other circle is projected into the plane of this one.
    ///
    /// Their centres stand as far from the two centres as the radii together.
    ///
    /// # Errors
    /// A radius that is not above 0, one too small to bridge the gap, or a circle within the other.
    pub fn tangent_arcs(&self, other: &Self, radius: f64) -> Result<[Arc; 2]> {
        if !(radius > 0.0 && radius.is_finite()) {
            return Err(Error::OutOfRange {
                what: "radius",
                value: radius,
                must: "finite and greater than 0",
            });
        }
        let (p, q) = (self.plane.origin, self.plane.closest_point(other.plane.origin));
        let way = q - p;
        let distance = way.length();
        let along = way.unitized().ok_or(Error::degenerate("circles", "they have the same centre"))?;
        let side = self.plane.z_axis.cross(along);
        let (a, b) = (self.radius + radius, other.radius + radius);
        let x = (distance * distance + a * a - b * b) / (2.0 * distance);
        let square = a * a - x * x;
        if !(square > 0.0) {
            return Err(if a + b <= distance {
                Error::OutOfRange {
                    what: "radius",
                    value: radius,
                    must: "large enough to reach both circles",
                }
            } else {
                Error::degenerate("circles", "one lies within the other")
            });
        }
        let arc = |sign: f64| {
            let center = p + along * x + side * (sign * square.sqrt());
            let touch = |c: crate::Point3, r: f64| c + (center - c) * (r / (r + radius));
            let (from, to) = (touch(p, self.radius), touch(q, other.radius));
            let middle = ((from - center) + (to - center))
                .with_length(radius)
                .ok_or(Error::degenerate("arc", "it would be half a turn long both ways"))?;
            Arc::through(from, center + middle, to)
        };
        Ok([arc(1.0)?, arc(-1.0)?])
    }
}

#[cfg(test)]
mod tests {
    use crate::{Circle, Plane, Point3};

    #[test]
    fn arcs_touch_both_circles() {
        let a = Circle::new(Plane::XY, 2.0).unwrap();
        let b = Circle { plane: Plane::XY.with_origin(Point3::new(8.0, 0.0, 0.0)), radius: 2.0 };
        // 3-4-5: centres at (4, ±3) with radius 3.
        let [left, right] = a.tangent_arcs(&b, 3.0).unwrap();
        assert!(left.circle.center().distance_to(Point3::new(4.0, 3.0, 0.0)) < 1e-12);
        assert!(right.circle.center().distance_to(Point3::new(4.0, -3.0, 0.0)) < 1e-12);
        assert!(left.start().distance_to(Point3::new(1.6, 1.2, 0.0)) < 1e-12);
        assert!(left.end().distance_to(Point3::new(6.4, 1.2, 0.0)) < 1e-12);
        assert!(left.midpoint().distance_to(Point3::new(4.0, 0.0, 0.0)) < 1e-12);
        assert!(a.tangent_arcs(&b, 1.5).is_err());
        assert!(a.tangent_arcs(&a, 1.5).is_err());
        assert!(a.tangent_arcs(&b, f64::NAN).is_err());
    }
}
