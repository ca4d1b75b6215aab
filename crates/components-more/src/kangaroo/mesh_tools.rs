//! Mesh: what goals are made from, and what solved meshes are made into.

use std::collections::{HashMap, VecDeque};
use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_geometry::{Line, Mesh, MeshFace, Point3, Vector3};

use super::thresholds::{SAME_CORNER, SMALLEST_CELL};
use crate::polygons::{Polygons, edge, sides};

/// The most levels of refinement: each makes four times the faces.
const MOST_LEVELS: i32 = 12;

fn number(i: usize) -> i32 {
    i32::try_from(i).unwrap_or(i32::MAX)
}

/// The faces each cut into four: quads and others at the middle of the face and of the edges, triangles at those of the edges.
pub(crate) fn refined(polygons: &Polygons) -> (Polygons, Vec<usize>) {
    let edges = polygons.edges();
    let mut fine = Polygons { points: polygons.points.clone(), faces: Vec::new() };
    let mut parents = Vec::new();
    let first = fine.points.len();
    fine.points.extend(edges.list.iter().map(|&(a, b)| polygons.at(a).lerp(polygons.at(b), 0.5)));
    for (f, face) in polygons.faces.iter().enumerate() {
        let halves: Vec<usize> = sides(face).filter_map(|(a, b)| Some(first + edges.number(a, b)?)).collect();
        let n = face.len();
        let (Some(_), true) = (halves.first(), halves.len() == n) else { continue };
        let half = |k: usize| halves.get(k % n).copied().unwrap_or_default();
        if n == 3 {
            for (k, &corner) in face.iter().enumerate() {
                fine.faces.push(vec![corner, half(k), half(k + 2)]);
            }
            fine.faces.push(halves.clone());
            parents.extend([f; 4]);
        } else {
            let middle = fine.points.len();
            fine.points.push(polygons.middle(face));
            for (k, &corner) in face.iter().enumerate() {
                fine.faces.push(vec![corner, half(k), middle, half(k + n - 1)]);
                parents.push(f);
            }
        }
    }
    (fine, parents)
}

fn levels(context: &Context<'_>, faces: usize, level: i32) -> Result<i32, Message> {
    if level > MOST_LEVELS {
        return Err(Message::error(format!("{level} levels are too many: at most {MOST_LEVELS}")));
    }
    let level = level.max(0);
    // A face with its corners, edges and points, at each level.
    context.bytes(faces.saturating_mul(200).saturating_mul(4_usize.saturating_pow(level.unsigned_abs())))?;
    Ok(level)
}

/// Cuts each face of a mesh into four, level by level: the shape stays. Stands for Kangaroo 2's Refine.
#[component("6003658a-c422-41cf-8a2f-8e106b09cc10", name = "Refine", nick = "Refine", at = "Kangaroo2/Mesh")]
#[output("Mesh", "M", "The refined mesh.")]
fn refine(
    context: &Context<'_>,
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
    /// How often each face is cut into four.
    #[port("Level", "L", default = 1)]
    level: i32,
) -> Result<Shared<Mesh>, Message> {
    let mut polygons = Polygons::of_mesh(mesh);
    for _ in 0..levels(context, polygons.faces.len(), level)? {
        context.check()?;
        polygons = refined(&polygons).0;
    }
    Ok(Shared::new(polygons.to_mesh(context)?))
}

/// Cuts each face of a mesh into four, level by level, and gives a mesh for each face that there was. Stands for Kangaroo 2's
/// ByParent.
#[component(
    "5a4ba654-7203-474d-83d6-7f1cdfc0a41f",
    name = "ByParent",
    nick = "ByParent",
    at = "Kangaroo2/Mesh"
)]
#[output("Meshes", "M", "A mesh for each face.")]
fn by_parent(
    context: &Context<'_>,
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
    /// How often each face is cut into four.
    #[port("Level", "L", default = 1)]
    level: i32,
) -> Result<Vec<Shared<Mesh>>, Message> {
    let coarse = Polygons::of_mesh(mesh);
    let level = levels(context, coarse.faces.len(), level)?;
    context.items(coarse.faces.len())?;
    let part = |face: &Vec<usize>| {
        context.check()?;
        let corners: Vec<Point3> = face.iter().map(|&i| coarse.at(i)).collect();
        let mut polygons = Polygons { faces: vec![(0..corners.len()).collect()], points: corners };
        for _ in 0..level {
            polygons = refined(&polygons).0;
        }
        Ok(Shared::new(polygons.to_mesh(context)?))
    };
    coarse.faces.iter().map(part).collect()
}

