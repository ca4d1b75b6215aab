//! The kernel: points, vectors, planes, transforms, curves, meshes; construct, evaluate, measure, intersect.
//!
//! Everything here is a pure function on `f64`: no files, no graphs, no globals, and no threads besides
//! `rayon` behind the `parallel` feature. Angles are radians, systems are right-handed with z up, vectors are
//! columns, and every tolerance is an argument ([`Tolerance`]). Knot vectors follow openNURBS: their length is
//! control points + degree − 1. Bad input is an [`Error`] that names it; NaN and infinity are refused.
//!
//! ```
//! use katydid_geometry::{Point3, Vector3};
//! let tip = Point3::new(1.0, 2.0, 3.0) + Vector3::new(2.0, 2.0, 2.0);
//! assert_eq!(tip, Point3::new(3.0, 4.0, 5.0));
//! ```
//!
//! A curve is a [`Curve`] whatever it is made of:
//!
//! ```
//! use katydid_geometry::{Circle, Curve, Plane};
//! # fn main() -> katydid_geometry::Result<()> {
//! let circle: Curve = Circle::new(Plane::XY, 2.0)?.into();
//! let parameters = circle.divide_by_count(4)?;
//! assert_eq!(parameters.len(), 4); // closed: the seam counts once
//! assert!((circle.curvature_at(parameters[1]).length() - 0.5).abs() < 1e-12);
//! # Ok(())
//! # }
//! ```

#![allow(
    clippy::needless_range_loop,
    clippy::neg_cmp_op_on_partial_ord,
    reason = "matrix code reads best with indices; !(x > limit) is how a NaN is refused together with the too small"
)]

mod bernstein;
mod bounding_box;
mod box3;
mod circle;
mod curve;
mod ellipse;
mod error;
pub mod intersect;
mod interval;
mod line;
mod linear;
mod matrix;
mod mesh;
mod nurbs;
mod plane;
mod point;
mod polynomial;
mod quadrature;
mod rectangle;
mod tangent;
mod tolerance;
mod units;
mod vector;
mod xform;

pub use bounding_box::BoundingBox;
pub use box3::Box3;
pub use circle::{Arc, Circle};
pub use curve::{
    ArcCurve, ArcLength, Containment, Continuity, ContinuityTolerance, CornerPiece, CurvatureExtremum, Curve,
    CurvePoint, ExtensionStyle, JoinContinuity, LineCurve, OffsetCorner, PolyCurve, PolylineCurve,
    PolylineLimits, TweenMatch, compatible_curves, join_curves,
};
pub use ellipse::Ellipse;
pub use error::{Error, Result};
pub use interval::Interval;
pub use line::Line;
pub use matrix::Matrix;
pub use mesh::{Mesh, MeshEdge, MeshFace, MeshPoint};
pub use nurbs::{
    Approximation, DeBoor, DeBoorStep, ExactCondition, KnotSpacing, LeastSquares, MAX_DEGREE, NurbsCurve,
    bezier_to_hermite, check_knots, clamped_uniform_knots, de_casteljau, hermite_to_bezier,
    periodic_uniform_knots, placed_knots, span_index,
};
pub use nurbs::{Direction, NurbsSurface, Quadrant, SurfaceDerivatives};
pub use plane::Plane;
pub use point::Point3;
pub use rectangle::{Rectangle, regular_polygon};
pub use tolerance::Tolerance;
pub use units::Units;
pub use vector::Vector3;
pub use xform::Xform;
