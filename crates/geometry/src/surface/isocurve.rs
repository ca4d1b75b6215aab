//! Curves of one constant parameter.

use super::Surface;
use crate::{Curve, Direction, Error, Line, LineCurve, Result, Side, Vector3, Xform};

impl Surface {
    /// The curve along which `direction` varies, over its domain, while the other parameter stays at `constant`: a
    /// line, arc or profile where the surface has such, else a NURBS curve; exact in all cases.
    ///
    /// # Errors
    /// `constant` is not a finite number, or the curve is a single point on the axis of a surface of revolution.
    pub fn isocurve(&self, direction: Direction, constant: f64) -> Result<Curve> {
        if !constant.is_finite() {
            return Err(Error::NotFinite("isocurve parameter"));
        }
        let domain = self.domain(direction);
        match self {
            Self::Plane(s) => {
                let at = |t: f64| match direction {
                    Direction::U => s.point_at(t, constant),
                    Direction::V => s.point_at(constant, t),
                };
                Ok(LineCurve { line: Line::new(at(domain.start), at(domain.end)), domain }.into())
            }
            Self::Sum(s) => {
                let [a, b] = s.curves();
                let (moving, still) = if direction == Direction::U { (a, b) } else { (b, a) };
                let by: Vector3 = still.point_at(constant).to_vector() + s.shift();
                moving.transformed(&Xform::translation(by))
            }
            Self::Revolution(s) => {
                if direction == s.angle_direction() {
                    s.parallel(constant)
                } else {
                    s.profile_at(constant)
                }
            }
            Self::Nurbs(s) => Ok(s.isocurve(direction, constant)?.into()),
        }
    }

    /// The curve along one side of the domain.
    ///
    /// # Errors
    /// The side is a single point on the axis of a surface of revolution.
    pub fn side_curve(&self, side: Side) -> Result<Curve> {
        let (along, at_end) = side.along();
        let across = self.domain(along.other());
        self.isocurve(along, if at_end { across.end } else { across.start })
    }
}
