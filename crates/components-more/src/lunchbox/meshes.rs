//! LunchBox Mesh, and the meshes of its Util: thickness, edges, fewer faces, faces as surfaces.

use std::sync::Arc as Shared;

use katydid_component::{Context, Message, component};
use katydid_data::Value;
use katydid_geometry::{Decimation, Line, Mesh, Point3, Vector3};

use super::panel;
use crate::polygons::{Polygons, sides};

/// Moves a mesh along a vector and closes the way between. Stands for LunchBox's Mesh Extrude. Without a solid there are the sides
/// only: a quad along each naked edge. Vertices in one place are one.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c71",
    name = "Mesh Extrude",
    nick = "MshExtrude",
    at = "LunchBox/Mesh"
)]
#[output("Extruded Mesh", "Mesh", "The mesh.")]
fn extrude(
    context: &Context<'_>,
    /// The mesh.
    #[port("Mesh", "Mesh")]
    mesh: &Mesh,
    /// The direction and the distance.
    #[port("Direction", "Dir", default = Vector3::new(0.0, 0.0, 1.0))]
    direction: Vector3,
    /// Whether the mesh itself and its image close the sides.
    #[port("Solid Toggle", "Solid?", default = true)]
    solid: bool,
    /// Whether it reaches as far to the other side.
    #[port("Extrude Both Sides Toggle", "Both Sides?", default = false)]
    both: bool,
) -> Result<Shared<Mesh>, Message> {
    if !direction.is_finite() || direction == Vector3::ZERO {
        return Err(Message::error("The direction has no length, or it is not finite"));
    }
    let near = Polygons::of_mesh(mesh);
    context.items(near.faces.len().saturating_mul(6))?;
    let n = near.points.len();
    let back = if both { -direction } else { Vector3::ZERO };
    let points = [back, direction];
    let points = points.iter().flat_map(|by| near.points.iter().map(move |p| *p + *by)).collect();
    let mut faces = Vec::new();
    if solid {
        // The near side looks the other way.
        faces.extend(near.faces.iter().map(|face| face.iter().rev().copied().collect()));
        faces.extend(near.faces.iter().map(|face| face.iter().map(|k| k + n).collect::<Vec<usize>>()));
    }
    let edges = near.edges();
    for (a, b) in near.faces.iter().flat_map(|face| sides(face)) {
        if edges.number(a, b).is_some_and(|number| edges.is_naked(number)) {
            faces.push(vec![a, b, b + n, a + n]);
        }
    }
    if faces.is_empty() {
        return Err(Message::error("The mesh is closed: it has no naked edge whose side could be made"));
    }
    let made = Polygons { points, faces }.to_mesh(context)?;
    // A mesh that looks away from the direction comes out inside out.
    Ok(Shared::new(if made.is_closed() && made.volume() < 0.0 { made.flipped() } else { made }))
}

/// Moves a mesh along its normals, and closes the way between where it is to be solid. Stands for LunchBox's Mesh Offset; that
/// vertices move so far that flat corners keep the distance, and that both sides without a solid are two meshes, is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c72",
    name = "Mesh Offset",
    nick = "MshOffset",
    at = "LunchBox/Mesh"
)]
#[output("Offset Mesh", "Mesh", "The mesh, or one for each side.")]
fn offset(
    context: &Context<'_>,
    /// The mesh.
    #[port("Mesh", "Mesh")]
    mesh: &Mesh,
    /// The distance, in units.
    #[port("Offset Distance", "Offset", default = 1.0)]
    distance: f64,
    /// Whether the mesh and its offset are one solid.
    #[port("Solid Toggle", "Solid?", default = false)]
    solid: bool,
    /// Whether it is moved to both sides.
    #[port("Offset Both Sides Toggle", "Both Sides?", default = false)]
    both: bool,
) -> Result<Vec<Shared<Mesh>>, Message> {
    if !distance.is_finite() {
        return Err(Message::error("The distance is not finite"));
    }
    context.bytes(mesh.faces().len().saturating_mul(400))?;
    let meshes = match (solid, both) {
        (false, false) => vec![mesh.offset(distance)?],
        (false, true) => vec![mesh.offset(distance)?, mesh.offset(-distance)?],
        (true, false) => vec![mesh.thickened(distance)?],
        (true, true) => vec![mesh.offset(-distance)?.thickened(2.0 * distance)?],
    };
    Ok(meshes.into_iter().map(Shared::new).collect())
}

