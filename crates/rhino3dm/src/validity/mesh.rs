//! Meshes.

use std::collections::HashSet;

use katydid_geometry::Vector3;

use super::{Verdict, ngons};
use crate::MeshObject;
use crate::object::single;

/// The square of a normal's length.
const UNIT: std::ops::RangeInclusive<f32> = 0.985..=1.015;

/// Whether a mesh is valid: lists as long as they should be, normals of about length 1, and no face that uses a vertex,
/// or one place, twice. A face whose corners lie on a line is valid.
pub(super) fn verdict(mesh: &MeshObject) -> Verdict {
    let count = mesh.vertices.len();
    let inside = |face: &[u32; 4]| face.iter().all(|i| (*i as usize) < count);
    if let Some(i) = mesh.faces.iter().position(|face| !inside(face)) {
        return Err(format!("face {i} names a vertex that is not there"));
    }
    if mesh.faces.is_empty() {
        return Err("it has no faces".into());
    }
    if count < 3 {
        return Err(format!("it has {count} vertices"));
    }
    if let Some(i) = mesh.vertices.iter().position(|v| !v.iter().all(|x| x.is_finite())) {
        return Err(format!("vertex {i} is no number"));
    }
    let lists = [
        (mesh.double_vertices.len(), "double-precision vertices"),
        (mesh.normals.len(), "normals"),
        (mesh.texture_coordinates.len(), "texture coordinates"),
        (mesh.surface_parameters.len(), "surface parameters"),
    ];
    if let Some((length, name)) = lists.into_iter().find(|(length, _)| *length != 0 && *length != count) {
        return Err(format!("it has {length} {name} for {count} vertices"));
    }
    if let Some(i) = mesh.normals.iter().position(|n| !UNIT.contains(&n.iter().map(|x| x * x).sum())) {
        return Err(format!("normal {i} is not of length 1"));
    }
    faces(mesh)?;
    ngons::verdict(mesh)
}

fn faces(mesh: &MeshObject) -> Verdict {
    for (i, face) in mesh.faces.iter().enumerate() {
        let corners = corners(face);
        let twice = (1..corners.len()).any(|k| corners.iter().take(k).any(|c| corners.get(k) == Some(c)));
        if twice {
            return Err(format!("face {i} uses a vertex twice"));
        }
        let places: Vec<_> = corners.iter().map(|c| mesh.place(*c)).collect();
        if (1..places.len()).any(|k| places.iter().take(k).any(|p| places.get(k) == Some(p))) {
            return Err(format!("two corners of face {i} are in one place"));
        }
    }
    Ok(())
}

impl MeshObject {
    /// The mesh as openNURBS calls it valid. Corners of a face in one place become one, and faces with fewer than three
    /// are left out, with all polygons that faces were grouped to; normals that are not of length 1 are made so, from the
    /// faces around where they have no length, and upright where that gives none. None where there is no face left, or
    /// something else is wrong.
    pub fn made_valid(&self) -> Option<Self> {
        let mut mesh = self.clone();
        let kept: Vec<[u32; 4]> =
            self.faces.iter().filter_map(|face| self.with_distinct_corners(face)).collect();
        if kept != mesh.faces {
            mesh.faces = kept;
            mesh.ngons.clear();
        }
        mesh.set_unit_normals();
        verdict(&mesh).is_ok().then_some(mesh)
    }

    /// Where a vertex is.
    fn place(&self, i: u32) -> Option<[f64; 3]> {
        let i = i as usize;
        if self.double_vertices.is_empty() {
            return self.vertices.get(i).map(|v| v.map(f64::from));
        }
        self.double_vertices.get(i).copied()
    }

    /// The face with each place once; none where that leaves fewer than three.
    fn with_distinct_corners(&self, face: &[u32; 4]) -> Option<[u32; 4]> {
        let mut distinct: Vec<u32> = Vec::with_capacity(4);
        for &corner in corners(face) {
            let same = |other: &u32| *other == corner || self.place(*other) == self.place(corner);
            if !distinct.iter().any(same) {
                distinct.push(corner);
            }
        }
        match *distinct.as_slice() {
            [a, b, c] => Some([a, b, c, c]),
            [a, b, c, d] => Some([a, b, c, d]),
            _ => None,
        }
    }

