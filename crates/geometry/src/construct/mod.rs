//! Surfaces and solids from points, curves and faces.
//!
//! Every function gives sound breps ([`Brep::is_valid`](crate::Brep::is_valid)) or says why not. Lines, arcs and
//! other conics stay exact wherever the construction allows it.

mod baseball;
mod box_slits;
mod developable;
mod edge_surface;
mod extrude;
mod fragment;
mod loft;
mod network;
mod offset;
mod patch;
mod primitives;
mod revolve;
mod sweep;
mod tapered;
mod thresholds;
mod walls;

pub use baseball::baseball_sphere;
pub use box_slits::{SlitBox, box_slits};
pub use developable::{DevelopableLoft, DevelopableOptions, developable_loft};
pub use edge_surface::{edge_surface, four_point_surface};
pub use extrude::{
    extrude, extrude_along, extrude_brep, extrude_brep_along, extrude_brep_to_point, extrude_to_point,
};
pub use fragment::fragment_patch;
pub use loft::{LoftOptions, LoftStyle, loft, ruled};
pub use network::network_surface;
pub use offset::{offset_brep, offset_surface, offset_surface_loosely, offset_surface_variably};
pub use patch::{PatchOptions, patch};
pub use primitives::{box_brep, cone, cylinder, plane_surface, quad_sphere, sphere, torus};
pub use revolve::{rail_revolve, revolve};
pub use sweep::{Miter, PipeCap, SweepFrame, SweepOptions, pipe, pipe_variable, sweep_one, sweep_two};
pub use tapered::extrude_angled;

use crate::{Curve, Error, Result, Tolerance};

/// Refuses curves and tolerances that no construction can work with.
fn check(curves: &[&Curve], tolerance: &Tolerance) -> Result<f64> {
    for curve in curves {
        let domain = curve.domain();
        if !(domain.is_increasing() && domain.is_finite()) {
            return Err(Error::Invalid {
                what: "curve",
                why: format!("its domain {} to {} does not increase", domain.start, domain.end),
            });
        }
        if !curve.hull_points().iter().all(|p| p.is_finite()) {
            return Err(Error::NotFinite("curve"));
        }
    }
    tolerance.positive_distance()
}

/// The plane of a closed curve, for a cap.
fn cap_plane(profile: &Curve, limit: f64) -> Result<crate::Plane> {
    if !profile.is_closed() {
        return Err(Error::degenerate("profile", "it is open, and has no caps"));
    }
    profile.plane(limit).ok_or(Error::degenerate("profile", "it is not planar, and has no caps"))
}
