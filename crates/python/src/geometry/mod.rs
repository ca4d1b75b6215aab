//! Geometry as Python holds it: thin classes over the kernel's types, which are shared and never change.

mod brep;
mod brep_solid;
mod construct;
mod cuboid;
mod curve;
mod curve_edit;
mod curve_make;
mod interval;
mod mesh;
mod mesh_edit;
mod plane;
mod point;
mod repr;
mod state;
mod subd;
mod surface;
mod transform;
mod vector;

pub(crate) use brep::Brep;
pub(crate) use construct::{
    cone, cylinder, extrude, intersect, loft, pipe, planar_faces, revolve, sphere, sweep, torus,
};
pub(crate) use cuboid::{BoundingBox, Box};
pub(crate) use curve::Curve;
pub(crate) use interval::{Interval, IntervalLike};
pub(crate) use mesh::Mesh;
pub(crate) use plane::{Plane, PlaneLike};
pub(crate) use point::{Point, PointLike};
pub(crate) use state::{rebuild, subd_value};
pub(crate) use subd::SubD;
pub(crate) use surface::Surface;
pub(crate) use transform::Transform;
pub(crate) use vector::{Vector, VectorLike};

use katydid_geometry::Tolerance;

/// The tolerance of a call: what it names, and what a definition gets when nobody says otherwise.
pub(crate) fn tolerance(absolute: f64) -> Tolerance {
    Tolerance { absolute, ..Tolerance::default() }
}
