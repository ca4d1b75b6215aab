//! Surface / Analysis: the faces, edges and vertices of Breps, and how they hang together.

use std::sync::Arc as Shared;

use katydid_component::{Context, Message, component};
use katydid_data::{Tree, TreeBuilder, Value};
use katydid_geometry::{Brep, Curve, Point3};

use super::warning;

/// The edges at some places as curves; those without one are left out.
fn curves(brep: &Brep, edges: impl IntoIterator<Item = usize>) -> Result<Vec<Shared<Curve>>, Message> {
    let mut out = Vec::new();
    for edge in edges {
        out.extend(brep.edge_as_curve(edge).map_err(warning)?.map(Shared::new));
    }
    Ok(out)
}

/// The places of the edges, in order.
fn edges(brep: &Brep) -> impl Iterator<Item = usize> + '_ {
    (0..brep.edges().len()).filter(|edge| brep.edges().get(*edge).is_some_and(|edge| !edge.deleted))
}

/// The places of the faces, in order.
fn faces(brep: &Brep) -> impl Iterator<Item = usize> + '_ {
    (0..brep.faces().len()).filter(|face| brep.faces().get(*face).is_some_and(|face| !face.deleted))
}

/// Takes a Brep apart: into its faces with their trims, its edges and its vertices, each in the order of the Brep.
#[component(
    "8d372bdc-9800-45e9-8a26-6e33c5253e21",
    name = "Deconstruct Brep",
    nick = "DeBrep",
    at = "Surface/Analysis"
)]
#[output("Faces", "F", "The faces, each a surface of its own.", kind = Surface)]
#[output("Edges", "E", "The edges in space.")]
#[output("Vertices", "V", "The vertices.")]
fn deconstruct_brep(
    context: &Context<'_>,
    /// The Brep.
    #[port("Brep", "B")]
    brep: Shared<Brep>,
) -> Result<(Vec<Value>, Vec<Shared<Curve>>, Vec<Point3>), Message> {
    context.items(brep.faces().len() + brep.edges().len() + brep.vertices().len())?;
    let parts = faces(&brep).map(|face| brep.sub_brep(&[face]).map(Value::from).map_err(warning));
    let parts = parts.collect::<Result<_, _>>()?;
    let corners = brep.vertices().iter().filter(|vertex| !vertex.deleted).map(|vertex| vertex.point);
    Ok((parts, curves(&brep, edges(&brep))?, corners.collect()))
}

/// The edges of a Brep by how many faces meet there. A seam, where a face meets itself, is an interior edge.
#[component(
    "0148a65d-6f42-414a-9db7-9a9b2eb78437",
    name = "Brep Edges",
    nick = "Edges",
    at = "Surface/Analysis"
)]
#[output("Naked", "En", "The edges of one face only.")]
#[output("Interior", "Ei", "The edges between two faces.")]
#[output("Non-Manifold", "Em", "The edges of more than two faces.")]
fn brep_edges(
    context: &Context<'_>,
    /// The Brep.
    #[port("Brep", "B")]
    brep: Shared<Brep>,
) -> Result<(Vec<Shared<Curve>>, Vec<Shared<Curve>>, Vec<Shared<Curve>>), Message> {
    context.items(brep.edges().len())?;
    Ok((
        curves(&brep, brep.naked_edges())?,
        curves(&brep, brep.interior_edges())?,
        curves(&brep, brep.non_manifold_edges())?,
    ))
}

/// The most isocurves between two knots.
const DENSEST: i32 = 99;

/// The curves by which a Brep is drawn: its edges, and isocurves within the trims of its faces.
#[component(
    "ac750e41-2450-4f98-9658-98fef97b01b2",
    name = "Brep Wireframe",
    nick = "Wires",
    at = "Surface/Analysis"
)]
#[output("Wireframe", "W", "The edges, then the isocurves.")]
fn brep_wireframe(
    context: &Context<'_>,
    /// The Brep.
    #[port("Brep", "B")]
    brep: Shared<Brep>,
    /// How many isocurves run between two knots of a surface, from 0, where only those at knots are drawn, to 99. −1
    /// draws the edges only.
    #[port("Density", "D", default = -1)]
    density: i32,
) -> Result<Vec<Shared<Curve>>, Message> {
    let mut wires = curves(&brep, edges(&brep))?;
    if let Ok(density) = usize::try_from(density.min(DENSEST)) {
        for face in faces(&brep) {
            context.check()?;
            wires.extend(brep.face_wires(face, density).map_err(warning)?.into_iter().map(Shared::new));
            context.items(wires.len())?;
        }
    }
    Ok(wires)
}