/// Joins meshes to one, in which vertices in one place are one. Stands for Kangaroo 2's Combine&Clean.
#[component(
    "2491e794-8360-4317-b0ad-4950f6e0906a",
    name = "Combine&Clean",
    nick = "Clean",
    at = "Kangaroo2/Mesh"
)]
#[output("Mesh", "M", "The mesh, without vertices that no face uses.")]
fn combine_and_clean(
    context: &Context<'_>,
    /// The meshes.
    #[port("Meshes", "M")]
    meshes: List<Shared<Mesh>>,
) -> Result<Shared<Mesh>, Message> {
    let meshes: Vec<Mesh> = meshes.present().map(|mesh| (*mesh).clone()).collect();
    let whole = Mesh::join(&meshes)?;
    Ok(Shared::new(Polygons::of_mesh(&whole).to_mesh(context)?))
}

/// Replaces each edge of a mesh with a face between its ends and the middles of the faces beside it. Stands for Kangaroo 2's
/// Diagonalize.
#[component(
    "77e9376b-a397-4010-9b2c-dd0326107a91",
    name = "Diagonalize",
    nick = "Diag",
    at = "Kangaroo2/Mesh"
)]
#[output("Mesh", "M", "The mesh: a quad for each inner edge, a triangle for each naked one.")]
fn diagonalize(
    context: &Context<'_>,
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
) -> Result<Shared<Mesh>, Message> {
    let polygons = Polygons::of_mesh(mesh);
    let edges = polygons.edges();
    let first = polygons.points.len();
    let mut diagonal = Polygons { points: polygons.points.clone(), faces: Vec::new() };
    diagonal.points.extend(polygons.faces.iter().map(|face| polygons.middle(face)));
    for (&(a, b), faces) in edges.list.iter().zip(&edges.faces) {
        let walks =
            |f: usize| polygons.faces.get(f).is_some_and(|face| sides(face).any(|side| side == (a, b)));
        match *faces.as_slice() {
            [f] if walks(f) => diagonal.faces.push(vec![a, b, first + f]),
            [f] => diagonal.faces.push(vec![b, a, first + f]),
            // The face that walks from a to b lies on the left: the new one goes b, its middle, a, the other's middle.
            [f, g, ..] if walks(f) => diagonal.faces.push(vec![a, first + g, b, first + f]),
            [f, g, ..] => diagonal.faces.push(vec![a, first + f, b, first + g]),
            [] => {}
        }
    }
    Ok(Shared::new(diagonal.to_mesh(context)?))
}

/// For each inner edge of a mesh its ends and the two tips beside it, as hinges take them. Stands for Kangaroo 2's
/// HingePoints; of a quad the tip is the corner that comes after the edge.
#[component(
    "24f82a13-a700-45e0-9528-8646323d4af2",
    name = "HingePoints",
    nick = "HingePoints",
    at = "Kangaroo2/Mesh"
)]
#[output("Point 1", "1", "The starts of the edges.")]
#[output("Point 2", "2", "The ends of the edges.")]
#[output("Point 3", "3", "The tips of the faces on the one side.")]
#[output("Point 4", "4", "The tips of the faces on the other side.")]
fn hinge_points(
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
) -> Result<(Vec<Point3>, Vec<Point3>, Vec<Point3>, Vec<Point3>), Message> {
    let polygons = Polygons::of_mesh(mesh);
    let edges = polygons.edges();
    let mut found = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    for (&(a, b), faces) in edges.list.iter().zip(&edges.faces) {
        let [f, g] = *faces.as_slice() else { continue };
        let tip = |f: usize| {
            let face = polygons.faces.get(f)?;
            let n = face.len();
            let k = sides(face).position(|(i, j)| edge(i, j) == (a, b))?;
            face.get((k + 2) % n).copied()
        };
        // The first face walks from start to end.
        let forward = polygons.faces.get(f).is_some_and(|face| sides(face).any(|side| side == (a, b)));
        let (start, end) = if forward { (a, b) } else { (b, a) };
        let (Some(first), Some(second)) = (tip(f), tip(g)) else { continue };
        found.0.push(polygons.at(start));
        found.1.push(polygons.at(end));
        found.2.push(polygons.at(first));
        found.3.push(polygons.at(second));
    }
    Ok(found)
}

