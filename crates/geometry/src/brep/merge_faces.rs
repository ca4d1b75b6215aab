//! Neighbouring faces in one plane made one.

use super::Brep;
use crate::{Continuity, Curve, Plane, Result, Tolerance, Vector3};

/// Faces that become one, with the plane that they lie in, its normal as that of the first face.
struct Group {
    faces: Vec<usize>,
    plane: Plane,
}

impl Brep {
    /// The brep with every set of neighbouring faces that lie in one plane within the tolerance made one face, and
    /// edges between two faces that run on without a kink made one edge along them. The others stay as they are; with
    /// nothing to merge the brep comes back as it is.
    ///
    /// # Errors
    /// The tolerance is not above 0, or the brep has faults.
    pub fn with_coplanar_faces_merged(&self, tolerance: &Tolerance) -> Result<Self> {
        let limit = tolerance.positive_distance()?;
        let groups = self.coplanar_groups(limit);
        if groups.is_empty() {
            return Ok(self.clone());
        }
        let taken: Vec<usize> = groups.iter().flat_map(|group| group.faces.iter().copied()).collect();
        let rest: Vec<usize> = (0..self.faces().len()).filter(|face| !taken.contains(face)).collect();
        let rest = self.sub_brep(&rest)?;
        let mut pieces = if rest.faces().is_empty() { Vec::new() } else { vec![rest] };
        for group in &groups {
            let border = crate::join_curves(&self.border(&group.faces)?, limit, false);
            let border =
                border.into_iter().map(|rim| from_a_kink(rim, tolerance)).collect::<Result<Vec<_>>>()?;
            let found = Self::planar_faces(&border, tolerance)?;
            if !found.left.is_empty() || found.breps.is_empty() {
                pieces.push(self.sub_brep(&group.faces)?);
                continue;
            }
            for made in found.breps {
                let along = made.faces().first().and_then(|_| made.face_surface(0)?.plane(limit));
                let agrees = along.is_none_or(|plane| plane.z_axis.dot(group.plane.z_axis) > 0.0);
                pieces.push(if agrees { made } else { made.flipped() });
            }
        }
        let joined = Self::join(&pieces, tolerance)?.breps;
        match joined.as_slice() {
            [one] => Ok(one.clone()),
            several => {
                // Parts that never hung together stay in one brep, as they were.
                let together = Self::merged(several);
                Ok(if together.is_valid() { together } else { self.clone() })
            }
        }
    }

    fn coplanar_groups(&self, limit: f64) -> Vec<Group> {
        let planes: Vec<Option<Plane>> =
            (0..self.faces().len()).map(|face| self.face_plane(face, limit)).collect();
        let mut seen = vec![false; planes.len()];
        let mut groups = Vec::new();
        for (first, plane) in planes.iter().enumerate() {
            let Some(plane) = plane.filter(|_| !seen[first]) else { continue };
            let mut faces = Vec::new();
            let mut stack = vec![first];
            while let Some(face) = stack.pop() {
                if std::mem::replace(&mut seen[face], true) {
                    continue;
                }
                faces.push(face);
                for mate in self.mates_of(face) {
                    let in_plane = planes.get(mate).copied().flatten().is_some_and(|own| {
                        own.z_axis.dot(plane.z_axis) > 0.0 && self.lies_in(mate, &plane, limit)
                    });
                    if in_plane && !seen[mate] {
                        stack.push(mate);
                    }
                }
            }
            if faces.len() > 1 {
                groups.push(Group { faces, plane });
            }
        }
        groups
    }

    /// The plane of a flat face, with the face's own normal.
    fn face_plane(&self, face: usize, limit: f64) -> Option<Plane> {
        let own = self.faces().get(face).filter(|face| !face.deleted)?;
        let surface = self.face_surface(face)?;
        let plane = surface.plane(limit)?;
        let [u, v] = crate::Direction::BOTH.map(|d| surface.domain(d).middle());
        let normal: Vector3 = surface.normal_at(u, v)?;
        let along = (normal.dot(plane.z_axis) > 0.0) != own.reversed;
        Some(if along { plane } else { plane.flipped() })
    }