/// Which faces and edges of a Brep belong together.
#[component(
    "866ee39d-9ebf-4e1d-b209-324c56825605",
    name = "Brep Topology",
    nick = "Topology",
    at = "Surface/Analysis"
)]
#[output("Face|Face Adjacency", "FF", "For each face the faces that share an edge with it.", kind = Integer)]
#[output("Face|Edge Adjacency", "FE", "For each face its edges.", kind = Integer)]
#[output("Edge|Face Adjacency", "EF", "For each edge its faces.", kind = Integer)]
fn brep_topology(
    context: &Context<'_>,
    /// The Brep.
    #[port("Brep", "B")]
    brep: Shared<Brep>,
) -> Result<(Tree, Tree, Tree), Message> {
    let mut faces_of = vec![Vec::new(); brep.edges().len()];
    let mut edges_of = vec![Vec::new(); brep.faces().len()];
    for trim in brep.trims().iter().filter(|trim| !trim.deleted) {
        let face = trim.in_loop.and_then(|l| brep.loops().get(l)).and_then(|l| l.face);
        let (Some(face), Some(edge)) = (face, trim.edge) else { continue };
        if let (Some(faces), Some(edges)) = (faces_of.get_mut(edge), edges_of.get_mut(face)) {
            faces.push(face);
            edges.push(edge);
        }
    }
    for list in faces_of.iter_mut().chain(&mut edges_of) {
        list.sort_unstable();
        list.dedup();
    }
    let beside = edges_of.iter().enumerate().map(|(face, edges)| {
        let all = edges.iter().filter_map(|edge| faces_of.get(*edge)).flatten();
        let mut others: Vec<usize> = all.copied().filter(|other| *other != face).collect();
        others.sort_unstable();
        others.dedup();
        others
    });
    let beside: Vec<Vec<usize>> = beside.collect();
    let tree = |lists: &[Vec<usize>]| -> Result<Tree, Message> {
        context.items(lists.iter().map(Vec::len).sum())?;
        let start = context.path().child(context.iteration());
        let mut out = TreeBuilder::<i32>::new();
        for (k, list) in lists.iter().enumerate() {
            out.branch(start.child(k));
            list.iter().for_each(|place| out.push(i32::try_from(*place).ok()));
        }
        Ok(out.finish())
    };
    Ok((tree(&beside)?, tree(&edges_of)?, tree(&faces_of)?))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::Value;
    use katydid_geometry::{Box3, Cylinder, Interval, Plane, Point3, Sphere, construct};

    fn block() -> Value {
        let side = Interval::new(0.0, 2.0);
        Value::from(construct::box_brep(&Box3 { plane: Plane::XY, x: side, y: side, z: side }).unwrap())
    }

    fn lengths(trial: Trial, output: usize) -> Vec<String> {
        let curves = trial.run().outputs.swap_remove(output);
        Trial::of_guid("c75b62fa-0a33-4da7-a5bd-03fd0068fd93").tree(curves).texts(0)
    }

    #[test]
    fn boxes_come_apart() {
        let parts = || Trial::of("Deconstruct Brep").item(block());
        let faces = parts().run().outputs.swap_remove(0);
        assert_eq!(faces.item_count(), 6);
        assert_eq!(Trial::of("Area").tree(faces).texts(0), ["{0;0}: 4, 4, 4, 4, 4, 4"]);
        assert_eq!(lengths(parts(), 1), [format!("{{0;0}}: {}", ["2"; 12].join(", "))]);
        let corners = parts().texts(2).join("");
        assert!(
            corners.starts_with("{0;0}: {0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}"),
            "{corners}"
        );
    }

    #[test]
    fn edges_by_faces() {
        let tube = Cylinder::new(Plane::XY, 1.0, Interval::new(0.0, 3.0)).unwrap();
        let tube = || Trial::of("Brep Edges").item(construct::cylinder(&tube, [false; 2]).unwrap());
        assert_eq!(lengths(tube(), 0), ["{0;0}: 6.283185, 6.283185"]);
        assert_eq!(lengths(tube(), 1), ["{0;0}: 3"]);
        assert_eq!(tube().run().outputs[2].item_count(), 0);
    }

    #[test]
    fn wires() {
        let wires = |density: i32| {
            Trial::of("Brep Wireframe").item(block()).item(density).run().outputs.swap_remove(0)
        };
        assert_eq!(wires(-1).item_count(), 12);
        assert_eq!(wires(0).item_count(), 12);
        assert_eq!(wires(1).item_count(), 24);
        let ball = construct::quad_sphere(&Sphere::around(Point3::ORIGIN, 1.0).unwrap()).unwrap();
        let ball = Trial::of("Brep Wireframe").item(ball).item(1).run().outputs.swap_remove(0);
        assert!(ball.item_count() > 12);
    }

    #[test]
    fn neighbours() {
        let topology = || Trial::of("Brep Topology").item(block());
        let of_faces = topology().texts(0);
        assert_eq!(of_faces.len(), 6);
        assert_eq!(of_faces[0], "{0;0;0}: 1, 3, 4, 5");
        assert!(topology().texts(1).iter().all(|edges| edges.matches(',').count() == 3));
        assert_eq!(topology().texts(2).len(), 12);
    }
}