/// Sorts the vertices of a mesh by whether faces surround them. Stands for Kangaroo 2's NakedVertices.
#[component(
    "ddb24b31-1192-448f-ace3-b5b3d2399831",
    name = "NakedVertices",
    nick = "NV",
    at = "Kangaroo2/Mesh"
)]
#[output("ClothedI", "ClothedI", "The numbers of the vertices that faces surround.")]
#[output("NakedI", "NakedI", "The numbers of the vertices on naked edges.")]
#[output("ClothedPts", "ClothedPts", "The vertices that faces surround.")]
#[output("NakedPts", "NakedPts", "The vertices on naked edges.")]
fn naked_vertices(
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
) -> (Vec<i32>, Vec<i32>, Vec<Point3>, Vec<Point3>) {
    let merged = mesh.merged_indices();
    let mut naked = vec![false; merged.len()];
    for end in mesh.edges().iter().filter(|edge| edge.faces == 1).flat_map(|edge| edge.vertices) {
        if let Some(slot) = naked.get_mut(end as usize) {
            *slot = true;
        }
    }
    let mut found = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    for (i, (p, m)) in mesh.vertices().iter().zip(&merged).enumerate() {
        if naked.get(*m as usize).copied().unwrap_or(false) {
            found.1.push(number(i));
            found.3.push(*p);
        } else {
            found.0.push(number(i));
            found.2.push(*p);
        }
    }
    found
}

/// The corners of a mesh's boundary: naked vertices at which it turns by less than an angle inside. Stands for Kangaroo 2's
/// MeshCorners.
#[component("c8b01cec-6dd9-460b-b43f-254314ffdc2e", name = "MeshCorners", nick = "MC", at = "Kangaroo2/Mesh")]
#[output("Corners", "C", "The corners.")]
fn mesh_corners(
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
    /// The interior angle below which a naked vertex is a corner, in radians.
    #[port("Angle", "A", default = 2.0)]
    angle: f64,
) -> Vec<Point3> {
    let polygons = Polygons::of_mesh(mesh);
    let naked = polygons.naked_vertices();
    let mut sums = vec![0.0; polygons.points.len()];
    for face in &polygons.faces {
        let n = face.len();
        for (k, &i) in face.iter().enumerate() {
            let other =
                |k: usize| face.get(k % n).map_or(Vector3::ZERO, |&j| polygons.at(j) - polygons.at(i));
            if let (Some(sum), Some(turn)) = (sums.get_mut(i), other(k + 1).angle_to(other(k + n - 1))) {
                *sum += turn;
            }
        }
    }
    let corner = |(i, sum): &(usize, &f64)| naked.contains(i) && **sum < angle;
    sums.iter().enumerate().filter(corner).map(|(i, _)| polygons.at(i)).collect()
}

/// Begins each face of a mesh with its next corner. Stands for Kangaroo 2's MeshTurn.
#[component("bf54f98d-2fc0-4cb8-91b9-29619a2c6005", name = "MeshTurn", nick = "Turn", at = "Kangaroo2/Mesh")]
#[output("Mesh", "M", "The mesh.")]
fn mesh_turn(
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
) -> Result<Shared<Mesh>, Message> {
    let turn = |face: &MeshFace| match *face {
        MeshFace::Triangle([a, b, c]) => MeshFace::Triangle([b, c, a]),
        MeshFace::Quad([a, b, c, d]) => MeshFace::Quad([b, c, d, a]),
    };
    let faces = mesh.faces().iter().map(turn).collect();
    let turned =
        Mesh::from_parts(mesh.vertices().to_vec(), faces, mesh.normals().to_vec(), mesh.colours().to_vec())?;
    Ok(Shared::new(turned))
}

