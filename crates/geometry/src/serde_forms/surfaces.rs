//! Surfaces of all kinds.

use serde::{Deserialize, Serialize};

use super::curves::WrittenControls;
use super::{Form, structure, through_forms};
use crate::nurbs::Controls;
use crate::{
    Cone, Curve, Cylinder, Direction, Interval, Line, NurbsSurface, Plane, PlaneSurface, Point3, Result,
    RevolutionSurface, Sphere, SumSurface, Surface, Torus, Vector3,
};

structure!(Sphere { plane: Plane, radius: f64 } | s | Sphere::new(s.plane, s.radius).map(drop));
structure!(
    Cylinder { plane: Plane, radius: f64, height: Interval } | c | {
        Cylinder::new(c.plane, c.radius, c.height).map(drop)
    }
);
structure!(
    Cone { plane: Plane, height: f64, radius: f64 } | c | Cone::new(c.plane, c.height, c.radius).map(drop)
);
structure!(
    Torus { plane: Plane, major_radius: f64, minor_radius: f64 } | t | {
        Torus::new(t.plane, t.major_radius, t.minor_radius).map(drop)
    }
);

/// A NURBS surface: pairs for u and v, v running fastest among the control points, knots in the openNURBS form.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(unreachable_pub, reason = "an associated type needs it")]
pub struct WrittenNurbsSurface {
    degrees: [usize; 2],
    counts: [usize; 2],
    knots: [Vec<f64>; 2],
    controls: WrittenControls,
}

impl Form for NurbsSurface {
    type Written = WrittenNurbsSurface;
    fn written(&self) -> WrittenNurbsSurface {
        let controls = match &self.controls {
            Controls::Plain(p) => WrittenControls::Plain(p.clone()),
            Controls::Rational(p) => WrittenControls::Rational(p.clone()),
        };
        let (degrees, counts) = (self.degrees(), self.counts());
        WrittenNurbsSurface { degrees, counts, knots: self.knots.clone(), controls }
    }
    fn read(w: WrittenNurbsSurface) -> Result<Self> {
        match w.controls {
            WrittenControls::Plain(p) => {
                let points = p.into_iter().map(Point3::from).collect();
                Self::new(w.degrees, w.counts, points, w.knots)
            }
            WrittenControls::Rational(p) => Self::rational(w.degrees, w.counts, p, w.knots),
        }
    }
}

/// A rectangle of a plane.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(unreachable_pub, reason = "an associated type needs it")]
pub struct WrittenPlaneSurface {
    plane: Plane,
    extents: [Interval; 2],
    domains: [Interval; 2],
}

impl Form for PlaneSurface {
    type Written = WrittenPlaneSurface;
    fn written(&self) -> WrittenPlaneSurface {
        let domains = Direction::BOTH.map(|d| self.domain(d));
        WrittenPlaneSurface { plane: *self.plane(), extents: self.extents(), domains }
    }
    fn read(w: WrittenPlaneSurface) -> Result<Self> {
        Self::with_domains(w.plane, w.extents, w.domains)
    }
}

/// All sums of points of two curves, moved.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(unreachable_pub, reason = "an associated type needs it")]
pub struct WrittenSum {
    curves: [Curve; 2],
    shift: Vector3,
}

impl Form for SumSurface {
    type Written = WrittenSum;
    fn written(&self) -> WrittenSum {
        WrittenSum { curves: self.curves().clone(), shift: self.shift() }
    }
    fn read(w: WrittenSum) -> Result<Self> {
        let [first, second] = w.curves;
        Self::new(first, second, w.shift)
    }
}

/// A profile turned about an axis; transposed when the angle is v.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(unreachable_pub, reason = "an associated type needs it")]
pub struct WrittenRevolution {
    profile: Curve,
    axis: Line,
    angle: Interval,
    domain: Interval,
    transposed: bool,
}

impl Form for RevolutionSurface {
    type Written = WrittenRevolution;
    fn written(&self) -> WrittenRevolution {
        WrittenRevolution {
            profile: self.profile().clone(),
            axis: self.axis(),
            angle: self.angle(),
            domain: self.domain(self.angle_direction()),
            transposed: self.angle_direction() == Direction::V,
        }
    }
    fn read(w: WrittenRevolution) -> Result<Self> {
        let surface = Self::with_domain(w.profile, w.axis, w.angle, w.domain)?;
        Ok(if w.transposed { surface.transposed() } else { surface })
    }
}

/// Any surface by its kind.
#[derive(Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[allow(unreachable_pub, reason = "an associated type needs it")]
pub enum WrittenSurface {
    /// A rectangle of a plane.
    Plane(PlaneSurface),
    /// A sum of curves.
    Sum(SumSurface),
    /// A surface of revolution.
    Revolution(RevolutionSurface),
    /// A NURBS surface.
    Nurbs(NurbsSurface),
}

impl Form for Surface {
    type Written = WrittenSurface;
    fn written(&self) -> WrittenSurface {
        match self.clone() {
            Self::Plane(s) => WrittenSurface::Plane(s),
            Self::Sum(s) => WrittenSurface::Sum(s),
            Self::Revolution(s) => WrittenSurface::Revolution(s),
            Self::Nurbs(s) => WrittenSurface::Nurbs(s),
        }
    }
    fn read(w: WrittenSurface) -> Result<Self> {
        Ok(match w {
            WrittenSurface::Plane(s) => Self::Plane(s),
            WrittenSurface::Sum(s) => Self::Sum(s),
            WrittenSurface::Revolution(s) => Self::Revolution(s),
            WrittenSurface::Nurbs(s) => Self::Nurbs(s),
        })
    }
}

through_forms!(NurbsSurface, PlaneSurface, SumSurface, RevolutionSurface, Surface);
