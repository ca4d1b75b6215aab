//! Points joined to their nearest.

use std::collections::HashSet;

use katydid_component::{Context, List, Message, component};
use katydid_data::{Tree, TreeBuilder};
use katydid_geometry::{Line, Plane, Point3, cloud};

use super::{place, present};
use crate::mesh::integer;

/// Joins every point to its nearest others in space.
///
/// Every link comes once, in the branch of the point that names it first; the topology has all of them.
#[component(
    "e504d619-4467-437a-92fa-c6822d16b066",
    name = "Proximity 3D",
    nick = "Prox",
    at = "Mesh/Triangulation"
)]
#[output("Links", "L", "Segments from point to point, a branch a point.", kind = Line)]
#[output("Topology", "T", "For every point a branch with the places of its nearest, the nearest first.", kind = Integer)]
fn proximity_3d(
    context: &Context<'_>,
    /// The points; a null has no links.
    #[port("Points", "P")]
    points: List<Point3>,
    /// How many others a point is joined to at most; not negative.
    #[port("Group", "G", default = 5)]
    group: i32,
    /// Others nearer than this are left out.
    #[port("Min Radius", "R-", optional)]
    min_radius: Option<f64>,
    /// Others farther than this are left out.
    #[port("Max Radius", "R+", optional)]
    max_radius: Option<f64>,
) -> Result<(Tree, Tree), Message> {
    joined(context, &points, |p| p, group, [min_radius, max_radius])
}

/// Joins every point to its nearest others, with distances seen along a plane's normal.
///
/// Every link comes once, in the branch of the point that names it first; the topology has all of them. Links go from
/// point to point in space.
#[component(
    "458ed0e0-19a3-419b-8ead-f524925b8a35",
    name = "Proximity 2D",
    nick = "Prox",
    at = "Mesh/Triangulation"
)]
#[output("Links", "L", "Segments from point to point, a branch a point.", kind = Line)]
#[output("Topology", "T", "For every point a branch with the places of its nearest, the nearest first.", kind = Integer)]
fn proximity_2d(
    context: &Context<'_>,
    /// The points; a null has no links.
    #[port("Points", "P")]
    points: List<Point3>,
    /// The plane in which distances are measured.
    #[port("Plane", "Pl", default = Plane::XY)]
    plane: Plane,
    /// How many others a point is joined to at most; not negative.
    #[port("Group", "G", default = 5)]
    group: i32,
    /// Others nearer than this are left out.
    #[port("Min Radius", "R-", optional)]
    min_radius: Option<f64>,
    /// Others farther than this are left out.
    #[port("Max Radius", "R+", optional)]
    max_radius: Option<f64>,
) -> Result<(Tree, Tree), Message> {
    joined(context, &points, |p| plane.closest_point(p), group, [min_radius, max_radius])
}

fn joined(
    context: &Context<'_>,
    points: &List<'_, Point3>,
    measured: impl Fn(Point3) -> Point3,
    group: i32,
    [least, most]: [Option<f64>; 2],
) -> Result<(Tree, Tree), Message> {
    let count = points.len();
    let group = usize::try_from(group).map_err(|_| Message::error("The group must not be negative"))?;
    if [least, most].into_iter().flatten().any(f64::is_nan) {
        return Err(Message::error("A radius is not a number"));
    }
    let (places, points) = present(points);
    let group = group.min(points.len().saturating_sub(1));
    context.items(points.len().saturating_mul(group.max(1)))?;
    let distances = [least.unwrap_or(0.0), most.unwrap_or(f64::INFINITY)];
    let measured: Vec<Point3> = points.iter().map(|&p| measured(p)).collect();
    // A link is known by its ends, and is in both results.
    context.bytes(points.len().saturating_mul(group).saturating_mul(2 * size_of::<(usize, usize)>()))?;
    let near = cloud::proximity(&measured, group, distances)?;
    let (mut links, mut topology) = (TreeBuilder::<Line>::new(), TreeBuilder::<i32>::new());
    let mut known: HashSet<(usize, usize)> = HashSet::with_capacity(points.len().saturating_mul(group));
    let mut rows = places.iter().zip(points.iter().zip(&near)).enumerate().peekable();
    for k in 0..count {
        let path = place(context).child(k);
        links.branch(path.clone());
        topology.branch(path);
        let Some((i, (_, (&from, others)))) = rows.next_if(|(_, (at, _))| **at == k) else { continue };
        for &j in others {
            topology.push(places.get(j).map(|&p| integer(p)));
            if known.insert((i.min(j), i.max(j))) {
                links.push(points.get(j).map(|&to| Line::new(from, to)));
            }
        }
    }
    Ok((links.finish(), topology.finish()))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};
    use katydid_geometry::{Plane, Point3};

    fn points() -> [Point3; 4] {
        [[0.0, 0.0, 0.0], [1.0, 0.0, 9.0], [3.0, 0.0, 0.0], [7.0, 0.0, 0.0]].map(Point3::from)
    }

    #[test]
    fn links_and_topology() {
        let run = Trial::of("Proximity 3D").list(points()).item(1).run();
        assert_eq!(texts(&run.outputs[1]), ["{0;0;0}: 2", "{0;0;1}: 0", "{0;0;2}: 0", "{0;0;3}: 2"]);
        let links = texts(&run.outputs[0]);
        assert_eq!(
            links.iter().map(|l| l.matches("Line").count()).collect::<Vec<_>>(),
            [1, 1, 0, 1],
            "{links:?}"
        );
        let run = Trial::of("Proximity 2D").list(points()).item(Plane::XY).item(2).default().item(3.0).run();
        assert_eq!(texts(&run.outputs[1]), ["{0;0;0}: 1, 2", "{0;0;1}: 0, 2", "{0;0;2}: 1, 0", "{0;0;3}:"]);
        let run = Trial::of("Proximity 2D").list(points()).default().item(9).item(2.5).run();
        assert_eq!(texts(&run.outputs[1])[1], "{0;0;1}: 3");
    }

    #[test]
    fn odd_inputs() {
        assert!(Trial::of("Proximity 3D").list(points()).item(-1).message().contains("negative"));
        let gaps = [Some(points()[0]), None, Some(points()[2])];
        assert_eq!(Trial::of("Proximity 3D").gaps(gaps).texts(1), ["{0;0;0}: 2", "{0;0;1}:", "{0;0;2}: 0"]);
        assert_eq!(Trial::of("Proximity 3D").list(points()).item(0).texts(1)[3], "{0;0;3}:");
        assert_eq!(Trial::of("Proximity 3D").list([Point3::ORIGIN]).texts(1), ["{0;0;0}:"]);
    }
}
