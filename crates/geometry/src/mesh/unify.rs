//! Faces of a mesh that look to one side.

use std::collections::HashMap;

use super::{Mesh, MeshFace};
use crate::Result;

/// The sides of a face, each from the place of one corner to that of the next. Vertices in one place count as one.
fn sides<'a>(face: &'a MeshFace, merged: &'a [u32]) -> impl Iterator<Item = (u32, u32)> + 'a {
    let corner = |i: u32| merged.get(i as usize).copied().unwrap_or(i);
    let indices = face.indices();
    let next = indices.iter().cycle().skip(1);
    indices.iter().zip(next).map(move |(&a, &b)| (corner(a), corner(b)))
}

impl Mesh {
    /// The mesh with faces turned round until neighbours look to the same side, and how many were turned. The first face of each
    /// piece that hangs together gives the side; on a Möbius strip some neighbours differ still. Neighbours are walked from face
    /// to face, in O(n) for n faces; derived here.
    ///
    /// # Errors
    /// None for a mesh as it was made: the parts are put together again.
    ///
    /// ```
    /// use katydid_geometry::{Mesh, MeshFace, Point3};
    ///
    /// let points = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(|[x, y]| Point3::new(x, y, 0.0));
    /// let faces = vec![MeshFace::Triangle([0, 1, 2]), MeshFace::Triangle([0, 3, 2])];
    /// let (mesh, turned) = Mesh::new(points.to_vec(), faces)?.unified()?;
    /// assert_eq!(turned, 1);
    /// assert!(mesh.is_oriented());
    /// # Ok::<(), katydid_geometry::Error>(())
    /// ```
    pub fn unified(&self) -> Result<(Self, usize)> {
        let merged = self.merged_indices();
        let mut along: HashMap<(u32, u32), Vec<usize>> = HashMap::new();
        for (i, face) in self.faces.iter().enumerate() {
            for (a, b) in sides(face, &merged) {
                along.entry((a.min(b), a.max(b))).or_default().push(i);
            }
        }
        let mut flip: Vec<Option<bool>> = vec![None; self.faces.len()];
        for first in 0..flip.len() {
            let mut todo = vec![(first, false)];
            while let Some((i, turned)) = todo.pop() {
                match flip.get_mut(i) {
                    Some(place @ None) => *place = Some(turned),
                    _ => continue,
                }
                let Some(face) = self.faces.get(i) else { continue };
                for (a, b) in sides(face, &merged) {
                    for &j in along.get(&(a.min(b), a.max(b))).into_iter().flatten().filter(|&&j| j != i) {
                        let Some(other) = self.faces.get(j) else { continue };
                        // Neighbours that look to the same side walk their common side in opposite directions.
                        let same = sides(other, &merged).any(|side| side == (a, b));
                        todo.push((j, turned != same));
                    }
                }
            }
        }
        let turned = |i: usize| flip.get(i).copied().flatten().unwrap_or(false);
        let count = (0..flip.len()).filter(|&i| turned(i)).count();
        if count == 0 {
            return Ok((self.clone(), 0));
        }
        let faces = self.faces.iter().enumerate().map(|(i, f)| if turned(i) { f.flipped() } else { *f });
        let unified =
            Self::from_parts(self.vertices.clone(), faces.collect(), Vec::new(), self.colours.clone())?;
        Ok((unified.with_normals(), count))
    }
}
