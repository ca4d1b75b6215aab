//! Analysis: meshes, boxes, lists and numbers of grids.

use std::sync::Arc as Shared;

use katydid_component::{Context, Message, component};
use katydid_data::Value;
use katydid_geometry::isosurface::{Isosurfacing, ScalarGrid};
use katydid_geometry::{Box3, Interval, Mesh, Plane, Point3, Vector3, Xform};

use super::Voxels;
use crate::polygons::Polygons;

/// The most faces of a hull.
const MOST_FACES: usize = 20_000_000;

/// The four corners of the side of a cell across an axis, seen from outside against the clock.
fn side([i, j, k]: [usize; 3], axis: usize, up: bool) -> [[usize; 3]; 4] {
    let a = usize::from(up);
    let mut corners = match axis {
        0 => [[i + a, j, k], [i + a, j + 1, k], [i + a, j + 1, k + 1], [i + a, j, k + 1]],
        1 => [[i, j + a, k], [i, j + a, k + 1], [i + 1, j + a, k + 1], [i + 1, j + a, k]],
        _ => [[i, j, k + a], [i + 1, j, k + a], [i + 1, j + 1, k + a], [i, j + 1, k + a]],
    };
    if !up {
        corners.reverse();
    }
    corners
}

/// Sides of cells as a mesh.
fn mesh_of(
    context: &Context<'_>,
    voxels: &Voxels,
    sides: &[[[usize; 3]; 4]],
) -> Result<Shared<Mesh>, Message> {
    let mut numbers: std::collections::HashMap<[usize; 3], usize> = std::collections::HashMap::new();
    let mut polygons = Polygons::default();
    for corners in sides {
        let face = corners.iter().map(|corner| {
            let next = polygons.points.len();
            let number = *numbers.entry(*corner).or_insert(next);
            if number == next {
                polygons.points.push(voxels.at(corner.map(|x| x as f64)));
            }
            number
        });
        polygons.faces.push(face.collect());
    }
    Ok(Shared::new(polygons.to_mesh(context)?))
}

/// The outer sides of the full voxels as meshes: all, and those that look to each direction. Shadows in colours are not
/// supported. Stands for VoxelTools' VoxelGrid To Mesh Hull.
#[component(
    "2c2e9fb7-2018-4f5e-bda9-c56a171709f0",
    name = "VoxelGrid To Mesh Hull",
    nick = "VoxMesh",
    at = "VoxelTools/Analysis"
)]
#[output("Mesh", "M", "The hull.", kind = Mesh)]
#[output("+X", "+X", "The sides that look along x.", kind = Mesh)]
#[output("-X", "-X", "The sides that look against x.", kind = Mesh)]
#[output("+Y", "+Y", "The sides that look along y.", kind = Mesh)]
#[output("-Y", "-Y", "The sides that look against y.", kind = Mesh)]
#[output("+Z", "+Z", "The sides that look along z.", kind = Mesh)]
#[output("-Z", "-Z", "The sides that look against z.", kind = Mesh)]
fn mesh_hull(
    context: &Context<'_>,
    /// The grid.
    #[port("VoxelGrid", "VoxelGrid")]
    grid: Value,
    /// Whether the mesh has colours like shadows, which are not supported.
    #[port("Fake Shadow", "FS", default = false)]
    shadow: bool,
) -> Result<
    (Shared<Mesh>, Shared<Mesh>, Shared<Mesh>, Shared<Mesh>, Shared<Mesh>, Shared<Mesh>, Shared<Mesh>),
    Message,
