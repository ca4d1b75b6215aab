//! Polygons that share corners: what meshes are while faces of any number of corners come and go.

use std::collections::{HashMap, HashSet};

use katydid_component::{Context, Message};
use katydid_geometry::{Mesh, MeshFace, Point3, Vector3};

/// Points, and faces by the numbers of their corners.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Polygons {
    pub(crate) points: Vec<Point3>,
    pub(crate) faces: Vec<Vec<usize>>,
}

/// An edge: its ends with the smaller number first.
pub(crate) type Edge = (usize, usize);

/// The edge between two corners.
pub(crate) fn edge(a: usize, b: usize) -> Edge {
    (a.min(b), a.max(b))
}

/// The edges of polygons with the faces along them, in the order in which faces name them first.
#[derive(Debug, Clone, Default)]
pub(crate) struct Edges {
    pub(crate) list: Vec<Edge>,
    pub(crate) faces: Vec<Vec<usize>>,
    numbers: HashMap<Edge, usize>,
}

impl Edges {
    /// The number of the edge between two corners.
    pub(crate) fn number(&self, a: usize, b: usize) -> Option<usize> {
        self.numbers.get(&edge(a, b)).copied()
    }

    /// Whether only one face has the edge.
    pub(crate) fn is_naked(&self, number: usize) -> bool {
        self.faces.get(number).is_some_and(|faces| faces.len() == 1)
    }
}

/// Consecutive corners of a face, the last with the first.
pub(crate) fn sides(face: &[usize]) -> impl Iterator<Item = (usize, usize)> + '_ {
    face.iter().copied().zip(face.iter().copied().cycle().skip(1))
}

impl Polygons {
    /// The faces of a mesh, vertices in one place taken as one; faces that use a corner twice lose it.
    pub(crate) fn of_mesh(mesh: &Mesh) -> Self {
        let first = mesh.merged_indices();
        let mut numbers = vec![usize::MAX; first.len()];
        let mut polygons = Self::default();
        for face in mesh.faces() {
            let mut corners: Vec<usize> = Vec::with_capacity(4);
            for &i in face.indices() {
                let own = first.get(i as usize).map_or(0, |m| *m as usize);
                let (Some(slot), Some(p)) = (numbers.get_mut(own), mesh.vertices().get(own)) else {
                    continue;
                };
                if *slot == usize::MAX {
                    *slot = polygons.points.len();
                    polygons.points.push(*p);
                }
                if !corners.contains(slot) {
                    corners.push(*slot);
                }
            }
            if corners.len() > 2 {
                polygons.faces.push(corners);
            }
        }
        polygons
    }

    /// Polygons by their corners in space; corners in one place are one.
    pub(crate) fn of_loops(loops: &[Vec<Point3>]) -> Self {
        let mut numbers: HashMap<[u64; 3], usize> = HashMap::new();
        let mut polygons = Self::default();
        for corners in loops {
            let mut face: Vec<usize> = Vec::with_capacity(corners.len());
            for p in corners {
                let key = [p.x + 0.0, p.y + 0.0, p.z + 0.0].map(f64::to_bits);
                let next = polygons.points.len();
                let i = *numbers.entry(key).or_insert(next);
                if i == next {
                    polygons.points.push(*p);
                }
                if !face.contains(&i) {
                    face.push(i);
                }
            }
            if face.len() > 2 {
                polygons.faces.push(face);
            }
        }
        polygons
    }

    /// The point of a number.
    pub(crate) fn at(&self, i: usize) -> Point3 {
        self.points.get(i).copied().unwrap_or(Point3::ORIGIN)
    }

    /// The mean of the corners of a face.
    pub(crate) fn middle(&self, face: &[usize]) -> Point3 {
        let points: Vec<Point3> = face.iter().map(|&i| self.at(i)).collect();
        Point3::mean(&points).unwrap_or(Point3::ORIGIN)
    }

    /// Twice the area of a face times its normal.
    pub(crate) fn area_vector(&self, face: &[usize]) -> Vector3 {
        let origin = face.first().map_or(Point3::ORIGIN, |&i| self.at(i));
        sides(face).fold(Vector3::ZERO, |sum, (a, b)| sum + (self.at(a) - origin).cross(self.at(b) - origin))
    }

