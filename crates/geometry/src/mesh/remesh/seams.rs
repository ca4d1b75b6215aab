//! Where a mesh is not welded.

use std::collections::HashMap;

use crate::{Line, Mesh};

impl Mesh {
    /// The edges along which faces meet without sharing vertices, as those of different Brep faces do in the mesh of a
    /// Brep. Given an area, only those between different parts, each with at least that area, where a part is what shared
    /// vertices hold together.
    pub fn seams(&self, least_area: Option<f64>) -> Vec<Line> {
        let merged = self.merged_indices();
        let parts = self.welded_parts();
        let at = |v: u32| self.vertices().get(v as usize).copied().unwrap_or_default();
        let mut areas: HashMap<u32, f64> = HashMap::new();
        // Of each edge by places, the edges by vertices with the parts they belong to.
        let mut sides: HashMap<[u32; 2], Vec<([u32; 2], u32)>> = HashMap::new();
        for face in self.faces() {
            let ring = face.indices();
            let Some(&part) = ring.first().and_then(|v| parts.get(*v as usize)) else { continue };
            let area = |t: [u32; 3]| {
                let [a, b, c] = t.map(at);
                0.5 * (b - a).cross(c - a).length()
            };
            *areas.entry(part).or_default() += face.triangles().map(area).sum::<f64>();
            for k in 0..ring.len() {
                let own = [ring[k], ring[(k + 1) % ring.len()]];
                let [a, b] = own.map(|v| merged.get(v as usize).copied().unwrap_or(v));
                let key = [a.min(b), a.max(b)];
                let own = if a <= b { own } else { [own[1], own[0]] };
                sides.entry(key).or_default().push((own, part));
            }
        }
        let large = |part: u32, least: f64| areas.get(&part).is_some_and(|area| *area >= least);
        let is_seam = |all: &[([u32; 2], u32)]| {
            let Some(&(first, part)) = all.first() else { return false };
            match least_area {
                None => all.iter().any(|(own, _)| *own != first),
                Some(least) => {
                    all.iter().any(|(_, other)| *other != part) && all.iter().all(|(_, p)| large(*p, least))
                }
            }
        };
        let mut keys: Vec<[u32; 2]> =
            sides.into_iter().filter(|(_, all)| is_seam(all)).map(|(key, _)| key).collect();
        keys.sort_unstable();
        keys.into_iter().map(|[a, b]| Line::new(at(a), at(b))).collect()
    }

    /// Of each vertex the first vertex of its part, parts being faces that share vertices.
    fn welded_parts(&self) -> Vec<u32> {
        fn root(parents: &mut [u32], mut v: u32) -> u32 {
            while let Some(&up) = parents.get(v as usize)
                && up != v
            {
                let above = parents.get(up as usize).copied().unwrap_or(up);
                if let Some(slot) = parents.get_mut(v as usize) {
                    *slot = above;
                }
                v = above;
            }
            v
        }
        let mut parents: Vec<u32> = (0..self.vertices().len() as u32).collect();
        for face in self.faces() {
            for pair in face.indices().windows(2) {
                let [a, b] = [pair[0], pair[1]].map(|v| root(&mut parents, v));
                if let Some(slot) = parents.get_mut(a.max(b) as usize) {
                    *slot = a.min(b);
                }
            }
        }
        (0..parents.len() as u32).map(|v| root(&mut parents, v)).collect()
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use crate::construct::{box_brep, cylinder};
    use crate::{Box3, Cylinder, Interval, Line, Mesh, MeshSettings, Plane};

    fn total(lines: &[Line]) -> f64 {
        lines.iter().map(Line::length).sum()
    }

    #[test]
    fn seams_are_the_edges_of_the_brep() {
        let [x, y, z] = [2.0, 3.0, 4.0].map(|size| Interval::new(0.0, size));
        let cube = box_brep(&Box3 { plane: Plane::XY, x, y, z }).unwrap();
        let mesh = cube.mesh(&MeshSettings::default()).unwrap().to_mesh().unwrap();
        assert!((total(&mesh.seams(None)) - 36.0).abs() < 1e-9);
        // The faces have 6, 8 and 12: those of 6 count no more, and with them their edges.
        assert!((total(&mesh.seams(Some(7.0))) - 16.0).abs() < 1e-9);
        assert!(mesh.welded(PI).seams(None).is_empty());
        assert!(
            Mesh::cuboid(&Box3 { plane: Plane::XY, x, y, z }, 2, 2, 2)
                .unwrap()
                .welded(PI)
                .seams(None)
                .is_empty()
        );
        let tube = Cylinder::new(Plane::XY, 1.0, Interval::new(0.0, 5.0)).unwrap();
        let mesh = cylinder(&tube, [false; 2]).unwrap();
        let mesh = mesh.mesh(&MeshSettings::default()).unwrap().to_mesh().unwrap();
        // The line where the cylinder's surface closes.
        assert!((total(&mesh.seams(None)) - 5.0).abs() < 1e-9);
        assert!(mesh.seams(Some(0.0)).is_empty());
    }
}
