//! Whether surfaces hold only numbers.

use super::Surface;
use crate::{Direction, Error, Result};

impl Surface {
    /// Whether all that it holds is finite: points, weights, knots, planes, axes and angles, and the lengths of its
    /// domains.
    pub fn is_finite(&self) -> bool {
        self.non_finite_part().is_none()
    }

    /// Refuses a surface that holds a number that is not finite.
    ///
    /// # Errors
    /// [`Error::NotFinite`] with the name of what is not.
    pub fn check_finite(&self) -> Result<()> {
        self.non_finite_part().map_or(Ok(()), |what| Err(Error::NotFinite(what)))
    }

    /// The name of what is not finite.
    fn non_finite_part(&self) -> Option<&'static str> {
        let domains = Direction::BOTH.map(|d| self.domain(d));
        if !domains.iter().all(|domain| domain.is_finite() && domain.length().is_finite()) {
            return Some("domain of a surface");
        }
        let (what, finite) = match self {
            Self::Plane(s) => (
                "plane of a surface",
                s.plane().is_finite() && s.extents().iter().all(|range| range.is_finite()),
            ),
            Self::Sum(s) => {
                ("curve of a sum surface", s.shift().is_finite() && s.curves().iter().all(|c| c.is_finite()))
            }
            Self::Revolution(s) => {
                let finite = s.axis().is_finite() && s.angle().is_finite() && s.profile().is_finite();
                ("axis, angle or profile of a surface of revolution", finite)
            }
            Self::Nurbs(s) => {
                let finite = s.homogeneous_points().iter().flatten().all(|x| x.is_finite())
                    && Direction::BOTH.iter().all(|&d| s.knots(d).iter().all(|t| t.is_finite()));
                ("control point, weight or knot of a surface", finite)
            }
        };
        (!finite).then_some(what)
    }
}
