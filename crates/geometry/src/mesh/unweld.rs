//! Meshes cut open along edges.

use std::collections::{BTreeSet, HashMap};

use super::Mesh;
use crate::{Error, Result};

impl Mesh {
    /// The mesh in which the faces on either side of some edges share no vertex there: at each corner of these edges the
    /// faces that still hang together across other edges keep one vertex. An edge is two places, each by any of the
    /// vertices there. Normals and colours are those of the vertices before.
    ///
    /// # Errors
    /// A vertex that does not exist, or two that no face joins.
    pub fn unwelded_along(&self, edges: &[[u32; 2]]) -> Result<Self> {
        let merged = self.merged_indices();
        let place = |i: u32| merged.get(i as usize).copied();
        let mut at_edge: HashMap<[u32; 2], Vec<(usize, usize)>> = HashMap::new();
        for (f, face) in self.faces.iter().enumerate() {
            let corners = face.indices();
            for (k, &i) in corners.iter().enumerate() {
                let next = corners[(k + 1) % corners.len()];
                if let (Some(a), Some(b)) = (place(i), place(next)) {
                    at_edge.entry([a.min(b), a.max(b)]).or_default().push((f, k));
                }
            }
        }
        let mut cut = BTreeSet::new();
        let mut open = BTreeSet::new();
        for &[a, b] in edges {
            let ends = place(a).zip(place(b)).map(|(a, b)| [a.min(b), a.max(b)]);
            let ends = ends.filter(|ends| at_edge.contains_key(ends));
            let [a, b] = ends.ok_or_else(|| Error::degenerate("edge of the mesh", "no face has it"))?;
            cut.insert([a, b]);
            open.extend([a, b]);
        }
        // Corners of faces at opened places, and which of them hang together.
        let mut corners: Vec<(usize, usize)> = Vec::new();
        let mut number: HashMap<(usize, usize), usize> = HashMap::new();
        for (f, face) in self.faces.iter().enumerate() {
            for (k, &i) in face.indices().iter().enumerate() {
                if place(i).is_some_and(|i| open.contains(&i)) {
                    number.insert((f, k), corners.len());
                    corners.push((f, k));
                }
            }
        }
        let mut group: Vec<usize> = (0..corners.len()).collect();
        for (ends, faces) in at_edge.iter().filter(|(ends, _)| !cut.contains(*ends)) {
            for end in ends.iter().filter(|end| open.contains(*end)) {
                let corner = |&(f, k): &(usize, usize)| {
                    let n = self.faces[f].indices().len();
                    let here = [k, (k + 1) % n].into_iter();
                    let mut here = here.filter(|k| place(self.faces[f].indices()[*k]) == Some(*end));
                    here.next().map(|k| (f, k))
                };
                let mut first = None;
                for own in faces.iter().filter_map(corner) {
                    // Faces that have vertices of their own already stay apart.
                    let vertex = self.faces[own.0].indices()[own.1];
                    let Some(&own) = number.get(&own) else { continue };
                    match first {
                        None => first = Some((own, vertex)),
                        Some((other, shared)) if shared == vertex => {
                            let (a, b) = (root(&mut group, own), root(&mut group, other));
                            group[a.max(b)] = a.min(b);
                        }
                        Some(_) => {}
                    }
                }
            }
        }
        let mut faces = self.faces.to_vec();
        let mut vertices = self.vertices.clone();
        let (mut normals, mut colours) = (self.normals.clone(), self.colours.clone());
        let mut taken: HashMap<u32, usize> = HashMap::new();
        let mut copies: HashMap<(u32, usize), u32> = HashMap::new();
        for (c, &(f, k)) in corners.iter().enumerate() {
            let old = self.faces[f].indices()[k];
            let own = root(&mut group, c);
            // The first group at a vertex keeps it.
            if *taken.entry(old).or_insert(own) == own {
                continue;
            }
            let new = *copies.entry((old, own)).or_insert_with(|| {
                let at = old as usize;
                vertices.push(self.vertices[at]);
                normals.extend(self.normals.get(at));
                colours.extend(self.colours.get(at));
                u32::try_from(vertices.len() - 1).unwrap_or(u32::MAX)
            });
            faces[f].set(k, new);
        }
        Self::from_parts(vertices, faces, normals, colours)
    }
}

/// The first of a group of corners.
fn root(group: &mut [usize], mut at: usize) -> usize {
    while group[at] != at {
        group[at] = group[group[at]];
        at = group[at];
    }
    at
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Interval, Plane, Rectangle};

    fn sheet() -> Mesh {
        let sides = Interval::new(0.0, 2.0);
        Mesh::plane(&Rectangle { plane: Plane::XY, x: sides, y: sides }, 2, 2).unwrap()
    }

    fn between(mesh: &Mesh, a: [f64; 2], b: [f64; 2]) -> [u32; 2] {
        let at = |p: [f64; 2]| {
            mesh.vertices().iter().position(|q| (q.x - p[0]).hypot(q.y - p[1]) < 1e-9).unwrap() as u32
        };
        [at(a), at(b)]
    }

    #[test]
    fn one_edge_opens_at_the_border_only() {
        let mesh = sheet();
        // From the border to the middle: the end at the border parts, the middle still hangs together round it.
        let one = mesh.unwelded_along(&[between(&mesh, [1.0, 0.0], [1.0, 1.0])]).unwrap();
        assert_eq!(one.vertices().len(), 10);
        // Across the whole: three places part.
        let all = [between(&mesh, [1.0, 0.0], [1.0, 1.0]), between(&mesh, [1.0, 1.0], [1.0, 2.0])];
        let both = mesh.unwelded_along(&all).unwrap();
        assert_eq!(both.vertices().len(), 12);
        assert_eq!(both.area(), mesh.area());
        assert_eq!(both.unwelded_along(&all).unwrap().vertices().len(), 12);
        assert_eq!(both.welded(1.0).vertices().len(), 9);
        assert!(mesh.unwelded_along(&[between(&mesh, [0.0, 0.0], [1.0, 1.0])]).is_err());
        assert!(mesh.unwelded_along(&[[0, 99]]).is_err());
    }
}
