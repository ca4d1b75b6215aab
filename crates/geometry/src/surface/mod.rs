//! Surfaces of every kind behind one type.

mod area;
mod bounds;
mod classify;
mod closest;
mod closest_cells;
mod closest_grid;
mod closest_local;
mod closest_patch;
mod closest_places;
mod closest_swept;
mod cone;
mod convert;
mod curvature;
mod cylinder;
mod edit;
mod evaluate;
mod finite;
mod foot;
pub(crate) mod geodesic;
mod inflection;
mod isocurve;
mod local_foot;
mod normal;
mod plane_surface;
mod recognise;
mod revolution;
mod round;
mod sphere;
mod sum;
mod thresholds;
mod torus;

pub use area::SurfaceArea;
pub use closest::{ClosestOnSurface, SurfacePoint};
pub use closest_local::SurfaceMinima;
pub use cone::Cone;
pub use curvature::{NormalSection, SurfaceCurvature};
pub use cylinder::Cylinder;
pub(crate) use foot::Foot;
pub use geodesic::Geodesic;
pub(crate) use local_foot::LocalFoot;
pub use plane_surface::PlaneSurface;
pub use revolution::RevolutionSurface;
pub(crate) use round::{Round, RoundForm};
pub use sphere::Sphere;
pub use sum::SumSurface;
pub use torus::Torus;

use crate::{Direction, Interval, NurbsSurface, Point3};

/// Any surface: a map from a rectangle of parameters, its domain in u and v, to points.
#[derive(Debug, Clone, PartialEq)]
pub enum Surface {
    /// A rectangle of a plane.
    Plane(PlaneSurface),
    /// All sums of a point of one curve and a point of another; extrusions are such.
    Sum(SumSurface),
    /// A curve turned about an axis.
    Revolution(RevolutionSurface),
    /// A NURBS surface.
    Nurbs(NurbsSurface),
}

impl Surface {
    /// The range of one parameter.
    pub fn domain(&self, direction: Direction) -> Interval {
        match self {
            Self::Plane(s) => s.domain(direction),
            Self::Sum(s) => s.domain(direction),
            Self::Revolution(s) => s.domain(direction),
            Self::Nurbs(s) => s.domain(direction),
        }
    }

    /// The point at (u, v). Outside the domain the nearest piece goes on by its own formula.
    pub fn point_at(&self, u: f64, v: f64) -> Point3 {
        match self {
            Self::Plane(s) => s.point_at(u, v),
            Self::Sum(s) => s.point_at(u, v),
            Self::Revolution(s) => s.point_at(u, v),
            Self::Nurbs(s) => s.point_at(u, v),
        }
    }
}

impl From<PlaneSurface> for Surface {
    fn from(s: PlaneSurface) -> Self {
        Self::Plane(s)
    }
}

impl From<SumSurface> for Surface {
    fn from(s: SumSurface) -> Self {
        Self::Sum(s)
    }
}

impl From<RevolutionSurface> for Surface {
    fn from(s: RevolutionSurface) -> Self {
        Self::Revolution(s)
    }
}

impl From<NurbsSurface> for Surface {
    fn from(s: NurbsSurface) -> Self {
        Self::Nurbs(s)
    }
}

impl From<Sphere> for Surface {
    fn from(s: Sphere) -> Self {
        Self::Revolution(s.to_revolution())
    }
}

impl From<Cylinder> for Surface {
    fn from(s: Cylinder) -> Self {
        Self::Revolution(s.to_revolution())
    }
}

impl From<Cone> for Surface {
    fn from(s: Cone) -> Self {
        Self::Revolution(s.to_revolution())
    }
}

impl From<Torus> for Surface {
    fn from(s: Torus) -> Self {
        Self::Revolution(s.to_revolution())
    }
}
