//! Conversion: volumes of meshes, curves and points, and meshes of volumes.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_data::Value;
use katydid_geometry::{BoundingBox, Containment, Curve, Mesh, MeshTree, Point3};

use super::Settings;
use super::volume::Volume;

/// A solid as signed distances. A mesh that is not closed has no inside: it is refused. Stands for Dendro's Mesh to Volume.
#[component(
    "d6403738-1061-47a6-b143-1f9cd72d8188",
    name = "Mesh to Volume",
    nick = "m2v",
    at = "Dendro/Convert"
)]
#[output("Volume", "V", "The volume.", kind = Generic)]
fn mesh_to_volume(
    context: &Context<'_>,
    /// The mesh, closed.
    #[port("Mesh", "M")]
    mesh: &Mesh,
    /// How it becomes a volume.
    #[port("Settings", "S", kind = Generic)]
    settings: Value,
) -> Result<Value, Message> {
    let settings = Settings::of(&settings)?;
    if !mesh.is_closed() {
        return Err(Message::error("An open mesh has no inside"));
    }
    let band = settings.band * settings.voxel;
    let bounds = mesh.bounding_box().ok_or_else(|| Message::error("The mesh has no vertices"))?;
    let mut volume = Volume::outside(context, &bounds.inflated(band), settings.voxel, band)?;
    let tree = MeshTree::new(mesh);
    let voxel = settings.voxel;
    // Nearer than this a point is on the mesh, whichever side is told.
    let near = voxel * 1e-9;
    volume.fill(context, |volume, [j, k], row| {
        // From a point to the next, as far apart as a voxel, no surface is passed that is farther than that.
        let (mut inside, mut far) = (false, false);
        for (i, distance) in row.iter_mut().enumerate() {
            let place = volume.point([i, j, k]);
            let size = tree.closest(place)?.distance;
            if !far {
                inside = matches!(tree.containment(place, near), Containment::Inside);
            }
            far = size > voxel;
            *distance = if inside { -size } else { size };
        }
        Ok(())
    })?;
    Ok(volume.item())
}

/// Adds balls about points.
fn balls(
    context: &Context<'_>,
    points: &[Point3],
    radii: &[f64],
    settings: &Settings,
) -> Result<Value, Message> {
    let (Some(last), false) = (radii.last(), points.is_empty()) else {
        return Err(Message::error("There are no points, or no radius"));
    };
    if radii.iter().any(|r| !(*r > 0.0 && r.is_finite())) || points.iter().any(|p| !p.is_finite()) {
        return Err(Message::error("Radii must be greater than 0, and points finite"));
    }
    let band = settings.band * settings.voxel;
    let largest = radii.iter().copied().fold(0.0, f64::max);
    let bounds = BoundingBox::from_points(points.iter().copied())
        .ok_or_else(|| Message::error("There are no points"))?
        .inflated(band + largest);
    let mut volume = Volume::outside(context, &bounds, settings.voxel, band)?;
    for (number, centre) in points.iter().enumerate() {
        context.check()?;
        let radius = radii.get(number).unwrap_or(last);
        let reach = radius + band;
        let around = [centre.x, centre.y, centre.z];
        let range = |axis: usize| {
            let first = volume.first[axis];
            let from = ((around[axis] - reach) / settings.voxel).floor() as i64 - first;
            let to = ((around[axis] + reach) / settings.voxel).ceil() as i64 - first;
            let count = volume.counts[axis];
            let inside = |n: i64| usize::try_from(n.max(0)).unwrap_or(0);
            inside(from).min(count)..inside(to.saturating_add(1)).min(count)
        };
        let (xs, ys, zs) = (range(0), range(1), range(2));
        for k in zs {
            for j in ys.clone() {
                for i in xs.clone() {
                    let place = volume.number([i, j, k]);
                    let distance = volume.point([i, j, k]).distance_to(*centre) - radius;
                    if let Some(known) = volume.distances.get_mut(place) {
                        *known = known.min(distance.max(-band));
                    }
                }
            }
        }
    }
    Ok(volume.item())
}

