//! Wb Transform: faces made smaller, with frames, windows, bevels and peaks; meshes moved off and made thick.

use std::collections::HashMap;

use katydid_component::{Context, List, Message, component};
use katydid_data::Value;
use katydid_geometry::{Point3, Vector3};

use super::{bodies, each, given, outlines};
use crate::polygons::{Polygons, sides};

/// How far the new corners of a face are from the old.
#[derive(Debug, Clone, Copy)]
enum Inset {
    /// A part of the length of the edges, in percent.
    Percent,
    /// A distance along the edges: the fourth corner of a parallelogram.
    Parallelogram,
}

impl Inset {
    fn of(number: i32) -> Result<Self, Message> {
        match number {
            0 => Ok(Self::Percent),
            1 => Ok(Self::Parallelogram),
            _ => Err(Message::error(format!("There is no inset {number}: 0 is percent, 1 parallelogram"))),
        }
    }

    /// The step from a corner along an edge.
    fn along(self, edge: Vector3, distance: f64) -> Vector3 {
        match self {
            Self::Percent => edge * (distance / 100.0),
            Self::Parallelogram => edge.unitized().unwrap_or(Vector3::ZERO) * distance,
        }
    }
}

/// The distances of a list by the number of the element: the last one goes on.
struct Distances(Vec<f64>);

impl Distances {
    fn new(list: &List<'_, f64>) -> Result<Self, Message> {
        let values: Vec<f64> = list.present().collect();
        if values.is_empty() || values.iter().any(|d| !d.is_finite()) {
            return Err(Message::error("The distances are not numbers"));
        }
        Ok(Self(values))
    }

    fn at(&self, i: usize) -> f64 {
        self.0.get(i).or(self.0.last()).copied().unwrap_or(0.0)
    }
}

/// The corners of a face with the steps along the edges before and after each.
fn steps(
    polygons: &Polygons,
    face: &[usize],
    inset: Inset,
    distance: f64,
) -> Vec<(Point3, Vector3, Vector3)> {
    let n = face.len();
    let at = |k: usize| face.get(k % n.max(1)).map_or(Point3::ORIGIN, |&i| polygons.at(i));
    (0..n)
        .map(|k| {
            let here = at(k);
            let step = |k: usize| inset.along(at(k) - here, distance);
            (here, step(k + n - 1), step(k + 1))
        })
        .collect()
}

/// The corners of the smaller face in each face; numbers follow those of the points.
fn inner_faces(
    polygons: &Polygons,
    inset: Inset,
    distances: &Distances,
    points: &mut Vec<Point3>,
) -> Vec<Vec<usize>> {
    let inner = |(f, face): (usize, &Vec<usize>)| {
        let first = points.len();
        let corners = steps(polygons, face, inset, distances.at(f));
        points.extend(corners.iter().map(|(p, before, after)| *p + *before + *after));
        (first..points.len()).collect()
    };
    polygons.faces.iter().enumerate().map(inner).collect()
}

/// A quad on each side of each face, between it and the smaller face in it.
fn frames(polygons: &Polygons, inner: &[Vec<usize>], faces: &mut Vec<Vec<usize>>) {
    for (face, inner) in polygons.faces.iter().zip(inner) {
        for ((a, b), (c, d)) in sides(face).zip(sides(inner)) {
            faces.push(vec![a, b, d, c]);
        }
    }
}

/// Each face with a hole in it: a quad along each side. Stands for Weaverbird's Picture Frame.
fn picture_frame(polygons: &Polygons, inset: Inset, distances: &Distances) -> Polygons {
    let mut points = polygons.points.clone();
    let inner = inner_faces(polygons, inset, distances, &mut points);
    let mut faces = Vec::new();
    frames(polygons, &inner, &mut faces);
    Polygons { points, faces }
}

/// The same with the smaller face in the hole.
fn window(polygons: &Polygons, inset: Inset, distances: &Distances) -> Polygons {
    let mut points = polygons.points.clone();
    let inner = inner_faces(polygons, inset, distances, &mut points);
    let mut faces = Vec::new();
    frames(polygons, &inner, &mut faces);
    faces.extend(inner);
    Polygons { points, faces }
}

