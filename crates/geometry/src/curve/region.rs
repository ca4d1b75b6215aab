//! What a closed planar curve encloses.

use super::Curve;
use super::piece::Shape;
use crate::curve::thresholds::{MOMENT_BOUND, NO_AREA};
use crate::quadrature::integrate;
use crate::{Error, MassProperties, Plane, Point3, Result};

/// Where a point lies relative to a closed curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Containment {
    /// Outside.
    Outside,
    /// On the curve, within the tolerance.
    On,
    /// Inside.
    Inside,
}

impl Curve {
    /// The area that a closed planar curve encloses, and its centroid.
    ///
    /// By Green's theorem: boundary integrals over the smooth pieces, exact for straight ones and to about 10⁻¹³
    /// for others. A curve that crosses itself counts parts by winding number.
    ///
    /// # Errors
    /// The curve is open, or no plane holds it within `tolerance`.
    pub fn area_and_centroid(&self, tolerance: f64) -> Result<(f64, Point3)> {
        if !self.is_closed() {
            return Err(Error::degenerate("curve", "it is open and encloses no area"));
        }
        let plane = self.plane(tolerance).ok_or(Error::degenerate("curve", "it is not planar"))?;
        let (signed, center) = self.signed_area_in(&plane);
        Ok((signed.abs(), center))
    }

    /// The area enclosed by the projection of a closed curve into a plane, positive when it runs counter-clockwise
    /// about the normal, and the centroid in the plane. Without area the centroid is that of the start.
    pub fn signed_area_in(&self, plane: &Plane) -> (f64, Point3) {
        // About a point of the curve, so that sums stay small far from the plane's origin.
        let local = plane.with_origin(plane.closest_point(self.start()));
        let size = self.hull_points().iter().map(|p| p.distance_to(local.origin)).fold(0.0, f64::max);
        let mut sums = [0.0; 3];
        for piece in self.pieces() {
            let part = match piece.shape {
                Shape::Segment(a, b) => {
                    let ([ax, ay, _], [bx, by, _]) = (local.coordinates(a), local.coordinates(b));
                    let cross = ax * by - bx * ay;
                    [0.5 * cross, cross * (ax + bx) / 6.0, cross * (ay + by) / 6.0]
                }
                _ => {
                    let (zx, zy) = (local.x_axis, local.y_axis);
                    let o = local.origin.to_vector();
                    let integrand = |u: f64| {
                        let [p, d, _] = piece.jet(u);
                        let (x, y) = ((p - o).dot(zx), (p - o).dot(zy));
                        let cross = x * d.dot(zy) - y * d.dot(zx);
                        [0.5 * cross, cross * x / 3.0, cross * y / 3.0]
                    };
                    let bound = MOMENT_BOUND * size * size * size.max(1.0);
                    integrate(&integrand, piece.own.start, piece.own.end, bound)
                }
            };
            sums = std::array::from_fn(|c| sums[c] + part[c]);
        }
        let [area, x, y] = sums;
        if area.abs() <= NO_AREA * size * size {
            return (area, local.origin);
        }
        (area, local.at(x / area, y / area, 0.0))
    }

    /// The area that a closed planar curve encloses with its centroid and moments, by Green's theorem to about 10⁻¹²;
    /// see [`Curve::area_and_centroid`].
    ///
    /// # Errors
    /// The curve is open or encloses nothing, or no plane holds it within `tolerance`.
    pub fn area_properties(&self, tolerance: f64) -> Result<MassProperties> {
        if !self.is_closed() {
            return Err(Error::degenerate("curve", "it is open and encloses no area"));
        }
        let plane = self.plane(tolerance).ok_or(Error::degenerate("curve", "it is not planar"))?;
        let bounds = self.bounding_box();
        let local = plane.with_origin(plane.closest_point(bounds.center()));
        let size = (0.5 * bounds.diagonal().length()).max(f64::MIN_POSITIVE);
        let mut flat = [0.0; 6];
        for piece in self.pieces() {
            let integrand = |u: f64| {
                let [p, d, _] = piece.jet(u);
                let p = (p - local.origin.to_vector()) / size;
                let (x, y) = (p.dot(local.x_axis), p.dot(local.y_axis));
                let (dx, dy) = (d.dot(local.x_axis) / size, d.dot(local.y_axis) / size);
                let cross = x * dy - y * dx;
                // By homogeneity: the integral of a form of degree k is that of itself times the cross product over
                // k + 2.
                [
                    cross / 2.0,
                    cross * x / 3.0,
                    cross * y / 3.0,
                    cross * x * x / 4.0,
                    cross * y * y / 4.0,
                    cross * x * y / 4.0,
                ]
            };
            let part = integrate(&integrand, piece.own.start, piece.own.end, MOMENT_BOUND);
            flat.iter_mut().zip(part).for_each(|(sum, v)| *sum += v);
        }
        let [area, x, y, xx, yy, xy] = flat;
        let (a, b) = (local.x_axis, local.y_axis);
        let first = a * x + b * y;
        let second =
            |p: [f64; 2], q: [f64; 2]| p[0] * q[0] * xx + p[1] * q[1] * yy + (p[0] * q[1] + p[1] * q[0]) * xy;
        let rows = [[a.x, b.x], [a.y, b.y], [a.z, b.z]];
        let integrals = [
            area,
            first.x,
            first.y,
            first.z,
            second(rows[0], rows[0]),
            second(rows[1], rows[1]),
            second(rows[2], rows[2]),
            second(rows[0], rows[1]),
            second(rows[1], rows[2]),
            second(rows[2], rows[0]),
        ];
        MassProperties::of_integrals(integrals, 0.0, local.origin, size, 2)
    }
}