/// Balls about points as one volume; the last radius is that of all further points. Stands for Dendro's Points To Volume.
#[component(
    "fe8d2a29-8f2b-4952-ad70-bf8d3c23427a",
    name = "Points To Volume",
    nick = "p2v",
    at = "Dendro/Convert"
)]
#[output("Volume", "V", "The volume.", kind = Generic)]
fn points_to_volume(
    context: &Context<'_>,
    /// The points.
    #[port("Points", "P")]
    points: List<Point3>,
    /// The radius about each.
    #[port("Point Radius", "R", default = 1.0)]
    radii: List<f64>,
    /// How they become a volume.
    #[port("Settings", "S", kind = Generic)]
    settings: List<Value>,
) -> Result<Value, Message> {
    let settings = settings.iter().flatten().next().ok_or_else(|| Message::error("There are no settings"))?;
    let points: Vec<Point3> = points.iter().flatten().collect();
    let radii: Vec<f64> = radii.iter().flatten().collect();
    balls(context, &points, &radii, Settings::of(&settings)?)
}

/// Pipes about curves as one volume: balls so close along each that the pipe is round to a thousandth of the radius. Stands for
/// Dendro's Curve to Volume; its id is not known, it is found by its name.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd001",
    name = "Curve to Volume",
    nick = "c2v",
    at = "Dendro/Convert"
)]
#[output("Volume", "V", "The volume.", kind = Generic)]
fn curve_to_volume(
    context: &Context<'_>,
    /// The curves.
    #[port("Curves", "C")]
    curves: List<Shared<Curve>>,
    /// The radius about each.
    #[port("Curve Radius", "R", default = 1.0)]
    radii: List<f64>,
    /// How they become a volume.
    #[port("Settings", "S", kind = Generic)]
    settings: List<Value>,
) -> Result<Value, Message> {
    /// Balls this part of a radius apart leave dents of s²/8 of the radius: a thousandth.
    const SPACING: f64 = 0.09;
    let settings = settings.iter().flatten().next().ok_or_else(|| Message::error("There are no settings"))?;
    let radii: Vec<f64> = radii.iter().flatten().collect();
    let last = *radii.last().ok_or_else(|| Message::error("There is no radius"))?;
    let (mut points, mut sizes) = (Vec::new(), Vec::new());
    for (number, curve) in curves.iter().flatten().enumerate() {
        let radius = radii.get(number).copied().unwrap_or(last);
        if !(radius > 0.0 && radius.is_finite()) {
            return Err(Message::error("Radii must be greater than 0"));
        }
        let count = (curve.length() / (radius * SPACING)).ceil().max(1.0);
        if !(count < 1e7) {
            return Err(Message::error("A curve is too long for its radius"));
        }
        context.bytes(count as usize * 32)?;
        let domain = curve.domain();
        for n in 0..=count as usize {
            let along = curve
                .parameter_at_normalized_length(n as f64 / count)
                .unwrap_or_else(|| domain.at(n as f64 / count));
            points.push(curve.point_at(along));
            sizes.push(radius);
        }
    }
    balls(context, &points, &sizes, Settings::of(&settings)?)
}

/// The mesh of a volume's surface. Stands for Dendro's Volume to Mesh.
#[component(
    "858d89ff-5854-4e5f-aeb2-0e43e580835e",
    name = "Volume to Mesh",
    nick = "v2m",
    at = "Dendro/Convert"
)]
#[output("Mesh", "M", "The mesh, closed, with triangles.")]
fn volume_to_mesh(
    /// The volume.
    #[port("Volume", "V", kind = Generic)]
    volume: Value,
    /// The isovalue is taken from here; the grid is that of the volume.
    #[port("Volume Settings", "S", optional, kind = Generic)]
    settings: Option<Value>,
) -> Result<Shared<Mesh>, Message> {
    let level = settings.as_ref().map(Settings::of).transpose()?.map_or(0.0, |settings| settings.level);
    Ok(Shared::new(Volume::of(&volume)?.mesh(level)?))
}
