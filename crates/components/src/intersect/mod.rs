//! The Intersect tab.

mod breps;
mod collision;
mod contour;
mod mathematical;
mod mesh_boolean;
mod meshes;
mod physical;
mod piercing;
pub(crate) mod planes;
mod region;
mod region_breps;
mod shape;
mod slits;
mod solids;
mod split;
mod view;

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message};
use katydid_geometry::{Curve, Plane};

/// Whether a curve ends where it starts, within the tolerance.
fn closes(curve: &Curve, tolerance: f64) -> bool {
    let meets = || curve.start().distance_to(curve.end()) <= tolerance && !matches!(curve, Curve::Line(_));
    curve.is_closed() || meets()
}

/// The closed curves of a list. Nulls are skipped; open curves too, with a warning.
fn closed_curves(context: &Context<'_>, name: &str, list: &List<'_, Shared<Curve>>) -> Vec<Curve> {
    let mut open = 0;
    let mut out = Vec::new();
    for curve in list.iter().flatten() {
        if closes(&curve, context.tolerance().absolute) {
            out.push(Curve::clone(&curve));
        } else {
            open += 1;
        }
    }
    match open {
        0 => {}
        1 => context.warn(format!("A curve of {name} is open and was left out")),
        n => context.warn(format!("{n} curves of {name} are open and were left out")),
    }
    out
}

/// The plane given, else the plane of the first planar curve, else the one that fits all of them best; in both cases
/// with the normal upwards.
fn plane_of<'a>(
    context: &Context<'_>,
    plane: Option<Plane>,
    curves: impl Iterator<Item = &'a Curve> + Clone,
) -> Result<Plane, Message> {
    if let Some(plane) = plane {
        return Ok(plane);
    }
    let tolerance = context.tolerance().absolute;
    let flat = curves.clone().filter(|c| !c.is_linear(tolerance)).find_map(|c| c.plane(tolerance));
    let found = match flat {
        Some(plane) => plane,
        None => {
            let points: Vec<_> = curves.flat_map(Curve::hull_points).collect();
            Plane::fit(&points).map_err(|e| Message::warning(e.to_string()))?.0
        }
    };
    let z = found.z_axis;
    let down = z.z < 0.0 || (z.z == 0.0 && (z.y < 0.0 || (z.y == 0.0 && z.x < 0.0)));
    Ok(if down { Plane { y_axis: -found.y_axis, z_axis: -z, ..found } } else { found })
}
