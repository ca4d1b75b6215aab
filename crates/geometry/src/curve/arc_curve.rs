use crate::thresholds;
use std::f64::consts::TAU;

use crate::{Arc, Circle, Interval, NurbsCurve, Point3, Result};

/// An arc or full circle as a curve. A full circle is the arc whose angle is 2π.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ArcCurve {
    /// The arc.
    pub arc: Arc,
    /// The parameters of its ends; increasing. The parameter is proportional to the angle.
    pub domain: Interval,
}

impl ArcCurve {
    /// The arc over 0…arc length, as Grasshopper gives it.
    pub fn new(arc: Arc) -> Self {
        let length = (arc.circle.radius * arc.angle.length()).abs();
        let end = if length > 0.0 && length.is_finite() { length } else { 1.0 };
        Self { arc, domain: Interval::new(0.0, end) }
    }

    /// Whether the arc is a full circle.
    pub fn is_circle(&self) -> bool {
        (self.arc.angle.length().abs() - TAU).abs() <= thresholds::WHOLE_TURN
    }

    /// The angle in radians at parameter `t`.
    #[inline]
    pub fn angle_at(&self, t: f64) -> f64 {
        self.arc.angle.at(self.domain.normalized(t))
    }

    /// The point at parameter `t`; beyond the domain it goes on around the circle.
    #[inline]
    pub fn point_at(&self, t: f64) -> Point3 {
        self.arc.circle.at(self.angle_at(t))
    }

    /// The exact NURBS form over the same domain. Only at the joints of spans and halfway between them do equal
    /// parameters give equal points.
    ///
    /// # Errors
    /// As [`Arc::to_nurbs`].
    pub fn to_nurbs(&self) -> Result<NurbsCurve> {
        self.arc.to_nurbs(self.domain)
    }
}

impl From<Arc> for ArcCurve {
    fn from(arc: Arc) -> Self {
        Self::new(arc)
    }
}

impl From<Circle> for ArcCurve {
    fn from(circle: Circle) -> Self {
        Self::new(Arc { circle, angle: Interval::new(0.0, TAU) })
    }
}
