//! The functions of RhinoCommon that clients call by path: `curve/getlength-curve_double` and so on.
//!
//! [`Endpoints`] is a table. Its paths and the names of their parameters are those of `signatures.txt`; what each one
//! does is a plain function of typed arguments, entered in the table by the module of its class. Decoding, encoding,
//! faults, help pages and the choice among overloads follow from the types, and no function does any of it by itself.

mod answer;
mod argument;
mod brep;
mod brep_boolean;
mod brep_cut;
mod brep_face;
mod brep_make;
mod brep_mend;
mod brep_sweep;
mod call;
mod choice;
mod class;
mod curve;
mod curve_edit;
mod curve_ends;
mod curve_length;
mod curve_local;
mod curve_make;
mod curve_onto;
mod curve_region;
mod function;
mod geometry_base;
mod help;
mod intersection;
mod intersection_mesh;
mod intersection_ray;
mod mass;
mod member;
mod mesh;
mod mesh_edit;
mod mesh_make;
mod mesh_mend;
mod mesh_pieces;
mod mesh_round;
mod nurbs_curve;
mod nurbs_edit;
mod nurbs_surface;
mod query;
mod smoothing;
mod subd;
mod surface;
mod surface_curve;
mod surface_edit;
mod table;

pub use argument::Waiting;
pub use call::CallReply;
pub use class::{change_in_place, changes_in_place};
pub use member::MemberReply;
pub use query::Query;
pub use table::Endpoints;

/// The table that all calls share.
pub fn endpoints() -> &'static Endpoints {
    table::endpoints()
}