    fn set_unit_normals(&mut self) {
        let is_unit = |n: &[f32; 3]| UNIT.contains(&n.iter().map(|x| x * x).sum());
        if self.normals.len() != self.vertices.len() || self.normals.iter().all(is_unit) {
            return;
        }
        let around = self.to_mesh().map(|mesh| mesh.vertex_normals()).unwrap_or_default();
        for (i, normal) in self.normals.iter_mut().enumerate().filter(|(_, normal)| !is_unit(normal)) {
            let own = Vector3::from(normal.map(f64::from)).unitized();
            let unit = own.or_else(|| around.get(i).and_then(|n| n.unitized())).unwrap_or(Vector3::Z);
            *normal = [unit.x, unit.y, unit.z].map(single);
        }
    }
}

/// The corners of a face: a triangle repeats its third.
pub(super) fn corners(face: &[u32; 4]) -> &[u32] {
    let [_, _, c, d] = face;
    if c == d { face.first_chunk::<3>().map_or(face.as_slice(), |three| three) } else { face }
}

/// Faces without area, and faces that are there twice.
pub(super) fn remarks(mesh: &MeshObject) -> Vec<String> {
    let mut remarks = Vec::new();
    if let Ok(kernel) = mesh.to_mesh() {
        let flat = kernel.face_normals().iter().filter(|normal| normal.length_squared() == 0.0).count();
        if flat > 0 {
            remarks.push(format!("{flat} of its faces have no area"));
        }
    }
    let mut seen = HashSet::new();
    let twice = mesh.faces.iter().filter(|face| {
        let mut corners = corners(face).to_vec();
        corners.sort_unstable();
        !seen.insert(corners)
    });
    match twice.count() {
        0 => {}
        count => remarks.push(format!("{count} of its faces are there twice")),
    }
    remarks
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mesh(faces: Vec<[u32; 4]>) -> MeshObject {
        let vertices = vec![[0.0; 3], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0; 3]];
        MeshObject { vertices, faces, ..MeshObject::default() }
    }

    #[test]
    fn no_area_is_a_remark_and_one_place_twice_a_fault() {
        let flat = mesh(vec![[0, 1, 2, 2]]);
        assert_eq!((verdict(&flat), remarks(&flat).len()), (Ok(()), 1));
        assert_eq!(verdict(&mesh(vec![[0, 1, 3, 3]])), Ok(()));
        for bad in [[0, 1, 4, 4], [0, 1, 1, 3], [0, 1, 9, 9], [0, 1, 0, 0]] {
            assert!(verdict(&mesh(vec![bad])).is_err(), "{bad:?}");
        }
        let mut normals = mesh(vec![[0, 1, 3, 3]]);
        normals.normals = vec![[0.0, 0.0, 0.9]; 5];
        assert!(verdict(&normals).is_err());
        let mended = normals.made_valid().unwrap();
        assert_eq!((verdict(&mended), mended.normals[2]), (Ok(()), [0.0, 0.0, 1.0]));
        let twice = mesh(vec![[0, 1, 3, 3], [1, 3, 0, 0]]);
        assert_eq!((verdict(&twice), remarks(&twice).len()), (Ok(()), 1));
    }

    #[test]
    fn what_is_invalid_is_left_out_or_mended() {
        // A quad with two corners in one place, a sliver with all corners in two places, and a sound face.
        let mut odd = mesh(vec![[0, 1, 3, 4], [0, 4, 1, 0], [1, 2, 3, 3]]);
        odd.normals = vec![[0.0; 3]; 5];
        assert!(verdict(&odd).is_err());
        let made = odd.made_valid().unwrap();
        assert_eq!(made.faces, [[0, 1, 3, 3], [1, 2, 3, 3]]);
        assert!(made.normals.iter().all(|n| *n == [0.0, 0.0, 1.0]));
        assert!(mesh(vec![[0, 4, 1, 0]]).made_valid().is_none());
        assert!(mesh(Vec::new()).made_valid().is_none());
        assert!(mesh(vec![[0, 1, 9, 9]]).made_valid().is_none());
    }
}
