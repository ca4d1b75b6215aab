//! Dendro: solids as signed distances on a grid, put together, moved outwards and smoothed, and made meshes of.
//!
//! Names, ports and ids are facts from files. Distances are exact at the points of a grid, and the mesh is that of marching
//! cubes ([`katydid_geometry::isosurface`]); the plug-in's own library of sparse volumes is not used, so that meshes have other
//! vertices than its own.

mod combine;
mod convert;
#[cfg(test)]
mod tests;
mod volume;

use katydid_component::{Message, component};
use katydid_data::{Tree, Value};

use crate::kept::{keep, kept};

/// How geometry becomes a volume and back.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Settings {
    /// The distance between points of the grid.
    voxel: f64,
    /// How many of these the distances are known on each side of the surface.
    band: f64,
    /// The distance at which the surface lies, outwards positive.
    level: f64,
}

impl Settings {
    /// The settings in an item.
    ///
    /// # Errors
    /// It is none.
    fn of(value: &Value) -> Result<&Self, Message> {
        kept::<Self>(value).ok_or_else(|| Message::error("These are no settings of volumes"))
    }
}

/// Volumes on their way over wires. Stands for Dendro's parameter Volume.
#[component(
    "f363676f-3ae9-48ac-ab4d-258d8d09e2a7",
    name = "Volume",
    nick = "Volume",
    at = "Dendro/Parameters",
    floating
)]
#[output("Volume", "Volume", "The volumes.")]
fn volume_parameter(
    /// The volumes.
    #[port("Volume", "Volume", optional)]
    data: &Tree,
) -> Tree {
    data.clone()
}

/// Settings on their way over wires. Stands for Dendro's parameter Volume Settings.
#[component(
    "5fe922b3-f95c-4ea6-8f0a-e7bb961b4d90",
    name = "Volume Settings",
    nick = "Settings",
    at = "Dendro/Parameters",
    floating
)]
#[output("Volume Settings", "Settings", "The settings.")]
fn settings_parameter(
    /// The settings.
    #[port("Volume Settings", "Settings", optional)]
    data: &Tree,
) -> Tree {
    data.clone()
}

/// How geometry becomes a volume and back. The mesh of a volume is not made coarser where it is flat: Adaptivity is not
/// supported. Stands for Dendro's Create Settings; that the isovalue counts outwards is our reading.
#[component(
    "6db84a8d-28e4-4ebe-bf2f-c954caf319b9",
    name = "Create Settings",
    nick = "Settings",
    at = "Dendro/Settings"
)]
#[output("Volume Settings", "S", "The settings.", kind = Generic)]
fn create_settings(
    context: &katydid_component::Context<'_>,
    /// The distance between points of the grid, in units of the document.
    #[port("Voxel Size", "S", default = 1.0)]
    voxel: f64,
    /// How many voxels on each side of the surface the distances are known.
    #[port("Bandwidth", "B", default = 3.0)]
    band: f64,
    /// The distance at which the surface of the mesh lies, outwards positive.
    #[port("Isovalue", "I", default = 0.0)]
    level: f64,
    /// How much coarser flat parts become, from 0 to 1; not supported.
    #[port("Adaptivity", "A", default = 0.0)]
    adaptivity: f64,
) -> Result<Value, Message> {
    if !(voxel > 0.0 && voxel.is_finite()) {
        return Err(Message::error("The voxel size must be greater than 0"));
    }
    // Less than one voxel tells no sign beside the surface.
    if !(band >= 1.0 && band.is_finite()) {
        return Err(Message::error("The bandwidth must be at least 1"));
    }
    if !level.is_finite() {
        return Err(Message::error("The isovalue must be a number"));
    }
    if adaptivity != 0.0 {
        context.tell(Message::remark("Adaptivity is not supported: the mesh is as fine everywhere"));
    }
    Ok(keep(
        format!("Volume Settings (voxel {voxel}, band {band}, isovalue {level})"),
        Settings { voxel, band, level },
    ))
}