/// The faces of a mesh as surfaces, quads apart from triangles. Stands for LunchBox's Mesh to Nurbs.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c73",
    name = "Mesh to Nurbs",
    nick = "MeshNurbs",
    at = "LunchBox/Mesh"
)]
#[output("Quadrangular Surfaces", "Quads", "The faces of four corners, in the order of the mesh.")]
#[output("Triangular Surfaces", "Tris", "The faces of three corners.")]
fn to_nurbs(
    context: &Context<'_>,
    /// The mesh.
    #[port("Mesh", "Mesh")]
    mesh: &Mesh,
) -> Result<(Vec<Value>, Vec<Value>), Message> {
    context.items(mesh.faces().len())?;
    // A surface of four control points.
    context.bytes(mesh.faces().len().saturating_mul(1000))?;
    let (mut quads, mut triangles) = (Vec::new(), Vec::new());
    for face in mesh.faces() {
        let at = |k: &u32| mesh.vertices().get(*k as usize).copied().unwrap_or(Point3::ORIGIN);
        let corners: Vec<Point3> = face.indices().iter().map(at).collect();
        let into = if corners.len() == 4 { &mut quads } else { &mut triangles };
        into.push(panel(&corners)?);
    }
    Ok((quads, triangles))
}

/// The edges of a mesh at which it bends, and its naked ones. Stands for LunchBox's Mesh Edges (with Tolerance); that the angle is
/// in radians is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c6c",
    name = "Mesh Edges (with Tolerance)",
    nick = "MshEdge",
    at = "LunchBox/Util"
)]
#[output(
    "Interior Edges",
    "IntEdges",
    "The edges between two faces whose normals are farther apart than the angle."
)]
#[output("Naked Edges", "NakedEdges", "The edges of one face only.")]
fn edges(
    context: &Context<'_>,
    /// The mesh.
    #[port("Mesh", "Mesh")]
    mesh: &Mesh,
    /// The angle between normals, in radians.
    #[port("Angle Threshold", "Angle", default = 0.5)]
    angle: f64,
) -> Result<(Vec<Line>, Vec<Line>), Message> {
    if !angle.is_finite() {
        return Err(Message::error("The angle is not finite"));
    }
    let polygons = Polygons::of_mesh(mesh);
    let edges = polygons.edges();
    context.items(edges.list.len())?;
    let normal = |f: &usize| polygons.faces.get(*f).map_or(Vector3::ZERO, |face| polygons.area_vector(face));
    let (mut bent, mut naked) = (Vec::new(), Vec::new());
    for (&(a, b), faces) in edges.list.iter().zip(&edges.faces) {
        let line = Line::new(polygons.at(a), polygons.at(b));
        match faces.as_slice() {
            [_] => naked.push(line),
            [f, g] if normal(f).angle_to(normal(g)).is_some_and(|between| between > angle) => bent.push(line),
            _ => {}
        }
    }
    Ok((bent, naked))
}