> {
    let voxels = Voxels::of(&grid)?;
    if shadow {
        context.tell(Message::remark("Shadows in colours are not supported: the mesh has none"));
    }
    let mut groups: [Vec<[[usize; 3]; 4]>; 6] = std::array::from_fn(|_| Vec::new());
    let mut count = 0_usize;
    for (number, _) in voxels.cells.iter().enumerate().filter(|(_, full)| **full) {
        let place = voxels.place(number);
        for (group, (axis, up)) in
            groups.iter_mut().zip([(0, true), (0, false), (1, true), (1, false), (2, true), (2, false)])
        {
            if voxels.beside(place, axis, up) != Some(true) {
                group.push(side(place, axis, up));
                count += 1;
            }
        }
        if count > MOST_FACES {
            return Err(Message::error(format!("The hull has more than {MOST_FACES} faces")));
        }
    }
    context.bytes(count.saturating_mul(200))?;
    let all: Vec<[[usize; 3]; 4]> = groups.concat();
    let [px, mx, py, my, pz, mz] = groups;
    let mesh = |sides: &[[[usize; 3]; 4]]| mesh_of(context, voxels, sides);
    Ok((mesh(&all)?, mesh(&px)?, mesh(&mx)?, mesh(&py)?, mesh(&my)?, mesh(&pz)?, mesh(&mz)?))
}

/// A smooth hull of the full voxels by marching cubes: their centres count 1, those of empty ones 0. Stands for VoxelTools'
/// Hull from Marching Cubes.
#[component(
    "9c588056-00e3-4899-805d-8aeccf05e03e",
    name = "Hull from Marching Cubes",
    nick = "VGMarchingCubes",
    at = "VoxelTools/Analysis"
)]
#[output("Mesh", "M", "The hull.")]
fn marching_cubes(
    context: &Context<'_>,
    /// The grid.
    #[port("Grids", "G")]
    grid: Value,
    /// Where the hull lies between centres, from 0 to 1: at 0.5 it is half way.
    #[port("Isolevel", "I", default = 0.5)]
    level: f64,
) -> Result<Shared<Mesh>, Message> {
    /// At 0 and 1 the hull would lie in the centres: it keeps this far off.
    const OFF: f64 = 1e-3;
    let voxels = Voxels::of(&grid)?;
    if !level.is_finite() {
        return Err(Message::error("The level is not finite"));
    }
    let padded = voxels.counts.map(|n| n + 2);
    let total = padded.iter().fold(1_usize, |product, n| product.saturating_mul(*n));
    context.bytes(total.saturating_mul(8))?;
    let mut values = vec![0.0; total];
    for (number, _) in voxels.cells.iter().enumerate().filter(|(_, full)| **full) {
        let [i, j, k] = voxels.place(number).map(|n| n + 1);
        if let Some(value) = values.get_mut(i + padded[0] * (j + padded[1] * k)) {
            *value = 1.0;
        }
    }
    let Box3 { x, y, z, plane } = &voxels.frame;
    let corner = Point3::new(x.min(), y.min(), z.min());
    let scalars = ScalarGrid::new(corner - voxels.size * 0.5, voxels.size, padded)?;
    let how = Isosurfacing { level: level.clamp(OFF, 1.0 - OFF), closed: false, most_faces: MOST_FACES };
    let mesh = scalars.isosurface(&values, &how)?;
    Ok(Shared::new(mesh.transformed(&Xform::plane_to_world(plane))?))
}

/// The full voxels as boxes, and the centres of all voxels. Stands for VoxelTools' VoxelGrid To Boxes.
#[component(
    "d8f14822-91e4-417a-931c-a42455a07361",
    name = "VoxelGrid To Boxes",
    nick = "VoxBox",
    at = "VoxelTools/Analysis"
)]
#[output("Boxes", "BOX", "A box for each full voxel.")]
#[output("Points", "PTS", "The centres of all voxels.")]
fn boxes(
    context: &Context<'_>,
    /// The grid.
    #[port("VoxelGrid", "VoxelGrid")]
    grid: Value,
) -> Result<(Vec<Box3>, Vec<Point3>), Message> {
    let voxels = Voxels::of(&grid)?;
    context.items(voxels.full())?;
    context.items(voxels.cells.len())?;
    let half = |size: f64| Interval::new(-size / 2.0, size / 2.0);
    let Vector3 { x, y, z } = voxels.size;
    let full = voxels.cells.iter().enumerate().filter(|(_, full)| **full);
    let boxes = full.map(|(number, _)| Box3 {
        plane: Plane { origin: voxels.centre(voxels.place(number)), ..voxels.frame.plane },
        x: half(x),
        y: half(y),
        z: half(z),
    });
    let points = (0..voxels.cells.len()).map(|number| voxels.centre(voxels.place(number)));
    Ok((boxes.collect(), points.collect()))
}

