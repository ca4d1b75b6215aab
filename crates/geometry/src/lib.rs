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
pub mod biarc;
mod bounding_box;
mod box3;
mod box_pairs;
mod box_tree;
pub mod brep;
mod cancellation;
mod catenary;
mod chart;
mod circle;
pub mod cloud;
pub mod construct;
mod curve;
pub mod drawing;
mod ellipse;
mod error;
pub mod explain;
pub mod field;
#[cfg(any(feature = "glam", feature = "nalgebra"))]
mod foreign;
mod hanging_chain;
mod hash;
pub mod intersect;
mod interval;
pub mod isoline;
pub mod isosurface;
#[cfg(feature = "lettering")]
pub mod lettering;
mod line;
mod linear;
mod longest_rectangle;
mod matrix;
mod mesh;
mod meshing;
mod moments;
pub mod morph;
mod nurbs;
mod offset;
mod parallel;
mod plane;
mod point;
mod point2;
mod polynomial;
mod pull;
mod quadrature;
mod quaternion;
mod rectangle;
pub mod region;
#[cfg(feature = "serde")]
mod serde_forms;
pub mod silhouette;
pub mod subd;
pub mod substrate;
mod surface;
mod swing;
mod tangent;
mod tangent_arc;
mod tangent_circle;
mod thresholds;
mod tolerance;
mod trace;
mod twisted_box;
mod units;
mod vector;
mod vector2;
mod xform;

pub use bounding_box::BoundingBox;
pub use box_pairs::BoxIndex;
pub use box3::Box3;
pub use brep::Brep;
pub use cancellation::{CancellationToken, Waiting};
pub use catenary::catenary;
pub use circle::{Arc, Circle};
pub use curve::{
    ArcCurve, ArcLength, ClosestOnCurve, Containment, Continuity, ContinuityTolerance, CornerPiece,
    CurvatureExtremum, CurvatureSample, Curve, CurvePoint, ExtensionStyle, JoinContinuity, LineCurve,
    PolyCurve, PolylineCurve, PolylineLimits, TweenMatch, connect_curves, curves_of_two_views, join_curves,
    regular_polygon,
};
pub use ellipse::Ellipse;
pub use error::{Error, Result};
pub use field::Field;
pub use hanging_chain::hanging_chain;
pub use interval::Interval;
pub use line::Line;
pub use longest_rectangle::longest_rectangle;
pub use matrix::{Matrix, RowReduction};
#[cfg(feature = "mesh-booleans")]
pub use mesh::Solid;
pub use mesh::{
    Decimation, GuideKind, Healing, Mesh, MeshClash, MeshEdge, MeshFace, MeshHit, MeshPoint, MeshSections,
    MeshTree, QuadOptions, RemeshOptions, Remeshed, Smoothing, SurfaceMeshing,
};
pub use meshing::{BrepMesh, FaceMesh, MeshPlan, MeshSettings};
pub use moments::MassProperties;
pub use nurbs::{
    Approximation, DeBoor, DeBoorStep, ExactCondition, KnotSpacing, LeastSquares, MAX_DEGREE, NurbsCurve,
    bezier_to_hermite, check_knots, clamped_uniform_knots, de_casteljau, hermite_to_bezier,
    periodic_uniform_knots, placed_knots, span_index,
};
pub use nurbs::{
    Direction, NurbsSurface, Quadrant, Side, SurfaceDerivatives, combined_curves, compatible_curves,
};
pub use offset::OffsetCorner;
pub use plane::{Plane, PlaneEquation};
pub use point::Point3;
pub use point2::Point2;
pub use pull::SurfaceProjection;
pub use quaternion::Quaternion;
pub use rectangle::Rectangle;
pub use surface::{
    ClosestOnSurface, Cone, Cylinder, Geodesic, NormalSection, PlaneSurface, RevolutionSurface, Sphere,
    SumSurface, Surface, SurfaceArea, SurfaceCurvature, SurfaceMinima, SurfacePoint, Torus,
};
pub use swing::{SwingArcs, swing_arcs};
pub use tangent_circle::touching_circle;
pub use tolerance::Tolerance;
pub use twisted_box::TwistedBox;
pub use units::Units;
pub use vector::Vector3;
pub use vector2::Vector2;
pub use xform::{AffineParts, Frustum, Xform};