/// A mesh with fewer faces. Stands for LunchBox's Mesh Reduce; how accurate it is, whether it is distorted and its size do not
/// count.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c6d",
    name = "Mesh Reduce",
    nick = "MshReduce",
    at = "LunchBox/Util"
)]
#[output("Reduced Mesh", "RedMsh", "The mesh, of triangles.")]
fn reduce(
    context: &Context<'_>,
    /// The mesh.
    #[port("Mesh", "Mesh")]
    mesh: &Mesh,
    /// The number of faces to come down to.
    #[port("Target Size", "Size", default = 1000)]
    size: i32,
    /// Whether it may be distorted; it does not count.
    #[port("Distort", "Dist", default = true)]
    _distort: bool,
    /// How accurate it is, from 0 to 10; it does not count.
    #[port("Accuracy", "Accuracy", default = 10.0)]
    _accuracy: f64,
    /// Whether the size is normalized; it does not count.
    #[port("Normalize Size", "Normalize", default = true)]
    _normalize: bool,
) -> Result<Shared<Mesh>, Message> {
    let faces = usize::try_from(size)
        .ok()
        .filter(|faces| *faces > 0)
        .ok_or_else(|| Message::error(format!("The size is {size}: it must be at least 1")))?;
    let stop = context.stop();
    Ok(Shared::new(mesh.decimated(&Decimation { faces, max_error: f64::INFINITY }, || !stop())?))
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use katydid_component::testing::Trial;
    use katydid_data::Value;
    use katydid_geometry::{Box3, Interval, Mesh, MeshFace, Plane, Point3, Vector3};

    fn cube() -> Mesh {
        let side = Interval::new(0.0, 2.0);
        Mesh::cuboid(&Box3 { plane: Plane::XY, x: side, y: side, z: side }, 2, 2, 2).unwrap()
    }

    /// A sheet of 3 by 2 from a quad and two triangles.
    fn sheet() -> Mesh {
        let at = |x: f64, y: f64| Point3::new(x, y, 0.0);
        let corners = vec![at(0., 0.), at(2., 0.), at(2., 2.), at(0., 2.), at(3., 0.), at(3., 2.)];
        let quad = MeshFace::Quad([0, 1, 2, 3]);
        let triangles = [[1, 4, 5], [1, 5, 2]].map(MeshFace::Triangle);
        Mesh::new(corners, [vec![quad], triangles.to_vec()].concat()).unwrap()
    }

    fn mesh(trial: Trial) -> Arc<Mesh> {
        match trial.run().outputs[0].column().get(0) {
            Some(Value::Mesh(mesh)) => mesh,
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn sheets_become_solids() {
        for (up, both, height) in [(1.5, false, 1.5), (-1.5, false, 1.5), (0.5, true, 1.0)] {
            let trial = Trial::of("Mesh Extrude").item(sheet()).item(Vector3::Z * up);
            let made = mesh(trial.item(true).item(both));
            assert!(made.is_closed());
            assert!((made.volume() - 6.0 * height).abs() < 1e-9, "{up}: {}", made.volume());
        }
        let sides = mesh(Trial::of("Mesh Extrude").item(sheet()).default().item(false));
        assert_eq!(sides.faces().len(), 6);
        assert!((sides.area() - 10.0).abs() < 1e-9);
        for solid in [
            mesh(Trial::of("Mesh Offset").item(sheet()).item(0.5).item(true)),
            mesh(Trial::of("Mesh Offset").item(sheet()).item(0.25).item(true).item(true)),
        ] {
            assert!(solid.is_closed());
            assert!((solid.volume() - 3.0).abs() < 1e-9, "{}", solid.volume());
        }
        let grown = mesh(Trial::of("Mesh Offset").item(cube()).item(0.5));
        assert!((grown.volume() - 27.0).abs() < 1e-9);
        let two = Trial::of("Mesh Offset").item(cube()).item(0.5).item(false).item(true).run();
        assert_eq!(two.outputs[0].item_count(), 2);
        assert!(Trial::of("Mesh Extrude").item(sheet()).item(Vector3::ZERO).message().contains("no length"));
        assert!(Trial::of("Mesh Extrude").item(cube()).default().item(false).message().contains("closed"));
        assert!(Trial::of("Mesh Offset").item(cube()).item(f64::NAN).message().contains("not finite"));
    }

    #[test]
    fn faces_and_edges() {
        let out = Trial::of("Mesh to Nurbs").item(sheet()).run().outputs;
        assert_eq!([out[0].item_count(), out[1].item_count()], [1, 2]);
        let count = |mesh: Mesh, angle: f64| {
            let out = Trial::of("Mesh Edges (with Tolerance)").item(mesh).item(angle).run().outputs;
            [out[0].item_count(), out[1].item_count()]
        };
        // The 12 edges of a cube, each of two pieces; within faces it is flat.
        assert_eq!(count(cube(), 0.5), [24, 0]);
        assert_eq!(count(cube(), 1.6), [0, 0]);
        assert_eq!(count(sheet(), 0.5), [0, 6]);
        let reduced = mesh(Trial::of("Mesh Reduce").item(cube()).item(12));
        assert_eq!(reduced.faces().len(), 12);
        assert!((reduced.volume() - 8.0).abs() < 1e-9);
        assert!(Trial::of("Mesh Reduce").item(cube()).item(0).message().contains("at least 1"));
    }
}
