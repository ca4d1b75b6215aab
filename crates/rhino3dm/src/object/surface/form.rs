//! Surfaces as archives have them: every number of the class, whether the kernel takes it or not.

use katydid_geometry::{
    BoundingBox, Direction, Error as Refusal, Interval, Line, Plane, PlaneSurface, RevolutionSurface,
    SumSurface, Surface, Vector3,
};

use super::NurbsSurfaceForm;
use crate::class_object::UserData;
use crate::object::curve::SPACE;
use crate::object::{CurveForm, is_frame};

type Kernel<T> = katydid_geometry::Result<T>;

/// A surface with all that archives say of it: its dimension, a box, and numbers that make no surface for the kernel.
#[derive(Debug, Clone, PartialEq)]
pub enum SurfaceForm {
    /// A rectangle of a plane.
    Plane {
        /// The plane.
        plane: Plane,
        /// The last number of its equation, where it is not the one that follows from the plane.
        offset: Option<f64>,
        /// The parameters in u and v.
        domains: [Interval; 2],
        /// The ranges of the plane's coordinates that they stand for.
        extents: [Interval; 2],
    },
    /// All sums of a point of one curve and a point of another.
    Sum {
        /// What is added to the sum.
        shift: Vector3,
        /// A box around it, if one was stored.
        bounds: Option<BoundingBox>,
        /// The curves along u and v.
        curves: Box<[CurveForm; 2]>,
    },
    /// A curve turned about an axis.
    Revolution {
        /// The axis.
        axis: Line,
        /// The angles between which the curve is turned, in radians.
        angle: Interval,
        /// The parameters of those angles.
        domain: Interval,
        /// A box around it, if one was stored.
        bounds: Option<BoundingBox>,
        /// Whether the angle runs along v.
        transposed: bool,
        /// The curve.
        profile: Option<Box<CurveForm>>,
    },
    /// A NURBS surface.
    Nurbs(NurbsSurfaceForm),
    /// A surface inside another object with user data of its own.
    Tagged {
        /// The surface.
        surface: Box<SurfaceForm>,
        /// The user data.
        user_data: Vec<UserData>,
    },
}

impl SurfaceForm {
    /// The form that a surface of the kernel has.
    pub fn of(surface: &Surface) -> Self {
        match surface {
            Surface::Plane(s) => Self::Plane {
                plane: *s.plane(),
                offset: None,
                domains: Direction::BOTH.map(|d| s.domain(d)),
                extents: s.extents(),
            },
            Surface::Sum(s) => {
                let curves = s.curves().each_ref().map(|curve| CurveForm::of(curve, SPACE));
                Self::Sum { shift: s.shift(), bounds: None, curves: Box::new(curves) }
            }
            Surface::Revolution(s) => {
                let along = s.angle_direction();
                Self::Revolution {
                    axis: s.axis(),
                    angle: s.angle(),
                    domain: s.domain(along),
                    bounds: None,
                    transposed: along == Direction::V,
                    profile: Some(Box::new(CurveForm::of(s.profile(), SPACE))),
                }
            }
            Surface::Nurbs(s) => Self::Nurbs(NurbsSurfaceForm::of(s)),
        }
    }

    /// The surface as the kernel has it.
    ///
    /// # Errors
    /// The kernel refuses its numbers.
    pub fn to_surface(&self) -> Kernel<Surface> {
        let surface = self.unchecked()?;
        surface.check_finite()?;
        Ok(surface)
    }

    fn unchecked(&self) -> Kernel<Surface> {
        Ok(match self {
            Self::Plane { plane, domains, extents, .. } => {
                if !is_frame(plane) {
                    return Err(Refusal::Degenerate {
                        what: "plane of the surface",
                        why: "its axes are not square",
                    });
                }
                PlaneSurface::with_domains(*plane, *extents, *domains)?.into()
            }
            Self::Sum { shift, curves, .. } => {
                let [first, second] = curves.as_ref();
                SumSurface::new(first.to_curve()?, second.to_curve()?, *shift)?.into()
            }
            Self::Revolution { axis, angle, domain, transposed, profile, .. } => {
                let profile = profile
                    .as_ref()
                    .ok_or(Refusal::Degenerate { what: "surface of revolution", why: "it has no profile" })?;
                let surface = RevolutionSurface::with_domain(profile.to_curve()?, *axis, *angle, *domain)?;
                if *transposed { surface.transposed() } else { surface }.into()
            }
            Self::Nurbs(form) => form.to_surface()?.into(),
            Self::Tagged { surface, .. } => surface.unchecked()?,
        })
    }

    /// The surface, and this form again where the surface alone would be written as another.
    pub(crate) fn split(self) -> (Option<Surface>, Option<Self>) {
        let surface = self.to_surface().ok();
        let same = surface.as_ref().is_some_and(|surface| Self::of(surface) == self);
        (surface, (!same).then_some(self))
    }
}