/// Smaller faces, a quad for each edge between them, and a face for each point; along naked edges a quad to the edge.
fn bevel_edges(polygons: &Polygons, inset: Inset, distances: &Distances) -> Polygons {
    let mut points = polygons.points.clone();
    let inner = inner_faces(polygons, inset, distances, &mut points);
    let edges = polygons.edges();
    let mut faces = inner.clone();
    // The corner in face f that belongs to point i.
    let corner = |f: usize, i: usize| {
        let k = polygons.faces.get(f)?.iter().position(|own| *own == i)?;
        inner.get(f)?.get(k).copied()
    };
    let walks = |f: usize, a: usize, b: usize| {
        polygons.faces.get(f).is_some_and(|face| sides(face).any(|side| side == (a, b)))
    };
    for (&(a, b), beside) in edges.list.iter().zip(&edges.faces) {
        let quad = match *beside.as_slice() {
            [f] => {
                let (a, b) = if walks(f, a, b) { (a, b) } else { (b, a) };
                Some([Some(a), Some(b), corner(f, b), corner(f, a)])
            }
            [f, g] => {
                let (f, g) = if walks(f, a, b) { (f, g) } else { (g, f) };
                Some([corner(f, b), corner(f, a), corner(g, a), corner(g, b)])
            }
            _ => None,
        };
        if let Some([Some(a), Some(b), Some(c), Some(d)]) = quad {
            faces.push(vec![a, b, c, d]);
        }
    }
    let boundary = polygons.naked_vertices();
    for (i, ring) in polygons.rings().into_iter().enumerate().filter(|(i, _)| !boundary.contains(i)) {
        // Between two neighbours in the ring lies a face: its corner at the point.
        let n = ring.len();
        let around = (0..n).filter_map(|k| {
            let (a, b) = (*ring.get(k)?, *ring.get((k + 1) % n)?);
            let beside = edges.number(i, a).and_then(|e| edges.faces.get(e))?;
            let face = beside
                .iter()
                .copied()
                .find(|f| polygons.faces.get(*f).is_some_and(|face| face.contains(&b)))?;
            corner(face, i)
        });
        let around: Vec<usize> = around.collect();
        if around.len() == n && n > 2 {
            faces.push(around);
        }
    }
    Polygons { points, faces }
}

/// Faces with their corners cut off, and a face in place of each point inside.
fn bevel_vertices(polygons: &Polygons, inset: Inset, distances: &Distances) -> Polygons {
    let edges = polygons.edges();
    let boundary = polygons.naked_vertices();
    let mut fine = Polygons::default();
    // The cut near one end of an edge.
    let mut cuts: HashMap<(usize, usize), usize> = HashMap::new();
    let mut cut = |a: usize, b: usize, points: &mut Vec<Point3>| {
        *cuts.entry((a, b)).or_insert_with(|| {
            let step = inset.along(polygons.at(b) - polygons.at(a), distances.at(a));
            points.push(polygons.at(a) + step);
            points.len() - 1
        })
    };
    for face in &polygons.faces {
        let mut around = Vec::with_capacity(2 * face.len());
        for (a, b) in sides(face) {
            around.push(cut(a, b, &mut fine.points));
            around.push(cut(b, a, &mut fine.points));
        }
        fine.faces.push(around);
    }
    for (i, ring) in polygons.rings().into_iter().enumerate() {
        let mut around: Vec<usize> = Vec::new();
        for j in ring {
            if edges.number(i, j).is_some() {
                around.push(cut(i, j, &mut fine.points));
            }
        }
        if around.len() > 2 && !boundary.contains(&i) {
            fine.faces.push(around);
        }
    }
    fine
}

/// At each corner a quad, along each side a quad, and a hole in the middle.
fn carpet(polygons: &Polygons, inset: Inset, distances: &Distances) -> Polygons {
    let mut fine = Polygons { points: polygons.points.clone(), faces: Vec::new() };
    for (f, face) in polygons.faces.iter().enumerate() {
        let corners = steps(polygons, face, inset, distances.at(f));
        let first = fine.points.len();
        for (p, before, after) in &corners {
            fine.points.extend([*p + *before, *p + *after, *p + *before + *after]);
        }
        let n = face.len();
        for (k, &corner) in face.iter().enumerate() {
            let (own, next) = (first + 3 * k, first + 3 * ((k + 1) % n));
            fine.faces.push(vec![corner, own + 1, own + 2, own]);
            fine.faces.push(vec![own + 1, next, next + 2, own + 2]);
        }
    }
    // Cuts of neighbours on one edge are in one place where the distances agree.
    let loops: Vec<Vec<Point3>> =
        fine.faces.iter().map(|face| face.iter().map(|&i| fine.at(i)).collect()).collect();
    Polygons::of_loops(&loops)
}