    /// The mean of the normals of the faces at each point, by area; zero where there is none.
    pub(crate) fn point_normals(&self) -> Vec<Vector3> {
        let mut sums = vec![Vector3::ZERO; self.points.len()];
        for face in &self.faces {
            let normal = self.area_vector(face).unitized().unwrap_or(Vector3::ZERO);
            for &i in face {
                if let Some(sum) = sums.get_mut(i) {
                    *sum += normal;
                }
            }
        }
        sums.into_iter().map(|sum| sum.unitized().unwrap_or(Vector3::ZERO)).collect()
    }

    /// The edges with the faces along them.
    pub(crate) fn edges(&self) -> Edges {
        let mut edges = Edges::default();
        for (f, face) in self.faces.iter().enumerate() {
            for (a, b) in sides(face) {
                let key = edge(a, b);
                let next = edges.list.len();
                let number = *edges.numbers.entry(key).or_insert(next);
                if number == next {
                    edges.list.push(key);
                    edges.faces.push(Vec::with_capacity(2));
                }
                if let Some(faces) = edges.faces.get_mut(number) {
                    faces.push(f);
                }
            }
        }
        edges
    }

    /// The points on naked edges.
    pub(crate) fn naked_vertices(&self) -> HashSet<usize> {
        let edges = self.edges();
        let naked = edges.list.iter().zip(&edges.faces).filter(|(_, faces)| faces.len() == 1);
        naked.flat_map(|((a, b), _)| [*a, *b]).collect()
    }

    /// The points that share an edge with each point, in order around it where its faces are in order.
    pub(crate) fn rings(&self) -> Vec<Vec<usize>> {
        // For each point: from the corner before it in a face to the corner after it.
        let mut turns: Vec<Vec<(usize, usize)>> = vec![Vec::new(); self.points.len()];
        for face in &self.faces {
            let n = face.len();
            for (k, &i) in face.iter().enumerate() {
                let (Some(&before), Some(&after)) = (face.get((k + n - 1) % n), face.get((k + 1) % n)) else {
                    continue;
                };
                if let Some(own) = turns.get_mut(i) {
                    own.push((after, before));
                }
            }
        }
        turns.into_iter().map(|turns| ring(&turns)).collect()
    }

    /// A mesh: triangles and quads as they are, others as a fan about their middle.
    ///
    /// # Errors
    /// More vertices than an index can count; a point is not finite.
    pub(crate) fn to_mesh(&self, context: &Context<'_>) -> Result<Mesh, Message> {
        /// Corners, a vertex and its normal.
        const BYTES: usize = 100;
        let corners: usize = self.faces.iter().map(Vec::len).sum();
        context.bytes(corners.saturating_mul(BYTES / 2))?;
        let mut points = self.points.clone();
        let mut faces = Vec::with_capacity(self.faces.len());
        let number =
            |i: usize| u32::try_from(i).map_err(|_| Message::error("The mesh has too many vertices"));
        for face in &self.faces {
            match *face.as_slice() {
                [a, b, c] => faces.push(MeshFace::Triangle([number(a)?, number(b)?, number(c)?])),
                [a, b, c, d] => faces.push(MeshFace::Quad([number(a)?, number(b)?, number(c)?, number(d)?])),
                _ => {
                    let middle = number(points.len())?;
                    points.push(self.middle(face));
                    for (a, b) in sides(face) {
                        faces.push(MeshFace::Triangle([number(a)?, number(b)?, middle]));
                    }
                }
            }
        }
        Ok(Mesh::new(points, faces)?.with_normals())
    }
}

/// Neighbours in order: `turns` leads from each to the next.
fn ring(turns: &[(usize, usize)]) -> Vec<usize> {
    let next: HashMap<usize, usize> = turns.iter().copied().collect();
    let reached: HashSet<usize> = turns.iter().map(|turn| turn.1).collect();
    // An open ring begins with what nothing leads to.
    let Some(start) =
        turns.iter().map(|turn| turn.0).find(|a| !reached.contains(a)).or(turns.first().map(|t| t.0))
    else {
        return Vec::new();
    };
    let mut ring = vec![start];
    let mut seen = HashSet::from([start]);
    let mut at = start;
    while let Some(&to) = next.get(&at) {
        if !seen.insert(to) {
            break;
        }
        ring.push(to);
        at = to;
    }
    // Faces that do not hang together around the point.
    for (a, b) in turns {
        for i in [*a, *b] {
            if seen.insert(i) {
                ring.push(i);
            }
        }
    }
    ring
}
