//! The same surface in another place, direction or domain, and parts of it.

use super::{PlaneSurface, SumSurface, Surface};
use crate::thresholds;
use crate::{Direction, Error, Interval, Result, Vector3, Xform};

impl Surface {
    /// The same points with u and v exchanged; the normal turns over.
    #[must_use]
    pub fn transposed(&self) -> Self {
        match self {
            Self::Plane(s) => s.transposed().into(),
            Self::Sum(s) => s.transposed().into(),
            Self::Revolution(s) => s.transposed().into(),
            Self::Nurbs(s) => s.transposed().into(),
        }
    }

    /// The same points with one direction walked backwards; its domain a…b becomes −b…−a, as in openNURBS, and the
    /// normal turns over.
    #[must_use]
    pub fn reversed(&self, direction: Direction) -> Self {
        match self {
            Self::Plane(s) => s.reversed(direction).into(),
            Self::Sum(s) => {
                let [a, b] = s.curves();
                let curve = if direction == Direction::U { a } else { b };
                s.with_curve(direction, curve.reversed()).into()
            }
            Self::Revolution(s) => s.reversed(direction).into(),
            Self::Nurbs(s) => s.reversed(direction).into(),
        }
    }

    /// The part over a range of one parameter, with its part of the domain.
    ///
    /// # Errors
    /// The range does not increase or leaves the domain.
    pub fn trimmed(&self, direction: Direction, range: Interval) -> Result<Self> {
        let domain = self.domain(direction);
        let (a, b) = (range.start, range.end);
        if !(a < b && domain.start <= a && b <= domain.end) {
            return Err(Error::Invalid {
                what: "trim range",
                why: format!("{a} to {b} is not an increasing part of {} to {}", domain.start, domain.end),
            });
        }
        if range == domain {
            return Ok(self.clone());
        }
        Ok(match self {
            Self::Plane(s) => s.part(direction, range)?.into(),
            Self::Sum(s) => {
                let curve = &s.curves()[direction.index()];
                s.with_curve(direction, curve.trimmed(range)?).into()
            }
            Self::Revolution(s) if direction == s.angle_direction() => s.between(range)?.into(),
            Self::Revolution(s) => s.with_profile(s.profile().trimmed(range)?).into(),
            Self::Nurbs(s) => s.trimmed(direction, range)?.into(),
        })
    }

    /// The part over two ranges of parameters.
    ///
    /// # Errors
    /// As [`Surface::trimmed`].
    pub fn sub_surface(&self, u: Interval, v: Interval) -> Result<Self> {
        self.trimmed(Direction::U, u)?.trimmed(Direction::V, v)
    }

    /// The same closed surface with its seam in one direction at parameter `t`; the domain becomes t…t + period.
    ///
    /// # Errors
    /// The surface is not closed in the direction, or `t` is outside its domain.
    pub fn with_seam(&self, direction: Direction, t: f64) -> Result<Self> {
        let domain = self.domain(direction);
        if !domain.contains(t) {
            return Err(Error::OutOfRange { what: "seam", value: t, must: "inside the surface's domain" });
        }
        if !self.is_closed(direction) {
            return Err(Error::degenerate("surface", "it is not closed in the direction of the new seam"));
        }
        if t == domain.start || t == domain.end {
            return Ok(self.clone());
        }
        match self {
            Self::Plane(_) => Ok(self.clone()),
            Self::Sum(s) => {
                let curve = s.curves()[direction.index()].with_seam(t)?;
                Ok(s.with_curve(direction, curve).into())
            }
            Self::Revolution(s) if direction == s.angle_direction() => Ok(s.started_at(t)?.into()),
            Self::Revolution(s) => Ok(s.with_profile(s.profile().with_seam(t)?).into()),
            Self::Nurbs(s) => Ok(s.with_seam(direction, t)?.into()),
        }
    }

    /// The parts before and after a parameter of one direction.
    ///
    /// # Errors
    /// The parameter is not inside the domain.
    pub fn split(&self, direction: Direction, t: f64) -> Result<(Self, Self)> {
        let domain = self.domain(direction);
        Ok((
            self.trimmed(direction, Interval::new(domain.start, t))?,
            self.trimmed(direction, Interval::new(t, domain.end))?,
        ))
    }

    /// The same surface over another domain in one direction; the parameter is mapped linearly.
    ///
    /// # Errors
    /// The domain does not increase, or is too small to hold the surface's own parameters apart.
    pub fn with_domain(&self, direction: Direction, domain: Interval) -> Result<Self> {
        if !domain.is_increasing() {
            return Err(Error::Invalid {
                what: "domain",
                why: format!("{} to {} does not increase", domain.start, domain.end),
            });
        }
        Ok(match self {
            Self::Plane(s) => s.over_domain(direction, domain)?.into(),
            Self::Sum(s) => {
                let curve = &s.curves()[direction.index()];
                s.with_curve(direction, curve.with_domain(domain)?).into()
            }
            Self::Revolution(s) if direction == s.angle_direction() => s.over_angle_domain(domain)?.into(),
            Self::Revolution(s) => s.with_profile(s.profile().with_domain(domain)?).into(),
            Self::Nurbs(s) => s.with_domain(direction, domain)?.into(),
        })
    }

    /// The exact image. Planes and surfaces of revolution keep their kind under similarities, sums under affine
    /// maps; otherwise the image is a NURBS surface.
    ///
    /// # Errors
    /// A number overflows, or a projective map sends part of the surface to infinity.
    pub fn transformed(&self, xform: &Xform) -> Result<Self> {
        if !xform.is_finite() {
            return Err(Error::NotFinite("transform"));
        }
        let similarity = xform.similarity_factor(thresholds::ROUNDING).filter(|f| f.abs() > 0.0);
        match (self, similarity) {
            (Self::Plane(s), Some(factor)) => {
                let scaled = |r: Interval| Interval::new(r.start * factor.abs(), r.end * factor.abs());
                let plane = s.plane().transformed(xform)?;
                let domains = Direction::BOTH.map(|d| s.domain(d));
                Ok(PlaneSurface::with_domains(plane, s.extents().map(scaled), domains)?.into())
            }
            (Self::Revolution(s), Some(factor)) => Ok(s.similar(xform, factor < 0.0)?.into()),
            (Self::Sum(s), _) if xform.is_affine() => {
                let [a, b] = s.curves();
                // The images of the curves are moved twice, the sum only once.
                let moved = Vector3::new(xform.rows[0][3], xform.rows[1][3], xform.rows[2][3]);
                let shift = xform.vector(s.shift()) - moved;
                Ok(SumSurface::new(a.transformed(xform)?, b.transformed(xform)?, shift)?.into())
            }
            (Self::Nurbs(s), _) => Ok(s.transformed(xform)?.into()),
            _ => Ok(self.to_nurbs()?.transformed(xform)?.into()),
        }
    }
}
