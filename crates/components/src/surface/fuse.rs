//! Surface / SubD: subdivision surfaces whose nets are united or taken from one another.

use std::collections::HashMap;

use katydid_component::{Context, Message, component};
use katydid_data::Value;
use katydid_geometry::subd::{FromMesh, SubDNet};
use katydid_geometry::{Mesh, MeshFace, Point3, Solid, Vector3};

use super::subd::{kept, subd};
use super::warning;

/// The most steps of smoothing.
const MOST_STEPS: i32 = 1000;
/// Triangles between which the net turns by less than this, in radians, become one quad where they fit.
const FLAT: f64 = 1e-6;

/// Unites two SubDs, or takes one from the other: a SubD of what their control nets enclose together.
///
/// The nets are cut where they cross, and the SubD follows the net that is left: it is near the shapes, not on them,
/// most of all along the cut. Both must be closed.
#[component("264b4aa6-4915-4a67-86a7-22a5c4acf565", name = "SubD Fuse", nick = "Fuse", at = "Surface/SubD")]
#[output("Fuse", "F", "The SubD.", kind = SubD)]
fn subd_fuse(
    context: &Context<'_>,
    /// A SubD, or a mesh as its net.
    #[port("SubD A", "A")]
    first: Value,
    /// The other one.
    #[port("SubD B", "B")]
    second: Value,
    /// 0 unites them, 1 keeps what they share, 2 takes B from A, 3 takes A from B.
    #[port("Boolean Option", "O", default = 0)]
    option: i32,
    /// How often the corners that the cut made are moved to the middle of their neighbours.
    #[port("Smoothing", "S", default = 0)]
    smoothing: i32,
) -> Result<Value, Message> {
    let nets = [net("A", &first)?, net("B", &second)?];
    let solid = |name: &str, net: &Mesh| {
        Solid::new(net).map_err(|error| Message::warning(format!("{name} cannot be used: {error}")))
    };
    let (a, b) = (solid("A", &nets[0])?, solid("B", &nets[1])?);
    context.check()?;
    let result = match option {
        0 => a.union(&b),
        1 => a.intersection(&b),
        2 => a.difference(&b),
        3 => b.difference(&a),
        other => return Err(Message::error(format!("There is no option {other}: it is 0, 1, 2 or 3"))),
    };
    let result = result.map_err(warning)?;
    if result.is_empty() {
        return Err(Message::warning("Nothing is left of them"));
    }
    let (mesh, _) = result.to_mesh().map_err(warning)?.quadrangulated(FLAT, 0.0);
    context.bytes(mesh.faces().len().saturating_mul(400))?;
    let steps = smoothing.clamp(0, MOST_STEPS);
    if steps != smoothing {
        context.warn(format!("The smoothing must be from 0 to {MOST_STEPS}: {steps} is used"));
    }
    let mesh = smoothed(context, &mesh, &nets, steps)?;
    kept(context, SubDNet::from_mesh(&mesh, &FromMesh { creases: false, corners: false }).map_err(warning)?)
}

/// The control net of a SubD; a mesh is its own.
fn net(name: &str, value: &Value) -> Result<Mesh, Message> {
    match value {
        Value::Mesh(mesh) => Ok((**mesh).clone()),
        other => match subd(other) {
            Ok(subd) => subd.net().to_mesh().map_err(warning),
            Err(why) => Err(Message::warning(format!("{name} cannot be used: {why}"))),
        },
    }
}

/// The mesh with the vertices that neither of the nets has moved to the mean of their neighbours, so many times.
fn smoothed(context: &Context<'_>, mesh: &Mesh, nets: &[Mesh; 2], steps: i32) -> Result<Mesh, Message> {
    let key = |p: &Point3| [p.x, p.y, p.z].map(|x| (x + 0.0).to_bits());
    let mut neighbours: HashMap<u32, Vec<u32>> = HashMap::new();
    let old: std::collections::HashSet<[u64; 3]> =
        nets.iter().flat_map(|net| net.vertices()).map(key).collect();
    let mut points = mesh.vertices().to_vec();
    for face in mesh.faces() {
        let corners = MeshFace::indices(face);
        for (k, &corner) in corners.iter().enumerate() {
            let (before, after) =
                (corners[(k + corners.len() - 1) % corners.len()], corners[(k + 1) % corners.len()]);
            if points.get(corner as usize).is_some_and(|p| !old.contains(&key(p))) {
                let near = neighbours.entry(corner).or_default();
                near.extend([before, after].into_iter().filter(|i| !near.contains(i)).collect::<Vec<_>>());
            }
        }
    }
    for _ in 0..steps {
        context.check()?;
        let place = |i: u32| points.get(i as usize).map_or(Vector3::ZERO, |p| p.to_vector());
        let moved: Vec<(u32, Vector3)> = neighbours
            .iter()
            .map(|(&i, near)| (i, near.iter().map(|&k| place(k)).sum::<Vector3>() / near.len() as f64))
            .collect();
        for (i, to) in moved {
            if let Some(point) = points.get_mut(i as usize) {
                *point = Point3::ORIGIN + to;
            }
        }
    }
    Ok(Mesh::new(points, mesh.faces().to_vec())?)
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail")]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::Tree;
    use katydid_geometry::{Box3, Interval, Plane};

    fn block(low: f64, high: f64) -> Tree {
        let side = Interval::new(low, high);
        let shape = Box3 { plane: Plane::XY, x: side, y: side, z: side };
        Trial::of("SubD Box").item(shape).item(1).item(true).run().outputs.swap_remove(0)
    }

    fn fused(option: i32, smoothing: i32) -> Trial {
        Trial::of("SubD Fuse").tree(block(0.0, 2.0)).tree(block(1.0, 3.0)).item(option).item(smoothing)
    }

    #[test]
    fn nets_enclose_what_the_option_says() {
        for (option, volume) in [(0, "15"), (1, "1"), (2, "7"), (3, "7")] {
            let subd = fused(option, 0).run().outputs.swap_remove(0);
            let net = Trial::of("SubD Control Polygon").tree(subd).run().outputs.swap_remove(0);
            assert_eq!(Trial::of("Volume").tree(net).texts(0), [format!("{{0}}: {volume}")], "{option}");
        }
        assert!(fused(7, 0).message().contains("no option 7"));
    }

    #[test]
    fn smoothing_moves_the_cut_alone() {
        let net = |smoothing: i32| {
            let subd = fused(0, smoothing).run().outputs.swap_remove(0);
            let net = Trial::of("SubD Control Polygon").tree(subd).run().outputs.swap_remove(0);
            Trial::of("Deconstruct Mesh").tree(net).texts(0)
        };
        let (sharp, smooth) = (net(0), net(3));
        assert_eq!(sharp.len(), smooth.len());
        let moved = sharp.iter().zip(&smooth).filter(|(a, b)| a != b).count();
        assert!(moved > 0 && moved + 14 <= sharp.len().max(14) + 14, "{moved} of {}", sharp.len());
    }

    #[test]
    fn what_is_apart_shares_nothing() {
        let trial = Trial::of("SubD Fuse").tree(block(0.0, 1.0)).tree(block(2.0, 3.0)).item(1);
        assert!(trial.message().contains("Nothing is left"));
    }
}