/// Whether each voxel is full, and its centre: along x first, then y, then z. Stands for VoxelTools' VoxelGridToList.
#[component(
    "1fd64427-290e-4cb7-9512-69acc62e5256",
    name = "VoxelGridToList",
    nick = "VGList",
    at = "VoxelTools/Analysis"
)]
#[output("Bool", "B", "Whether each voxel is full.")]
#[output("Pts", "P", "The centre of each voxel.")]
fn to_list(
    context: &Context<'_>,
    /// The grid.
    #[port("Grids", "G")]
    grid: Value,
) -> Result<(Vec<bool>, Vec<Point3>), Message> {
    let voxels = Voxels::of(&grid)?;
    context.items(voxels.cells.len().saturating_mul(2))?;
    let points = (0..voxels.cells.len()).map(|number| voxels.centre(voxels.place(number)));
    Ok((voxels.cells.clone(), points.collect()))
}

/// The size of a voxel, and the numbers of voxels along the axes. Stands for VoxelTools' VoxelGrid Dimensions.
#[component(
    "3123e7dd-38f8-4050-a31a-03524b21776a",
    name = "VoxelGrid Dimensions",
    nick = "VGDimensions",
    at = "VoxelTools/Analysis"
)]
#[output("Voxelsize", "S", "The sides of a voxel, as a point.")]
#[output("Voxelcount", "C", "The numbers of voxels, as a point.")]
fn dimensions(
    /// The grid.
    #[port("Grids", "G")]
    grid: Value,
) -> Result<(Point3, Point3), Message> {
    let voxels = Voxels::of(&grid)?;
    let [x, y, z] = voxels.counts.map(|n| n as f64);
    Ok((Point3::ORIGIN + voxels.size, Point3::new(x, y, z)))
}

/// Counts of voxels and of their outer sides. Stands for VoxelTools' VoxelGrid Statistics.
#[component(
    "19412cc0-e6fc-4d89-ba7c-70d1dc23ad33",
    name = "VoxelGrid Statistics",
    nick = "VoxGridStat",
    at = "VoxelTools/Analysis"
)]
#[output("Surfaces", "S", "All outer sides.")]
#[output("Facade", "F", "The outer sides that stand upright.")]
#[output("Terraces", "T", "The outer sides that look up.")]
#[output("Overhang", "O", "The outer sides that look down inside the grid.")]
#[output("Footprint", "Fp", "The outer sides at the bottom of the grid.")]
#[output("VoxelCount", "Vc", "The full voxels.")]
#[output("VoidCount", "VoC", "The empty voxels.")]
#[output("Porosity", "P", "The area of all outer sides by the volume of the full voxels.")]
fn statistics(
    /// The grid.
    #[port("VoxelGrid", "VoxelGrid")]
    grid: Value,
) -> Result<(f64, f64, f64, f64, f64, f64, f64, f64), Message> {
    let voxels = Voxels::of(&grid)?;
    let Vector3 { x, y, z } = voxels.size;
    let [mut facade, mut terraces, mut overhang, mut footprint, mut area] = [0.0; 5];
    for (number, _) in voxels.cells.iter().enumerate().filter(|(_, full)| **full) {
        let place = voxels.place(number);
        for (axis, side) in [(0, y * z), (1, x * z), (2, x * y)] {
            for up in [false, true] {
                let beside = voxels.beside(place, axis, up);
                if beside == Some(true) {
                    continue;
                }
                area += side;
                *match (axis, up, beside) {
                    (0 | 1, ..) => &mut facade,
                    (_, true, _) => &mut terraces,
                    (_, false, Some(_)) => &mut overhang,
                    (_, false, None) => &mut footprint,
                } += 1.0;
            }
        }
    }
    let full = voxels.full() as f64;
    let volume = full * x * y * z;
    let porosity = if volume > 0.0 { area / volume } else { 0.0 };
    let surfaces = facade + terraces + overhang + footprint;
    let empty = voxels.cells.len() as f64 - full;
    Ok((surfaces, facade, terraces, overhang, footprint, full, empty, porosity))
}
