//! Mesh / Util: rays on meshes, and their shadows.

use std::rc::Rc;
use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_data::{Tree, TreeBuilder};
use katydid_geometry::{Curve, Interval, Mesh, Plane, Point3, PolylineCurve, Vector3};

use crate::prepared::{self, PreparedMesh};

/// The trees over all meshes of a list.
fn trees(context: &Context<'_>, meshes: &List<'_, Shared<Mesh>>) -> Result<Vec<Rc<PreparedMesh>>, Message> {
    meshes.present().map(|mesh| prepared::mesh(context, &mesh)).collect()
}

/// Rays that only just leave a place do not meet what it lies on: this part of the size of the mesh.
const NEAR: f64 = 1e-6;

fn size(mesh: &Mesh) -> f64 {
    mesh.bounding_box().map_or(0.0, |b| b.diagonal().length())
}

/// How much energy arrives at each vertex of a mesh along rays that nothing obstructs.
///
/// The mesh itself obstructs rays too.
#[component("a78e3fbc-d199-4bd9-8df0-fc4c2743eb31", name = "Exposure", nick = "Exposure", at = "Mesh/Util")]
#[output("Exposure", "E", "For each vertex the sum of what arrives.")]
#[output("Range", "R", "From the least to the most of all vertices.")]
fn exposure(
    context: &Context<'_>,
    /// The mesh that receives the rays.
    #[port("Shape", "S")]
    shape: Shared<Mesh>,
    /// More meshes that stand in the way.
    #[port("Obstructions", "O", optional)]
    obstructions: List<Shared<Mesh>>,
    /// The directions in which the rays travel.
    #[port("Rays", "R")]
    rays: List<Vector3>,
    /// The energy of each ray, 1 without it; the last is repeated.
    #[port("Energy", "E", optional)]
    energy: List<f64>,
    /// Whether slanting rays bring less, by the cosine of their angle to the normal; rays from behind nothing.
    #[port("Lambert", "L", default = false)]
    lambert: bool,
) -> Result<(Vec<f64>, Option<Interval>), Message> {
    let mut trees = trees(context, &obstructions)?;
    trees.push(prepared::mesh(context, &shape)?);
    let energy: Vec<f64> = energy.present().collect();
    let strength = |k: usize| energy.get(k).or(energy.last()).copied().unwrap_or(1.0);
    let rays: Vec<(Vector3, f64)> =
        rays.iter().enumerate().filter_map(|(k, ray)| Some((ray?.unitized()?, strength(k)))).collect();
    context.items(shape.vertices().len())?;
    let computed;
    let normals = if shape.normals().is_empty() {
        computed = shape.vertex_normals();
        &computed
    } else {
        shape.normals()
    };
    let nearest = NEAR * size(&shape);
    let mut sums = Vec::with_capacity(shape.vertices().len());
    for (at, normal) in shape.vertices().iter().zip(normals) {
        context.check()?;
        let mut sum = 0.0;
        for (ray, energy) in &rays {
            let share = if lambert { (-normal.dot(*ray)).max(0.0) } else { 1.0 };
            if share > 0.0 && !trees.iter().any(|t| t.tree.blocks(*at, -*ray, nearest)) {
                sum += share * energy;
            }
        }
        sums.push(sum);
    }
    let most = sums.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let least = sums.iter().copied().fold(f64::INFINITY, f64::min);
    Ok((sums, (least <= most).then(|| Interval::new(least, most))))
}

/// Which rays from points are stopped by meshes.
#[component("1583bd7e-4ab7-4439-b922-d6f8cd63c399", name = "Occlusion", nick = "Occ", at = "Mesh/Util")]
#[output("Hits", "H", "For each point how many rays are stopped.")]
#[output("Occlusion", "O", "A branch for each point: for each ray whether it is stopped.")]
fn occlusion(
    context: &Context<'_>,
    /// The points from which the rays go out.
    #[port("Samples", "S")]
    samples: List<Point3>,
    /// The meshes in the way.
    #[port("Obstructions", "O")]
    obstructions: List<Shared<Mesh>>,
    /// The directions of the rays.
    #[port("Rays", "R")]
    rays: List<Vector3>,
) -> Result<(Vec<Option<i32>>, Tree), Message> {
    let trees = trees(context, &obstructions)?;
    let nearest = NEAR * obstructions.present().map(|m| size(&m)).fold(0.0, f64::max);
    context.items(samples.len().saturating_mul(rays.len().saturating_add(1)))?;
    let rays: Vec<Option<Vector3>> = rays.to_vec();
    let path = context.path();
    let mut each = TreeBuilder::<bool>::new();
    let mut hits = Vec::with_capacity(samples.len());
    for (k, sample) in samples.iter().enumerate() {
        context.check()?;
        each.branch(path.child(k));
        let Some(sample) = sample else {
            hits.push(None);
            continue;
        };
        let mut count = 0;
        for ray in &rays {
            let stopped = ray.map(|ray| trees.iter().any(|t| t.tree.blocks(sample, ray, nearest)));
            count += i32::from(stopped == Some(true));
            each.push(stopped);
        }
        hits.push(Some(count));
    }
    Ok((hits, each.finish()))
}

