//! The components themselves: a folder a tab, a file a panel, a function a component.
//!
//! Geometry of more than a few lines belongs in `katydid-geometry`, where a Rust user finds it too. A program
//! that wants the components in its registry calls [`link`].

#![allow(
    clippy::neg_cmp_op_on_partial_ord,
    clippy::type_complexity,
    reason = "!(x > limit) refuses a NaN with the too small; a component's signature spells out its outputs"
)]

mod curve;
mod display;
mod intersect;
mod maths;
mod mesh;
mod params;
mod prepared;
mod rhino;
mod sets;
mod surface;
mod transform;
mod unsupported;
mod vector;

/// Makes sure that the components are linked into the program, with those that stand for plug-ins', and tells how many
/// there are.
///
/// ```
/// assert!(katydid_components::link() > 100);
/// ```
pub fn link() -> usize {
    katydid_components_more::link();
    katydid_component::registry::count()
}
