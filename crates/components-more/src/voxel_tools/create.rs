//! Create: empty grids, and geometry put into them.

use katydid_component::{Context, List, Message, component};
use katydid_data::{Geometry, Tree, Value};
use katydid_geometry::{Box3, Vector3};

use super::Voxels;

/// Holds grids of voxels. Stands for VoxelTools' parameter VoxelGrid.
#[component(
    "b68c9f85-6382-42dc-b8fc-48645cdc3fb7",
    name = "VoxelGrid",
    nick = "VoxelGrid",
    at = "VoxelTools/Create",
    floating
)]
#[output("VoxelGrid", "VoxelGrid", "The grids.")]
fn voxel_grid(
    /// The grids.
    #[port("VoxelGrid", "VoxelGrid", optional)]
    data: &Tree,
) -> Tree {
    data.clone()
}

/// An empty grid of the voxels that fit whole into a box, from its corner of least coordinates. Stands for VoxelTools' Create
/// VoxelGrid.
#[component(
    "623edb3b-0d3e-4ff6-a04a-20dcbd7e1ab5",
    name = "Create VoxelGrid",
    nick = "VoxGrid",
    at = "VoxelTools/Create"
)]
#[output("VoxelGrid", "VoxelGrid", "The grid.")]
fn create(
    context: &Context<'_>,
    /// The box; the grid lies along its plane.
    #[port("BoundingBox", "B")]
    frame: Box3,
    /// The size of a voxel along x, in units.
    #[port("SizeX", "X", default = 1.0)]
    x: f64,
    /// The size of a voxel along y, in units.
    #[port("SizeY", "Y", default = 1.0)]
    y: f64,
    /// The size of a voxel along z, in units.
    #[port("SizeZ", "Z", default = 1.0)]
    z: f64,
) -> Result<Value, Message> {
    Ok(Voxels::new(context, frame, Vector3::new(x, y, z))?.item())
}

/// Fills the voxels where geometry is. Stands for VoxelTools' VoxelateGeometry.
///
/// Solids fill the voxels whose centres are inside, curves and points those that they pass. With a distance all geometry fills
/// the voxels whose centres are at most so far away. That a solid is told by the centres is our reading: the plug-in's own
/// grids may be a voxel larger at the sides.
#[component(
    "81c39005-5aac-4d1b-8082-62cd25e0f596",
    name = "VoxelateGeometry",
    nick = "VoxGeo",
    at = "VoxelTools/Create"
)]
#[output("VoxelGrid", "VoxelGrid", "The grid with more voxels.")]
fn voxelate(
    context: &Context<'_>,
    /// Solids, meshes, surfaces, curves and points.
    #[port("Geometry", "G")]
    geometry: List<Geometry>,
    /// The grid.
    #[port("VoxelGrid", "VoxelGrid")]
    grid: Value,
    /// The greatest distance of a voxel's centre from the geometry, in units; 0 fills what is inside.
    #[port("Distance", "D", default = 0.0)]
    distance: f64,
) -> Result<Value, Message> {
    let mut voxels = Voxels::of(&grid)?.clone();
    if !(distance >= 0.0 && distance.is_finite()) {
        return Err(Message::error("The distance must be a number of at least 0"));
    }
    for Geometry(value) in geometry.present() {
        voxels.fill(context, &value, distance)?;
    }
    Ok(voxels.item())
}

/// A grid with the voxels of a list of Booleans; voxels beyond the list stay. Stands for VoxelTools' VoxelGrid From List.
#[component(
    "e487fe7b-0416-49f2-bdd3-fe6cb0938d25",
    name = "VoxelGrid From List",
    nick = "VGFromList",
    at = "VoxelTools/Analysis"
)]
#[output("Grid", "G", "The grid.")]
fn from_list(
    /// The grid whose voxels are set.
    #[port("Grid", "G")]
    grid: Value,
    /// Whether each voxel is full: along x first, then y, then z.
    #[port("Bool", "B")]
    full: List<bool>,
) -> Result<Value, Message> {
    let mut voxels = Voxels::of(&grid)?.clone();
    for (cell, full) in voxels.cells.iter_mut().zip(full.iter()) {
        *cell = full.unwrap_or(*cell);
    }
    Ok(voxels.item())
}
