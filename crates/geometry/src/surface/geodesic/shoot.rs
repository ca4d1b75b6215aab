//! Straight walks on surfaces.

use super::Unrolled;
use crate::surface::thresholds::NO_DETERMINANT;
use crate::thresholds;
use crate::{Point3, Vector3};

/// Where a straight walk on a surface ends.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Shot {
    /// The point.
    pub(crate) point: Point3,
    /// The unit direction across the walk there, in the surface: normal × direction of the walk.
    pub(crate) across: Option<Vector3>,
}

/// Steps of a walk; the error falls with the fourth power of their number.
const STEPS: usize = 64;

/// Walks straight on, as a geodesic, from a place in a direction for a distance. `None` when the walk leaves the surface
/// over a side, or comes to where the surface has no tangent plane.
///
/// The equation S_u u″ + S_v v″ + S_uu u′² + 2 S_uv u′v′ + S_vv v′² ⟂ S_u, S_v by the Runge–Kutta method of order 4
/// (M. do Carmo, *Differential Geometry of Curves and Surfaces*, §4-4).
pub(crate) fn shot(sheet: &Unrolled<'_>, from: [f64; 2], direction: Vector3, distance: f64) -> Option<Shot> {
    let speed = direction.with_length(distance)?;
    let jet = sheet.jet(from, 1);
    let [du, dv] = components(jet.get(1, 0), jet.get(0, 1), speed)?;
    let mut x = [from[0], from[1], du, dv];
    let h = 1.0 / STEPS as f64;
    let add = |x: &[f64; 4], k: &[f64; 4], s: f64| -> [f64; 4] { std::array::from_fn(|i| x[i] + s * k[i]) };
    for _ in 0..STEPS {
        let k1 = slope(sheet, &x)?;
        let k2 = slope(sheet, &add(&x, &k1, 0.5 * h))?;
        let k3 = slope(sheet, &add(&x, &k2, 0.5 * h))?;
        let k4 = slope(sheet, &add(&x, &k3, h))?;
        x = std::array::from_fn(|i| x[i] + h / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]));
        if !x.iter().all(|x| x.is_finite()) {
            return None;
        }
        if sheet.is_outside([x[0], x[1]]) {
            // To rounding it may still be on the side.
            let slack = (0..2).all(|d| {
                let domain = sheet.domains[d];
                sheet.closed[d]
                    || (x[d] - domain.clamp(x[d])).abs() <= thresholds::SAME_PARAMETER * domain.length()
            });
            if !slack {
                return None;
            }
        }
    }
    let place = [x[0], x[1]];
    let jet = sheet.jet(place, 1);
    let (su, sv) = (jet.get(1, 0), jet.get(0, 1));
    let across = su.cross(sv).cross(su * x[2] + sv * x[3]).unitized();
    Some(Shot { point: jet.point(), across })
}

/// A vector of the tangent plane by its parts along Su and Sv.
fn components(su: Vector3, sv: Vector3, v: Vector3) -> Option<[f64; 2]> {
    let (e, f, g) = (su.length_squared(), su.dot(sv), sv.length_squared());
    let determinant = e * g - f * f;
    if !(determinant > NO_DETERMINANT * e * g) || determinant == 0.0 {
        return None;
    }
    let (a, b) = (v.dot(su), v.dot(sv));
    Some([(a * g - b * f) / determinant, (b * e - a * f) / determinant])
}

fn slope(sheet: &Unrolled<'_>, x: &[f64; 4]) -> Option<[f64; 4]> {
    let jet = sheet.jet([x[0], x[1]], 2);
    let (a, b) = (x[2], x[3]);
    let bend = jet.get(2, 0) * (a * a) + jet.get(1, 1) * (2.0 * a * b) + jet.get(0, 2) * (b * b);
    let [ddu, ddv] = components(jet.get(1, 0), jet.get(0, 1), -bend)?;
    Some([a, b, ddu, ddv])
}
