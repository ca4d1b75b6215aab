//! Where things meet: lines and planes in closed form, curves and surfaces by subdivision with bounds.

mod analytic;
mod closed_forms;
mod clusters;
mod curve_curve;
mod curve_plane;
mod curve_surface;
mod fold;
mod judge;
mod lines;
mod mesh_mesh;
mod nearest;
mod patch_tree;
mod reader;
mod result;
mod search;
mod side;
mod surface_kinds;
mod surface_plane;
mod surface_surface;
mod thresholds;
mod tree;
pub(crate) mod zeros;

pub use analytic::{
    ArcArc, CircleCircle, LineCircleHit, LineCylinder, PlaneCircle, SphereSection, UpToTwo, arc_arc,
    circle_circle, line_arc, line_bounding_box, line_box, line_circle, line_cylinder, line_sphere, plane_arc,
    plane_circle, plane_sphere, sphere_sphere,
};
pub use closed_forms::{Axis, Carrier, CarrierCurve, CarrierMeeting, Conic, carrier_carrier};
pub use curve_curve::{curve_curve, curve_self};
pub use curve_plane::{PlaneIntersections, curve_plane};
pub(crate) use curve_surface::curve_surface_within;
pub use curve_surface::{SurfaceCrossing, SurfaceIntersections, SurfaceOverlap, curve_surface};
pub use lines::{line_line, line_plane, plane_plane, three_planes};
pub use mesh_mesh::{mesh_mesh, mesh_mesh_segments};
pub use nearest::{NearestPair, nearest_on_curves, nearest_to_shape};
pub use result::{ContactKind, Crossing, CurveIntersections, Overlap};
pub use surface_kinds::curve_with_surface;
pub(crate) use surface_kinds::curve_with_surface_within;
pub use surface_plane::{SurfaceSection, surface_plane};
pub(crate) use surface_surface::common;
pub use surface_surface::{
    BranchKind, SurfaceBranch, SurfaceContact, SurfaceContactKind, SurfaceMeeting, surface_self,
    surface_surface, surface_with_surface,
};