/// Two values so that no neighbours have the same one; where that cannot be, some have. Breadth first from the first of each
/// piece.
fn two_colours(neighbours: &[Vec<usize>]) -> (Vec<i32>, bool) {
    let mut colours = vec![-1; neighbours.len()];
    let mut fits = true;
    for start in 0..neighbours.len() {
        if colours.get(start).is_none_or(|c| *c >= 0) {
            continue;
        }
        let mut queue = VecDeque::from([(start, 0)]);
        while let Some((i, colour)) = queue.pop_front() {
            match colours.get_mut(i) {
                Some(own) if *own < 0 => *own = colour,
                Some(own) => {
                    fits &= *own == colour;
                    continue;
                }
                None => continue,
            }
            queue.extend(neighbours.get(i).into_iter().flatten().map(|&j| (j, 1 - colour)));
        }
    }
    (colours, fits)
}

/// Gives the vertices of a mesh 0 and 1 so that no two on an edge have the same. Stands for Kangaroo 2's Bipartite.
#[component(
    "8cb1880b-464e-470e-87af-ea27ae95132d",
    name = "Bipartite",
    nick = "Bipartite",
    at = "Kangaroo2/Mesh"
)]
#[output("Assignments", "A", "0 or 1 for each vertex.")]
fn bipartite(
    context: &Context<'_>,
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
) -> Vec<i32> {
    let mut neighbours = vec![Vec::new(); mesh.vertices().len()];
    for edge in mesh.edges() {
        let [a, b] = edge.vertices.map(|i| i as usize);
        for (i, j) in [(a, b), (b, a)] {
            if let Some(own) = neighbours.get_mut(i) {
                own.push(j);
            }
        }
    }
    let (colours, fits) = two_colours(&neighbours);
    if !fits {
        context.warn("The vertices cannot be told apart by two values everywhere");
    }
    mesh.merged_indices().iter().map(|m| colours.get(*m as usize).copied().unwrap_or(0)).collect()
}

/// Gives the faces of a mesh 0 and 1 so that no two on an edge have the same. Stands for Kangaroo 2's Checkerboard.
#[component(
    "c0139ec9-4e5a-4978-ab5f-31f5deb9ba4e",
    name = "Checkerboard",
    nick = "Checkerboard",
    at = "Kangaroo2/Mesh"
)]
#[output("Assignments", "A", "0 or 1 for each face.")]
fn checkerboard(
    context: &Context<'_>,
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
) -> Vec<i32> {
    let polygons = Polygons::of_mesh(mesh);
    let mut neighbours = vec![Vec::new(); polygons.faces.len()];
    for faces in &polygons.edges().faces {
        for f in faces {
            if let Some(own) = neighbours.get_mut(*f) {
                own.extend(faces.iter().filter(|g| *g != f));
            }
        }
    }
    let (colours, fits) = two_colours(&neighbours);
    if !fits {
        context.warn("The faces cannot be told apart by two values everywhere");
    }
    colours
}

/// For each face of quads how far it is from flat: the distance of its diagonals by their mean length. Stands for Kangaroo 2's
/// PlanarityAnalysis.
#[component(
    "97253642-cb05-43e6-bc79-4bd0306441e5",
    name = "PlanarityAnalysis",
    nick = "PA",
    at = "Kangaroo2/Mesh"
)]
#[output("Mesh", "M", "The mesh, face by face, green where it is flat, red at the greatest value.")]
#[output("Planarity", "P", "The value of each face; 0 for triangles.")]
fn planarity_analysis(
    context: &Context<'_>,
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
    /// The value that is red.
    #[port("Max", "X", default = 0.01)]
    greatest: f64,
) -> Result<(Shared<Mesh>, Vec<f64>), Message> {
    context.bytes(mesh.faces().len().saturating_mul(200))?;
    let (mut points, mut faces, mut colours, mut values) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    for (f, face) in mesh.faces().iter().enumerate() {
        let corners = mesh.face_points(f).unwrap_or_default();
        let value = match *corners.as_slice() {
            [a, b, c, d] => {
                let (u, v) = (c - a, d - b);
                let distance = u.cross(v).unitized().map_or(0.0, |n| (b - a).dot(n).abs());
                let mean = 0.5 * (u.length() + v.length());
                if mean > 0.0 { distance / mean } else { 0.0 }
            }
            _ => 0.0,
        };
        let share = if greatest > 0.0 {
            (value / greatest).clamp(0.0, 1.0)
        } else {
            f64::from(u8::from(value > 0.0))
        };
        let red = (255.0 * share).round() as u8;
        let first =
            u32::try_from(points.len()).map_err(|_| Message::error("The mesh has too many vertices"))?;
        faces.push(match face {
            MeshFace::Triangle(_) => MeshFace::Triangle([first, first + 1, first + 2]),
            MeshFace::Quad(_) => MeshFace::Quad([first, first + 1, first + 2, first + 3]),
        });
        colours.extend(corners.iter().map(|_| [red, 255 - red, 0, 255]));
        points.extend(corners);
        values.push(value);
    }
    Ok((Shared::new(Mesh::from_parts(points, faces, Vec::new(), colours)?.with_normals()), values))
}