    fn face_edges(&self, face: usize) -> impl Iterator<Item = (usize, usize)> + '_ {
        let loops = self.faces().get(face).map(|own| own.loops.as_slice()).unwrap_or_default();
        let trims = loops.iter().filter_map(|l| self.loops().get(*l)).flat_map(|chain| &chain.trims);
        trims.filter_map(|trim| Some((*trim, self.trims().get(*trim)?.edge?)))
    }

    fn lies_in(&self, face: usize, plane: &Plane, limit: f64) -> bool {
        let edges = self.face_edges(face).filter_map(|(_, edge)| self.edge_as_curve(edge).ok().flatten());
        edges.flat_map(|edge| edge.hull_points()).all(|p| plane.signed_distance(p).abs() <= limit)
    }

    /// The faces across the edges of a face that only two trims run along.
    fn mates_of(&self, face: usize) -> Vec<usize> {
        let mut out = Vec::new();
        for (trim, edge) in self.face_edges(face) {
            if let Some([a, b]) = self.edges().get(edge).map(|edge| edge.trims.as_slice()) {
                out.extend(self.face_of(if *a == trim { *b } else { *a }));
            }
        }
        out
    }

    /// The edges that only one of some faces has.
    fn border(&self, faces: &[usize]) -> Result<Vec<Curve>> {
        let mut uses = vec![0_usize; self.edges().len()];
        for (_, edge) in faces.iter().flat_map(|face| self.face_edges(*face)) {
            if let Some(count) = uses.get_mut(edge) {
                *count += 1;
            }
        }
        let mut out = Vec::new();
        for (edge, _) in uses.iter().enumerate().filter(|(_, count)| **count == 1) {
            out.extend(self.edge_as_curve(edge)?);
        }
        Ok(out)
    }
}

/// A closed curve that starts at one of its kinks, if it has any: no edge begins where nothing turns.
fn from_a_kink(rim: Curve, tolerance: &Tolerance) -> Result<Curve> {
    let domain = rim.domain();
    let turn = match (rim.tangent_at(domain.start), rim.tangent_at(domain.end)) {
        (Some(start), Some(end)) => end.angle_to(start).unwrap_or(0.0),
        _ => 0.0,
    };
    if !rim.is_closed() || turn > tolerance.angle {
        return Ok(rim);
    }
    let loose = Tolerance { absolute: f64::INFINITY, angle: tolerance.angle };
    match rim.discontinuities(Continuity::G1, &loose).first() {
        Some(kink) => rim.with_seam(*kink),
        None => Ok(rim),
    }
}

#[cfg(test)]
mod tests {
    use crate::construct::{box_brep, plane_surface};
    use crate::{Box3, Brep, Interval, Plane, Tolerance, Xform};

    fn tolerance() -> Tolerance {
        Tolerance { absolute: 1e-6, ..Tolerance::default() }
    }

    #[test]
    fn a_box_of_halves_becomes_a_box() {
        let range = |a: f64, b: f64| Interval::new(a, b);
        let half = |x: Interval| {
            let shape = Box3 { plane: Plane::XY, x, y: range(0.0, 2.0), z: range(0.0, 3.0) };
            box_brep(&shape).unwrap()
        };
        let without_shared = |x: Interval, at: f64| -> Brep {
            let whole = half(x);
            let inside = |face: &usize| {
                let plane = whole.face_surface(*face).unwrap().plane(1e-9).unwrap();
                plane.z_axis.x.abs() > 0.5 && (plane.origin.x - at).abs() < 1e-9
            };
            let kept: Vec<usize> = (0..6).filter(|face| !inside(face)).collect();
            assert_eq!(kept.len(), 5);
            whole.sub_brep(&kept).unwrap()
        };
        let halves = [without_shared(range(0.0, 1.0), 1.0), without_shared(range(1.0, 4.0), 1.0)];
        let joined = Brep::join(&halves, &tolerance()).unwrap().breps;
        assert_eq!((joined.len(), joined[0].faces().len()), (1, 10));
        let merged = joined[0].with_coplanar_faces_merged(&tolerance()).unwrap();
        assert_eq!(merged.faults(), []);
        assert_eq!((merged.faces().len(), merged.edges().len(), merged.vertices().len()), (6, 12, 8));
        assert!(merged.is_solid());
        let mesh = merged.mesh(&crate::MeshSettings::default()).unwrap().welded().unwrap();
        assert!((mesh.volume() - 24.0).abs() < 1e-9, "outward");
    }

    #[test]
    fn open_sheets_keep_their_side_and_others_stay() {
        let sheet = |a: f64, b: f64| {
            let made = plane_surface(&Plane::XY, Interval::new(a, b), Interval::new(0.0, 1.0)).unwrap();
            made.transformed(&Xform::rotation(0.5, crate::Vector3::X, crate::Point3::ORIGIN).unwrap())
                .unwrap()
        };
        let joined = Brep::join(&[sheet(0.0, 1.0), sheet(1.0, 2.0)], &tolerance()).unwrap().breps;
        let merged = joined[0].clone().flipped().with_coplanar_faces_merged(&tolerance()).unwrap();
        assert_eq!((merged.faces().len(), merged.edges().len()), (1, 4));
        let mesh = merged.mesh(&crate::MeshSettings::default()).unwrap().to_mesh().unwrap();
        assert!(mesh.normals()[0].z < 0.0, "{:?}", mesh.normals());
        let single = sheet(0.0, 1.0);
        assert_eq!(single.with_coplanar_faces_merged(&tolerance()).unwrap(), single);
    }
}