/// The outlines of the shadow that a mesh throws on a plane.
///
/// What lies behind the plane throws a shadow too. Light along the plane is an error.
#[component("c3dce3e8-c9cc-413c-a93f-732434282fdd", name = "Mesh Shadow", nick = "MShadow", at = "Mesh/Util")]
#[output(
    "Outlines",
    "O",
    "Closed polylines: outer ones run counter-clockwise, those around holes clockwise."
)]
fn mesh_shadow(
    context: &Context<'_>,
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
    /// The direction of the light.
    #[port("Light", "L", default = Vector3::new(0.0, 0.0, -1.0))]
    light: Vector3,
    /// The plane on which the shadow falls.
    #[port("Plane", "P", default = Plane::XY)]
    plane: Plane,
) -> Result<Vec<Shared<Curve>>, Message> {
    context.check()?;
    let outlines = mesh.shadow(light, &plane)?;
    context.items(outlines.len())?;
    let close = |mut outline: Vec<Point3>| {
        outline.extend(outline.first().copied());
        Ok(Shared::new(PolylineCurve::new(outline)?.into()))
    };
    outlines.into_iter().map(close).collect()
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};
    use katydid_geometry::{Interval, Mesh, Plane, Point3, Rectangle, Vector3};

    fn sheet(z: f64, half: f64) -> Mesh {
        let side = Interval::new(-half, half);
        let plane = Plane { origin: Point3::new(0.0, 0.0, z), ..Plane::XY };
        Mesh::plane(&Rectangle { plane, x: side, y: side }, 2, 2).unwrap()
    }

    const DOWN: Vector3 = Vector3::new(0.0, 0.0, -1.0);

    #[test]
    fn rays_that_arrive() {
        let open =
            Trial::of("Exposure").item(sheet(0.0, 1.0)).default().list([DOWN, DOWN * 3.0]).list([2.0, 5.0]);
        assert_eq!(open.texts(0), ["{0;0}: 7, 7, 7, 7, 7, 7, 7, 7, 7"]);
        // A roof over the middle vertex.
        let roofed = || Trial::of("Exposure").item(sheet(0.0, 1.0)).list([sheet(1.0, 0.5)]).list([DOWN]);
        assert_eq!(roofed().texts(0), ["{0;0}: 1, 1, 1, 1, 0, 1, 1, 1, 1"]);
        assert_eq!(roofed().texts(1), ["{0}: 0 To 1"]);
        let slant = Vector3::new(3.0, 0.0, -4.0);
        let lambert =
            Trial::of("Exposure").item(sheet(0.0, 1.0)).default().list([slant, -slant]).default().item(true);
        assert_eq!(lambert.texts(1), ["{0}: 0.8 To 0.8"]);
        // A closed shape shades itself: from above, the lower half of a ball gets nothing.
        let ball = Mesh::sphere(&Plane::XY, 1.0, 8, 6).unwrap();
        let shaded = Trial::of("Exposure").item(ball).default().list([DOWN]).texts(0).join("");
        assert!(shaded.starts_with("{0;0}: 0, 0, 0") && shaded.ends_with("1, 1, 1"), "{shaded}");
        let none = Trial::of("Exposure").item(Mesh::default()).default().list([DOWN]).run();
        assert_eq!(texts(&none.outputs[0]), ["{0;0}:"]);
    }

    #[test]
    fn rays_that_are_stopped() {
        let samples = || [Point3::ORIGIN, Point3::new(5.0, 0.0, 0.0)];
        let rays = || [Vector3::Z, DOWN, Vector3::X];
        let seen = || Trial::of("Occlusion").list(samples()).list([sheet(1.0, 1.0)]).list(rays());
        assert_eq!(seen().texts(0), ["{0}: 1, 0"]);
        assert_eq!(seen().texts(1), ["{0;0}: True, False, False", "{0;1}: False, False, False"]);
    }

    #[test]
    fn shadows() {
        let outline = Trial::of("Mesh Shadow").item(sheet(3.0, 1.0)).run();
        assert_eq!(outline.outputs[0].item_count(), 1);
        let area = Trial::of("Area").tree(outline.outputs[0].clone()).texts(0);
        assert_eq!(area.len(), 1);
        assert!(area[0].ends_with(": 4"), "{area:?}");
        assert!(
            Trial::of("Mesh Shadow")
                .item(sheet(3.0, 1.0))
                .item(Vector3::X)
                .message()
                .contains("along the plane")
        );
    }
}
