//! Triangles over points.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_data::{Tree, TreeBuilder};
use katydid_geometry::cloud::Delaunay;
use katydid_geometry::{Line, Mesh, MeshFace, Plane, Point3};

use super::{flat, place, present};
use crate::mesh::{integer, shared};

const DUPLICATES: &str = "Some points fall on others, seen along the plane's normal, and are left out";

/// A mesh of triangles over points: seen along the plane's normal, no circle about a triangle has a point inside.
///
/// The vertices are the points where they are, in their order, so that the mesh need not be flat. Of points that lie
/// behind each other only the first is used, with a warning. Points on one line make no mesh.
#[component(
    "1eb4f6ff-3547-4184-bead-1b01e7cfd668",
    name = "Delaunay Mesh",
    nick = "Del",
    at = "Mesh/Triangulation"
)]
#[output("Mesh", "M", "The mesh; its faces look along the plane's normal.")]
fn delaunay_mesh(
    context: &Context<'_>,
    /// The points; nulls are left out.
    #[port("Points", "P")]
    points: List<Point3>,
    /// The plane along whose normal the points are seen.
    #[port("Plane", "Pl", default = Plane::XY, optional)]
    plane: Plane,
) -> Result<Option<Shared<Mesh>>, Message> {
    let (_, points) = present(&points);
    context.items(points.len())?;
    let delaunay = Delaunay::new(&flat(&points, &plane))?;
    if delaunay.has_duplicates() {
        context.warn(DUPLICATES);
    }
    if delaunay.triangles().is_empty() {
        context.warn("The points are fewer than three, or lie on one line seen along the plane's normal");
        return Ok(None);
    }
    let mut numbers = vec![0_u32; points.len()];
    let mut vertices = Vec::with_capacity(points.len());
    for (i, (&p, number)) in points.iter().zip(&mut numbers).enumerate() {
        if delaunay.first_at(i) == i {
            *number = vertices.len() as u32;
            vertices.push(p);
        }
    }
    let number = |i: u32| numbers.get(i as usize).copied().unwrap_or(0);
    let faces = delaunay.triangles().iter().map(|t| MeshFace::Triangle(t.map(number))).collect();
    Ok(Some(shared(Mesh::new(vertices, faces)?.with_normals())))
}

/// Which points a Delaunay triangulation joins, seen along the plane's normal.
///
/// Of points that lie behind each other only the first is used, with a warning. Points on one line are joined in a row.
#[component(
    "db2a4d25-23fa-4887-8983-ee5293cc82c0",
    name = "Delaunay Edges",
    nick = "Con",
    at = "Mesh/Triangulation"
)]
#[output("Connectivity", "C", "For every point a branch with the places of those joined to it.", kind = Integer)]
#[output("Edges", "E", "Every edge once, from point to point.")]
fn delaunay_edges(
    context: &Context<'_>,
    /// The points; a null has a branch without neighbours.
    #[port("Points", "P")]
    points: List<Point3>,
    /// The plane along whose normal the points are seen.
    #[port("Plane", "Pl", default = Plane::XY, optional)]
    plane: Plane,
) -> Result<(Tree, Vec<Line>), Message> {
    let count = points.len();
    let (places, points) = present(&points);
    context.items(count.saturating_mul(6))?;
    let delaunay = Delaunay::new(&flat(&points, &plane))?;
    if delaunay.has_duplicates() {
        context.warn(DUPLICATES);
    }
    let mut lists = vec![Vec::new(); count];
    for (i, &at) in places.iter().enumerate() {
        if delaunay.first_at(i) == i
            && let Some(list) = lists.get_mut(at)
        {
            list.extend(delaunay.neighbours(i).filter_map(|j| places.get(j).copied()));
            list.sort_unstable();
        }
    }
    let base = place(context);
    let mut tree = TreeBuilder::<i32>::new();
    for (i, list) in lists.iter().enumerate() {
        tree.branch(base.child(i));
        list.iter().for_each(|&j| tree.push(Some(integer(j))));
    }
    let at = |i: u32| points.get(i as usize).copied();
    let edges = delaunay.edges().iter().filter_map(|&[a, b]| Some(Line::new(at(a)?, at(b)?))).collect();
    Ok((tree.finish(), edges))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};
    use katydid_geometry::{Plane, Point3};

    fn points() -> Vec<Point3> {
        [[0.0, 0.0, 0.0], [4.0, 0.0, 1.0], [0.0, 3.0, 2.0], [4.0, 4.0, 3.0]].map(Point3::from).to_vec()
    }

    #[test]
    fn meshes_keep_points_where_they_are() {
        let run = Trial::of("Delaunay Mesh").list(points()).run();
        assert_eq!(texts(&run.outputs[0]), ["{0}: Mesh (V:4  F:2)"]);
        let vertices = Trial::of("Deconstruct Mesh").tree(run.outputs[0].clone()).texts(0);
        assert_eq!(vertices, ["{0;0}: {0, 0, 0}, {4, 0, 1}, {0, 3, 2}, {4, 4, 3}"]);
        let area = Trial::of("Delaunay Mesh").list(points()).item(Plane::XY);
        assert!(area.message().is_empty());
        let mut twice = points();
        twice.insert(1, Point3::new(0.0, 0.0, 9.0));
        let run = Trial::of("Delaunay Mesh").list(twice).run();
        assert_eq!(texts(&run.outputs[0]), ["{0}: Mesh (V:4  F:2)"]);
        assert!(run.messages[0].text.contains("fall on others"));
    }

    #[test]
    fn points_that_make_no_mesh() {
        for n in 0..3 {
            let trial = || Trial::of("Delaunay Mesh").list(points()[..n].to_vec());
            assert!(!trial().texts(0).join("").contains("Mesh"), "{n} points");
        }
        let row = (0..5).map(|i| Point3::new(f64::from(i), 0.0, 0.0));
        assert!(Trial::of("Delaunay Mesh").list(row).message().contains("one line"));
        assert!(
            Trial::of("Delaunay Mesh").list([Point3::new(f64::NAN, 0.0, 0.0)]).message().contains("finite")
        );
    }

    #[test]
    fn edges_and_neighbours() {
        let run = Trial::of("Delaunay Edges").list(points()).run();
        assert_eq!(texts(&run.outputs[0])[0], "{0;0;0}: 1, 2");
        assert_eq!(texts(&run.outputs[0])[3], "{0;0;3}: 1, 2");
        let row = [Some(0.0), None, Some(5.0), Some(2.0)].map(|x| x.map(|x| Point3::new(x, 0.0, 0.0)));
        let run = Trial::of("Delaunay Edges").gaps(row).run();
        assert_eq!(texts(&run.outputs[0]), ["{0;0;0}: 3", "{0;0;1}:", "{0;0;2}: 3", "{0;0;3}: 0, 2"]);
    }
}