/// A vertex of a mesh, its neighbours along edges, and its normal. Stands for Kangaroo 2's VertexNeighbours.
#[component(
    "fecd8879-9e63-4ff9-a16e-fe85bb0de884",
    name = "VertexNeighbours",
    nick = "VN",
    at = "Kangaroo2/Mesh"
)]
#[output("Centre", "C", "The vertex.")]
#[output("Neighbours", "N", "Its neighbours, in order around it.")]
#[output("Normal", "V", "The normal of the mesh there.")]
fn vertex_neighbours(
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
    /// The number of the vertex.
    #[port("Vertex", "V", default = 0)]
    vertex: i32,
) -> Result<(Point3, Vec<Point3>, Vector3), Message> {
    let centre = usize::try_from(vertex).ok().and_then(|i| mesh.vertices().get(i)).copied();
    let centre = centre.ok_or_else(|| Message::error(format!("The mesh has no vertex {vertex}")))?;
    let polygons = Polygons::of_mesh(mesh);
    let Some(own) = polygons.points.iter().position(|p| *p == centre) else {
        return Ok((centre, Vec::new(), Vector3::ZERO));
    };
    let ring = polygons.rings().into_iter().nth(own).unwrap_or_default();
    let normal = polygons.point_normals().get(own).copied().unwrap_or(Vector3::ZERO);
    Ok((centre, ring.into_iter().map(|i| polygons.at(i)).collect(), normal))
}

/// The edges of a mesh of quads in two lists: those that run one way, and those that cross them. Stands for Kangaroo 2's
/// WarpWeft.
#[component(
    "cb7c0f04-123f-4b12-8f81-583b9fc793be",
    name = "WarpWeft",
    nick = "WarpWeft",
    at = "Kangaroo2/Mesh"
)]
#[output("A", "A", "The lines in the direction of the first edge.")]
#[output("B", "B", "The lines across.")]
#[output("NA", "NA", "For each line in A whether it is on the boundary.")]
#[output("NB", "NB", "For each line in B whether it is on the boundary.")]
fn warp_weft(
    context: &Context<'_>,
    /// The mesh; edges of faces that are no quads are left where they come.
    #[port("Mesh", "M")]
    mesh: &Mesh,
) -> Result<(Vec<Line>, Vec<Line>, Vec<bool>, Vec<bool>), Message> {
    let polygons = Polygons::of_mesh(mesh);
    let edges = polygons.edges();
    context.items(edges.list.len())?;
    let mut kinds: Vec<Option<bool>> = vec![None; edges.list.len()];
    let mut fits = true;
    for start in 0..edges.list.len() {
        if kinds.get(start).is_none_or(Option::is_some) {
            continue;
        }
        let mut queue = VecDeque::from([(start, false)]);
        while let Some((e, kind)) = queue.pop_front() {
            match kinds.get_mut(e) {
                Some(own @ None) => *own = Some(kind),
                Some(Some(own)) => {
                    fits &= *own == kind;
                    continue;
                }
                None => continue,
            }
            for face in edges.faces.get(e).into_iter().flatten().filter_map(|&f| polygons.faces.get(f)) {
                let around: Vec<usize> = sides(face).filter_map(|(a, b)| edges.number(a, b)).collect();
                let (4, Some(at)) = (around.len(), around.iter().position(|own| *own == e)) else { continue };
                queue.extend(around.iter().enumerate().map(|(k, own)| (*own, kind != ((k + at) % 2 == 1))));
            }
        }
    }
    if !fits {
        context.warn("The edges cannot be told apart everywhere");
    }
    let mut found = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    for (e, &(a, b)) in edges.list.iter().enumerate() {
        let line = Line::new(polygons.at(a), polygons.at(b));
        if kinds.get(e).copied().flatten() == Some(true) {
            found.1.push(line);
            found.3.push(edges.is_naked(e));
        } else {
            found.0.push(line);
            found.2.push(edges.is_naked(e));
        }
    }
    Ok(found)
}