/// A peak over each face: a triangle for each side.
fn stellate(polygons: &Polygons, distances: &Distances) -> Polygons {
    let mut fine = Polygons { points: polygons.points.clone(), faces: Vec::new() };
    for (f, face) in polygons.faces.iter().enumerate() {
        let normal = polygons.area_vector(face).unitized().unwrap_or(Vector3::ZERO);
        let peak = fine.points.len();
        fine.points.push(polygons.middle(face) + normal * distances.at(f));
        fine.faces.extend(sides(face).map(|(a, b)| vec![a, b, peak]));
    }
    fine
}

macro_rules! inset {
    ($(#[$help:meta])* $function:ident, $guid:literal, $name:literal, $nick:literal, $distance:literal, $rule:expr) => {
        $(#[$help])*
        #[component($guid, name = $name, nick = $nick, at = "Weaverbird/Wb Transform")]
        #[output("OutMesh", "O", "The results: meshes from meshes, closed polylines from closed polylines.")]
        fn $function(
            context: &Context<'_>,
            /// Meshes, or closed polylines that are the faces of one body.
            #[port("Mesh/Curves", "M")]
            bodies: List<Value>,
            /// How far: one for all, or one for each element; the last one goes on.
            #[port("Distance", "D", default = $distance)]
            distances: List<f64>,
            /// What the distance is: 0 a part of the edges in percent, 1 a length along them in units.
            #[port("InsetType", "T", default = 0)]
            kind: i32,
        ) -> Result<Vec<Value>, Message> {
            let (inset, distances) = (Inset::of(kind)?, Distances::new(&distances)?);
            each(context, &bodies, |body| room(context, &body).map(|()| $rule(&body, inset, &distances)))
        }
    };
}

/// Asks for the room that several faces in place of each take.
fn room(context: &Context<'_>, polygons: &Polygons) -> Result<(), Message> {
    /// What a corner of a face becomes: two faces and three points.
    const BYTES: usize = 500;
    let corners: usize = polygons.faces.iter().map(Vec::len).sum();
    context.bytes(corners.saturating_mul(BYTES))
}

inset!(
    /// Puts a hole in each face: what is left is a frame of a quad along each side. Stands for Weaverbird's Picture Frame.
    picture_frame_component, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1b11", "Picture Frame", "wbFrame", 20.0, picture_frame
);
inset!(
    /// Puts a smaller face in each face, and a frame around it. Stands for Weaverbird's Mesh Window; that the smaller face is
    /// kept is our reading.
    mesh_window, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1b12", "Mesh Window", "wbWindow", 20.0, window
);
inset!(
    /// Makes faces smaller, and fills the gaps with a quad for each edge and a face for each vertex. Stands for Weaverbird's Bevel
    /// Edges.
    bevel_edges_component, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1b13", "Bevel Edges", "wbBevelEdges", 20.0, bevel_edges
);
inset!(
    /// Puts a quad at each corner and along each side of each face, and leaves a hole in the middle. Stands for Weaverbird's
    /// Sierpinski Carpet.
    sierpinski_carpet, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1b14", "Sierpinski Carpet", "wbCarpet", 33.333333333333336, carpet
);

/// Cuts off the vertices of a mesh: a face in place of each. Stands for Weaverbird's Bevel Vertices.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1b15",
    name = "Bevel Vertices",
    nick = "wbBevelVerts",
    at = "Weaverbird/Wb Transform"
)]
#[output("OutMesh", "O", "The results: meshes, or the closed polylines of their faces.")]
fn bevel_vertices_component(
    context: &Context<'_>,
    /// Meshes, or closed polylines that are the faces of one body.
    #[port("Mesh/Curves", "M")]
    items: List<Value>,
    /// How far: one for all, or one for each vertex; the last one goes on.
    #[port("Distance", "D", default = 20.0)]
    distances: List<f64>,
    /// What the distance is: 0 a part of the edges in percent, 1 a length along them in units.
    #[port("InsetType", "T", default = 0)]
    kind: i32,
    /// Whether meshes come out; else closed polylines.
    #[port("Output geometry as mesh", "M", default = true)]
    as_mesh: bool,
) -> Result<Vec<Value>, Message> {
    let (inset, distances) = (Inset::of(kind)?, Distances::new(&distances)?);
    let mut results = Vec::new();
    for body in bodies(&items)? {
        room(context, &body.polygons)?;
        let cut = bevel_vertices(&body.polygons, inset, &distances);
        results.extend(if as_mesh { given(context, &cut, false)? } else { outlines(&cut) });
    }
    Ok(results)
}

