//! Curves made one by blends between their ends.

use super::Curve;
use crate::{Error, Result};

/// One curve of several, in their order and directions: from each end a blend ([`Curve::blend_to`] of continuity `order`
/// and one bulge) leads to the next start, and with `closed` from the last end to the first start. Ends that are
/// already within `tolerance` of each other are joined as they are.
///
/// # Errors
/// No curve, or as [`Curve::blend_to`].
pub fn connect_curves(
    curves: &[Curve],
    order: u8,
    closed: bool,
    bulge: f64,
    tolerance: f64,
) -> Result<Curve> {
    let mut parts: Vec<Curve> = Vec::with_capacity(2 * curves.len());
    let mut push = |curve: &Curve| match curve {
        Curve::Poly(c) => parts.extend_from_slice(c.segments()),
        other => parts.push(other.clone()),
    };
    for (i, curve) in curves.iter().enumerate() {
        push(curve);
        let next = match curves.get(i + 1) {
            Some(next) => next,
            None if closed => &curves[0],
            None => break,
        };
        let gap = curve.end().distance_to(next.start());
        if !(gap <= tolerance) {
            push(&curve.blend_to(next, [order; 2], [bulge; 2])?);
        }
    }
    if parts.is_empty() {
        return Err(Error::degenerate("curves to connect", "there are none"));
    }
    Ok(super::join::chained(parts, tolerance))
}

#[cfg(test)]
mod tests {
    use super::connect_curves;
    use crate::{Curve, Line, Point3};

    fn line(a: [f64; 2], b: [f64; 2]) -> Curve {
        Line::new(Point3::new(a[0], a[1], 0.0), Point3::new(b[0], b[1], 0.0)).into()
    }

    #[test]
    fn lines_become_one_curve() {
        let sides = [line([0.0, 0.0], [4.0, 0.0]), line([6.0, 2.0], [6.0, 6.0])];
        let straight = connect_curves(&sides, 0, false, 1.0, 1e-3).unwrap();
        assert!((straight.length() - (8.0 + 8f64.sqrt())).abs() < 1e-12);
        let smooth = connect_curves(&sides, 2, false, 1.0, 1e-3).unwrap();
        assert!(smooth.start() == sides[0].start() && smooth.end() == sides[1].end());
        let whole = connect_curves(&sides, 1, true, 1.0, 1e-3).unwrap();
        assert!(whole.is_closed());
        let touching = [line([0.0, 0.0], [4.0, 0.0]), line([4.0, 0.0], [4.0, 3.0])];
        assert_eq!(connect_curves(&touching, 2, false, 1.0, 1e-3).unwrap().length(), 7.0);
        assert!(connect_curves(&[], 1, false, 1.0, 1e-3).is_err());
        assert!(connect_curves(&sides, 3, false, 1.0, 1e-3).is_err());
    }
}
