//! Boolean: grids as sets of voxels.

use katydid_component::{List, Message, component};
use katydid_data::Value;

use super::Voxels;

/// The first grid, changed by each of the others, voxel by voxel.
fn merged(grids: &List<'_, Value>, merge: impl Fn(bool, bool) -> bool) -> Result<Value, Message> {
    let mut grids = grids.present();
    let first = grids.next().ok_or_else(|| Message::warning("There is no grid"))?;
    let mut result = Voxels::of(&first)?.clone();
    for grid in grids {
        let other = Voxels::of(&grid)?;
        if other.counts != result.counts {
            return Err(Message::error("The grids have different numbers of voxels"));
        }
        for (own, other) in result.cells.iter_mut().zip(&other.cells) {
            *own = merge(*own, *other);
        }
    }
    Ok(result.item())
}

/// The voxels that any grid has. Stands for VoxelTools' VoxelGrid Boolean Union.
#[component(
    "89bf7550-970b-492d-bddc-334028f60efc",
    name = "VoxelGrid Boolean Union",
    nick = "VGUnion",
    at = "VoxelTools/Boolean"
)]
#[output("Grids", "G", "The grid.")]
fn union(
    /// Grids with the same numbers of voxels.
    #[port("Grids", "G")]
    grids: List<Value>,
) -> Result<Value, Message> {
    merged(&grids, |a, b| a || b)
}

/// The voxels that all grids have. Stands for VoxelTools' VoxelGrid Boolean Intersect.
#[component(
    "c30ffc42-2b0f-4f88-a1f2-84e4a510a006",
    name = "VoxelGrid Boolean Intersect",
    nick = "VGIntersect",
    at = "VoxelTools/Boolean"
)]
#[output("Grids", "G", "The grid.")]
fn intersect(
    /// Grids with the same numbers of voxels.
    #[port("Grids", "G")]
    grids: List<Value>,
) -> Result<Value, Message> {
    merged(&grids, |a, b| a && b)
}

/// The voxels of the first grid that no other has. Stands for VoxelTools' VoxelGrid Boolean Subtract.
#[component(
    "6ac05026-bba2-4fbd-abeb-ac868e99d96e",
    name = "VoxelGrid Boolean Subtract",
    nick = "VGSubtract",
    at = "VoxelTools/Boolean"
)]
#[output("Grids", "G", "The grid.")]
fn subtract(
    /// Grids with the same numbers of voxels.
    #[port("Grids", "G")]
    grids: List<Value>,
) -> Result<Value, Message> {
    merged(&grids, |a, b| a && !b)
}

/// The voxels that an odd number of grids has: of two, those that only one has. Stands for VoxelTools' VoxelGrid Boolean
/// Exclusive.
#[component(
    "aa68e498-45e7-44be-b8f8-34bdf5f52ead",
    name = "VoxelGrid Boolean Exclusive",
    nick = "VGExclusive",
    at = "VoxelTools/Boolean"
)]
#[output("Grids", "G", "The grid.")]
fn exclusive(
    /// Grids with the same numbers of voxels.
    #[port("Grids", "G")]
    grids: List<Value>,
) -> Result<Value, Message> {
    merged(&grids, |a, b| a != b)
}

/// Full voxels become empty and empty ones full. Stands for VoxelTools' VoxelGrid Boolean Invert.
#[component(
    "0cb9d055-2ae4-4b00-8b55-558c22175933",
    name = "VoxelGrid Boolean Invert",
    nick = "VGInvert",
    at = "VoxelTools/Boolean"
)]
#[output("Grids", "G", "The grid.")]
fn invert(
    /// The grid.
    #[port("Grids", "G")]
    grid: Value,
) -> Result<Value, Message> {
    let mut voxels = Voxels::of(&grid)?.clone();
    for cell in &mut voxels.cells {
        *cell = !*cell;
    }
    Ok(voxels.item())
}