/// Puts a peak on each face: a triangle for each side. Stands for Weaverbird's Stellate/Cumulation.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1b16",
    name = "Stellate/Cumulation",
    nick = "wbStellate",
    at = "Weaverbird/Wb Transform"
)]
#[output("OutMesh", "O", "The results: meshes from meshes, closed polylines from closed polylines.")]
fn stellate_component(
    context: &Context<'_>,
    /// Meshes, or closed polylines that are the faces of one body.
    #[port("Mesh/Curves", "M")]
    bodies: List<Value>,
    /// How high the peaks are, in units: one for all, or one for each face; the last one goes on.
    #[port("Distance", "D", default = 1.0)]
    distances: List<f64>,
) -> Result<Vec<Value>, Message> {
    let distances = Distances::new(&distances)?;
    each(context, &bodies, |body| room(context, &body).map(|()| stellate(&body, &distances)))
}

/// Where the points go that move off along the normals.
fn moved(
    context: &Context<'_>,
    polygons: &Polygons,
    distances: &Distances,
    kind: i32,
) -> Result<Vec<Point3>, Message> {
    match kind {
        0 => {}
        1 | 2 => {
            context.tell(Message::remark("Only distances along the normals are supported: type 0 is used"))
        }
        _ => return Err(Message::error(format!("There is no offset {kind}: it must be from 0 to 2"))),
    }
    room(context, polygons)?;
    let normals = polygons.point_normals();
    Ok(polygons.points.iter().zip(normals).enumerate().map(|(i, (p, n))| *p + n * distances.at(i)).collect())
}

/// Moves a mesh off along its normals. Stands for Weaverbird's Offset Mesh, of which type 0 is supported.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1b17",
    name = "Offset Mesh",
    nick = "wbOffset",
    at = "Weaverbird/Wb Transform"
)]
#[output(
    "Output Mesh/Curves",
    "O",
    "The results: meshes from meshes, closed polylines from closed polylines."
)]
fn offset_mesh(
    context: &Context<'_>,
    /// Meshes, or closed polylines that are the faces of one body.
    #[port("Mesh/Curves", "M")]
    bodies: List<Value>,
    /// How far each vertex moves, in units: one for all, or one for each; the last one goes on.
    #[port("Distance", "D", default = 1.0)]
    distances: List<f64>,
    /// What the distance is: 0 along the normal of the vertex.
    #[port("OffsetType", "T", default = 0)]
    kind: i32,
) -> Result<Vec<Value>, Message> {
    let distances = Distances::new(&distances)?;
    each(context, &bodies, |body| {
        Ok(Polygons { points: moved(context, &body, &distances, kind)?, faces: body.faces })
    })
}

/// Gives a mesh a thickness: itself turned round, itself moved off along its normals, and a quad along each naked edge. Stands
/// for Weaverbird's Mesh Thicken, of which type 0 is supported.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1b18",
    name = "Mesh Thicken",
    nick = "wbThicken",
    at = "Weaverbird/Wb Transform"
)]
#[output(
    "Output Mesh/Curves",
    "O",
    "The results: meshes from meshes, closed polylines from closed polylines."
)]
fn mesh_thicken(
    context: &Context<'_>,
    /// Meshes, or closed polylines that are the faces of one body.
    #[port("Mesh/Curves", "M")]
    bodies: List<Value>,
    /// How thick it is at each vertex, in units: one for all, or one for each; the last one goes on.
    #[port("Distance", "D", default = 1.0)]
    distances: List<f64>,
    /// What the distance is: 0 along the normal of the vertex.
    #[port("OffsetType", "T", default = 0)]
    kind: i32,
) -> Result<Vec<Value>, Message> {
    let distances = Distances::new(&distances)?;
    each(context, &bodies, |body| {
        let far = moved(context, &body, &distances, kind)?;
        let n = body.points.len();
        let edges = body.edges();
        let mut thick = Polygons { points: body.points.clone(), faces: Vec::new() };
        thick.points.extend(far);
        // The face in front looks where its normals go; the one behind looks back.
        thick.faces.extend(body.faces.iter().map(|face| face.iter().rev().copied().collect::<Vec<_>>()));
        thick.faces.extend(body.faces.iter().map(|face| face.iter().map(|i| i + n).collect::<Vec<_>>()));
        for face in &body.faces {
            for (a, b) in sides(face) {
                if edges.number(a, b).is_some_and(|e| edges.is_naked(e)) {
                    thick.faces.push(vec![a, b, b + n, a + n]);
                }
            }
        }
        Ok(thick)
    })
}