/// The strips of quads that a mesh divides into: across opposite edges from quad to quad.
fn strips(polygons: &Polygons) -> Vec<Vec<usize>> {
    let edges = polygons.edges();
    let mut taken = vec![false; polygons.faces.len()];
    let opposite = |f: usize, e: usize| -> Option<usize> {
        let around: Vec<usize> =
            sides(polygons.faces.get(f)?).filter_map(|(a, b)| edges.number(a, b)).collect();
        let at = around.iter().position(|own| *own == e)?;
        (around.len() == 4).then(|| around.get((at + 2) % 4).copied()).flatten()
    };
    let beyond = |f: usize, e: usize| match edges.faces.get(e).map(Vec::as_slice) {
        Some([a, b]) => Some(if *a == f { *b } else { *a }),
        _ => None,
    };
    let mut strips = Vec::new();
    for start in 0..polygons.faces.len() {
        if taken.get(start).is_none_or(|t| *t) {
            continue;
        }
        let mut strip = VecDeque::from([start]);
        if let Some(t) = taken.get_mut(start) {
            *t = true;
        }
        let first = polygons.faces.get(start).and_then(|face| sides(face).next());
        let first = first.and_then(|(a, b)| edges.number(a, b));
        let exits = first.map(|e| [opposite(start, e), Some(e)]).unwrap_or_default();
        for (k, exit) in exits.into_iter().enumerate() {
            let (mut face, mut exit) = (start, exit);
            while let Some(e) = exit {
                let Some(next) = beyond(face, e) else { break };
                match taken.get_mut(next) {
                    Some(t) if !*t && polygons.faces.get(next).is_some_and(|face| face.len() == 4) => {
                        *t = true
                    }
                    _ => break,
                }
                if k == 0 {
                    strip.push_back(next);
                } else {
                    strip.push_front(next);
                }
                exit = opposite(next, e);
                face = next;
            }
        }
        strips.push(strip.into());
    }
    strips
}

/// Divides a mesh into strips of quads that follow one another across opposite edges. Stands for Kangaroo 2's Stripper; that a
/// strip crosses the first edge of its first face is our reading.
#[component(
    "c8514ca2-3243-487a-becc-c07a4083db94",
    name = "Stripper",
    nick = "Stripper",
    at = "Kangaroo2/Mesh"
)]
#[output("Strips", "S", "A mesh for each strip.")]
fn stripper(
    context: &Context<'_>,
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
) -> Result<Vec<Shared<Mesh>>, Message> {
    let polygons = Polygons::of_mesh(mesh);
    context.items(polygons.faces.len())?;
    let part = |strip: Vec<usize>| {
        let loops: Vec<Vec<Point3>> = strip
            .iter()
            .filter_map(|&f| polygons.faces.get(f))
            .map(|face| face.iter().map(|&i| polygons.at(i)).collect())
            .collect();
        Ok(Shared::new(Polygons::of_loops(&loops).to_mesh(context)?))
    };
    strips(&polygons).into_iter().map(part).collect()
}

