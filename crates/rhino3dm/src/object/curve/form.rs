//! Curves as archives have them: every number of the class, whether the kernel takes it or not.

use katydid_geometry::{Arc, ArcCurve, Curve, Interval, Line, LineCurve, PolyCurve, PolylineCurve};
use katydid_geometry::{Error as Refusal, Point3};

use super::{CurveOnSurface, NurbsForm};
use crate::class_object::UserData;
use crate::object::is_frame;

type Kernel<T> = katydid_geometry::Result<T>;

/// A curve with all that archives say of it: its dimension (2 in a parameter plane, else 3), flags, and numbers that
/// make no curve for the kernel.
#[derive(Debug, Clone, PartialEq)]
pub enum CurveForm {
    /// A straight segment.
    Line {
        /// From where to where.
        line: Line,
        /// The parameters of its ends.
        domain: Interval,
        /// 2 or 3.
        dimension: i32,
    },
    /// An arc or a full circle.
    Arc {
        /// Circle and angles.
        arc: Arc,
        /// The last number of the equation of the circle's plane, where it is not the one that follows from the
        /// plane.
        offset: Option<f64>,
        /// The parameters of its ends.
        domain: Interval,
        /// 2 or 3.
        dimension: i32,
    },
    /// A chain of straight segments.
    Polyline {
        /// The vertices.
        points: Vec<Point3>,
        /// The parameter of each.
        parameters: Vec<f64>,
        /// 2 or 3.
        dimension: i32,
    },
    /// A NURBS curve.
    Nurbs(NurbsForm),
    /// Curves end to end.
    Poly {
        /// The curves.
        segments: Vec<CurveForm>,
        /// The parameters of their joints, and of both ends.
        parameters: Vec<f64>,
    },
    /// A curve in the parameter plane of a surface, seen in space.
    OnSurface(Box<CurveOnSurface>),
    /// A curve inside another object with user data of its own.
    Tagged {
        /// The curve.
        curve: Box<CurveForm>,
        /// The user data.
        user_data: Vec<UserData>,
    },
}

impl CurveForm {
    /// The form that a curve of the kernel has, in a dimension of 2 or 3.
    pub fn of(curve: &Curve, dimension: i32) -> Self {
        match curve {
            Curve::Line(c) => Self::Line { line: c.line, domain: c.domain, dimension },
            Curve::Arc(c) => Self::Arc { arc: c.arc, offset: None, domain: c.domain, dimension },
            Curve::Polyline(c) => {
                Self::Polyline { points: c.points().to_vec(), parameters: c.parameters().to_vec(), dimension }
            }
            Curve::Nurbs(c) => Self::Nurbs(NurbsForm::of(c, dimension)),
            Curve::Poly(c) => super::poly::form_of(c, dimension),
        }
    }

    /// The curve as the kernel has it. One of dimension 2 lies at z = 0.
    ///
    /// # Errors
    /// The kernel refuses its numbers, or has no such curve.
    pub fn to_curve(&self) -> Kernel<Curve> {
        let curve = self.unchecked()?;
        curve.check_finite()?;
        Ok(curve)
    }

    fn unchecked(&self) -> Kernel<Curve> {
        Ok(match self {
            Self::Line { line, domain, dimension } => {
                let line = Line::new(lowered(line.from, *dimension), lowered(line.to, *dimension));
                LineCurve { line, domain: checked(*domain)? }.into()
            }
            Self::Arc { arc, domain, .. } => arc_curve(*arc, *domain)?.into(),
            Self::Polyline { points, parameters, dimension } => {
                let points = points.iter().map(|p| lowered(*p, *dimension)).collect();
                PolylineCurve::with_parameters(points, parameters.clone())?.into()
            }
            Self::Nurbs(form) => form.to_curve()?.into(),
            Self::Poly { segments, parameters } => {
                let segments = segments.iter().map(Self::unchecked).collect::<Kernel<_>>()?;
                PolyCurve::with_parameters(segments, parameters.clone())?.into()
            }
            Self::OnSurface(_) => return Err(Refusal::Unsupported("curves on surfaces")),
            Self::Tagged { curve, .. } => curve.unchecked()?,
        })
    }

    /// The curve, and this form again where the curve alone would be written as another.
    pub(crate) fn split(self, dimension: i32) -> (Option<Curve>, Option<Self>) {
        let curve = self.to_curve().ok();
        let same = curve.as_ref().is_some_and(|curve| Self::of(curve, dimension) == self);
        (curve, (!same).then_some(self))
    }

    /// The parameters of its ends.
    pub fn domain(&self) -> Interval {
        let ends = |numbers: &[f64]| match (numbers.first(), numbers.last()) {
            (Some(&a), Some(&b)) => Interval::new(a, b),
            _ => Interval::UNIT,
        };
        match self {
            Self::Line { domain, .. } | Self::Arc { domain, .. } => *domain,
            Self::Polyline { parameters, .. } | Self::Poly { parameters, .. } => ends(parameters),
            Self::Nurbs(form) => form.domain(),
            Self::OnSurface(curve) => curve.flat.domain(),
            Self::Tagged { curve, .. } => curve.domain(),
        }
    }
}

/// A point of a curve of dimension 2 has no third coordinate, whatever is stored.
fn lowered(p: Point3, dimension: i32) -> Point3 {
    if dimension == 2 && p.z != 0.0 { Point3::new(p.x, p.y, 0.0) } else { p }
}

fn checked(domain: Interval) -> Kernel<Interval> {
    if domain.is_increasing() {
        return Ok(domain);
    }
    Err(Refusal::Invalid {
        what: "domain of a curve",
        why: format!("{} to {} does not increase", domain.start, domain.end),
    })
}

fn arc_curve(arc: Arc, domain: Interval) -> Kernel<ArcCurve> {
    let radius = arc.circle.radius;
    if !(radius.is_finite() && radius > 0.0) {
        return Err(Refusal::OutOfRange { what: "radius", value: radius, must: "greater than 0" });
    }
    if !is_frame(&arc.circle.plane) {
        return Err(Refusal::Degenerate { what: "plane of the arc", why: "its axes are not square" });
    }
    let angle = arc.angle.length();
    if !(arc.angle.start.is_finite() && angle > 0.0 && angle <= std::f64::consts::TAU + 1e-9) {
        return Err(Refusal::OutOfRange { what: "angle of the arc", value: angle, must: "at most a turn" });
    }
    Ok(ArcCurve { arc, domain: checked(domain)? })
}