/// Unrolls a strip of faces into the plane of its first face: each is turned about the edge that it shares with the one before.
/// Stands for Kangaroo 2's Unroller.
#[component(
    "dca330b6-f705-4d5e-b9d4-ea90c915ddaf",
    name = "Unroller",
    nick = "Unroller",
    at = "Kangaroo2/Mesh"
)]
#[output("Unrolled", "U", "The unrolled strip.")]
fn unroller(
    context: &Context<'_>,
    /// The strip; faces that lie in a ring or branch are turned by the first way that leads to them.
    #[port("Mesh", "M")]
    mesh: &Mesh,
    /// How far it is unrolled: 0 as it is, 1 flat.
    #[port("Unroll", "T", default = 1.0)]
    share: f64,
) -> Result<Shared<Mesh>, Message> {
    if !share.is_finite() {
        return Err(Message::error("The share is not finite"));
    }
    let polygons = Polygons::of_mesh(mesh);
    let edges = polygons.edges();
    // The corners of each face in space once it is turned.
    let mut placed: HashMap<usize, Vec<Point3>> = HashMap::new();
    let corners = |f: usize| -> Vec<Point3> {
        polygons.faces.get(f).into_iter().flatten().map(|&i| polygons.at(i)).collect()
    };
    for start in 0..polygons.faces.len() {
        if placed.contains_key(&start) {
            continue;
        }
        placed.insert(start, corners(start));
        let mut queue = VecDeque::from([start]);
        while let Some(f) = queue.pop_front() {
            context.check()?;
            let Some(face) = polygons.faces.get(f) else { continue };
            for (k, (a, b)) in sides(face).enumerate() {
                let beside = edges.number(a, b).and_then(|e| edges.faces.get(e)).into_iter().flatten();
                for &g in beside.filter(|g| **g != f) {
                    if placed.contains_key(&g) {
                        continue;
                    }
                    let own = placed.get(&f).cloned().unwrap_or_default();
                    let (Some(&p), Some(&q)) = (own.get(k), own.get((k + 1) % face.len().max(1))) else {
                        continue;
                    };
                    // Where the neighbour is once the part before it is turned, then about the edge.
                    let before = carried(&corners(f), &own, &corners(g));
                    placed.insert(g, turned(&own, [p, q], &before, share));
                    queue.push_back(g);
                }
            }
        }
    }
    let loops: Vec<Vec<Point3>> = (0..polygons.faces.len()).filter_map(|f| placed.remove(&f)).collect();
    // Corners that were one stay one where the faces still touch.
    let mut flat = Polygons::of_loops(&rounded(&loops));
    if flat.faces.len() != loops.len() {
        flat = Polygons::of_loops(&loops);
    }
    Ok(Shared::new(flat.to_mesh(context)?))
}

/// Points moved as a rigid body that takes three points of `from` to those of `to`.
fn carried(from: &[Point3], to: &[Point3], points: &[Point3]) -> Vec<Point3> {
    let frame = |p: &[Point3]| match p {
        [a, b, c, ..] => katydid_geometry::Plane::from_points(*a, *b, *c).ok(),
        _ => None,
    };
    match (frame(from), frame(to)) {
        (Some(a), Some(b)) => {
            let map = katydid_geometry::Xform::plane_to_plane(&a, &b);
            points.iter().map(|p| map.point(*p)).collect()
        }
        _ => points.to_vec(),
    }
}

/// Points of a face turned about an edge so that it comes into the plane of its neighbour, by a share of the way.
fn turned(neighbour: &[Point3], [p, q]: [Point3; 2], face: &[Point3], share: f64) -> Vec<Point3> {
    let off = |points: &[Point3]| {
        let middle = Point3::mean(points)? - p;
        middle.rejected_from(q - p)
    };
    let (Some(own), Some(other), Some(axis)) = (off(face), off(neighbour), (q - p).unitized()) else {
        return face.to_vec();
    };
    let Some(angle) = own.signed_angle_to(-other, axis) else { return face.to_vec() };
    match katydid_geometry::Xform::rotation(angle * share, axis, p) {
        Ok(map) => face.iter().map(|p| map.point(*p)).collect(),
        Err(_) => face.to_vec(),
    }
}

/// Points within rounding of one before them are put there.
fn rounded(loops: &[Vec<Point3>]) -> Vec<Vec<Point3>> {
    let size = loops.iter().flatten().map(|p| p.to_vector().length()).fold(0.0, f64::max);
    let cell = (size * SAME_CORNER).max(SMALLEST_CELL);
    let mut first: HashMap<[i64; 3], Point3> = HashMap::new();
    loops
        .iter()
        .map(|corners| {
            corners
                .iter()
                .map(|p| {
                    let key = [p.x, p.y, p.z].map(|x| (x / cell).round() as i64);
                    let near = (0..27).find_map(|k| {
                        let d = [k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1];
                        first.get(&[key[0] + d[0], key[1] + d[1], key[2] + d[2]]).copied()
                    });
                    near.unwrap_or_else(|| *first.entry(key).or_insert(*p))
                })
                .collect()
        })
        .collect()
}
