//! Faces parted along edges, joined along two of them, and fins taken away.

use super::{Brep, Edge, Parts, Solidity};
use crate::{Error, Result, Tolerance};

impl Brep {
    /// The brep parted along some of its edges, as what still hangs together: at each of these edges every face gets an
    /// edge of its own. Seams, where a face meets itself, do not part.
    ///
    /// # Errors
    /// An edge does not exist.
    pub fn unjoined(&self, edges: &[usize]) -> Result<Vec<Self>> {
        let mut parts = self.parts().clone();
        for &edge in edges {
            if edge >= self.edges().len() {
                let why = format!("there is no edge {edge}");
                return Err(Error::Invalid { what: "brep", why });
            }
            // The trims of each face; the first face keeps the edge.
            let mut groups: Vec<(Option<usize>, Vec<usize>)> = Vec::new();
            for &trim in parts.edges.get(edge).map_or(&[] as &[usize], |edge| &edge.trims) {
                let owner = self.face_of(trim);
                match groups.iter_mut().find(|(own, _)| *own == owner) {
                    Some((_, trims)) => trims.push(trim),
                    None => groups.push((owner, vec![trim])),
                }
            }
            for (group, (_, trims)) in groups.into_iter().enumerate() {
                if group == 0 {
                    if let Some(own) = parts.edges.get_mut(edge) {
                        own.trims = trims;
                    }
                    continue;
                }
                let place = parts.edges.len();
                let Some(own) = parts.edges.get(edge) else { continue };
                let copy = Edge { trims: trims.clone(), ..own.clone() };
                for vertex in copy.vertices.iter().flatten() {
                    if let Some(vertex) = parts.vertices.get_mut(*vertex) {
                        vertex.edges.push(place);
                    }
                }
                for trim in trims {
                    if let Some(trim) = parts.trims.get_mut(trim) {
                        trim.edge = Some(place);
                    }
                }
                parts.edges.push(copy);
            }
        }
        parts.changed();
        Self::from_parts(parts)?.connected_components()
    }

    /// The brep with two of its naked edges, which run together within the tolerance, made one; `None` when they are
    /// not naked or do not run together. What encloses a volume then gets its normals outward.
    ///
    /// # Errors
    /// An edge does not exist, the tolerance is not above 0, or the result has faults.
    pub fn with_edges_joined(&self, a: usize, b: usize, tolerance: &Tolerance) -> Result<Option<Self>> {
        let limit = tolerance.positive_distance()?;
        if let Some(edge) = [a, b].into_iter().find(|edge| *edge >= self.edges().len()) {
            return Err(Error::Invalid { what: "brep", why: format!("there is no edge {edge}") });
        }
        let mut parts = self.parts().clone();
        if !parts.sew_two(a, b, limit) {
            return Ok(None);
        }
        parts.changed();
        parts.agree_faces();
        parts.measure_tolerances();
        let whole = Self::from_parts(parts)?;
        let faces: Vec<usize> = (0..whole.faces().len()).collect();
        Ok(Some(whole.sub_brep(&faces)?.checked()?.turned_outward()))
    }

    /// The brep without the faces that have a naked edge, again and again until none has one; `None` when nothing is
    /// left.
    ///
    /// # Errors
    /// As [`Brep::sub_brep`].
    pub fn without_fins(&self) -> Result<Option<Self>> {
        let mut brep = self.clone();
        loop {
            let naked = brep.naked_edges();
            if naked.is_empty() {
                return Ok(Some(brep).filter(|brep| !brep.faces().is_empty()));
            }
            let is_fin = |face: &usize| {
                brep.trims_of(*face).iter().any(|t| {
                    brep.trims().get(*t).and_then(|trim| trim.edge).is_some_and(|e| naked.contains(&e))
                })
            };
            let kept: Vec<usize> = (0..brep.faces().len()).filter(|face| !is_fin(face)).collect();
            if kept.is_empty() {
                return Ok(None);
            }
            if kept.len() == brep.faces().len() {
                return Ok(Some(brep));
            }
            brep = brep.sub_brep(&kept)?;
        }
    }
}

impl Parts {
    /// Says anew what follows from which faces share edges.
    fn changed(&mut self) {
        self.solidity = Solidity::Unknown;
        self.regions = None;
        self.set_kinds();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::brep::testing::{area, cube};

    #[test]
    fn boxes_come_apart_and_together() {
        let cube = cube();
        let one = cube.unjoined(&[0]).unwrap();
        assert_eq!(one.len(), 1);
        let open = &one[0];
        assert_eq!(open.naked_edges().len(), 2);
        assert!(open.faults().is_empty() && !open.is_solid());
        let naked = open.naked_edges();
        let closed = open.with_edges_joined(naked[0], naked[1], &Tolerance::default()).unwrap().unwrap();
        assert!(closed.is_solid());
        assert!((closed.volume_properties(1e-9, || true).unwrap().amount - 6.0).abs() < 1e-9);
        assert!(cube.with_edges_joined(0, 1, &Tolerance::default()).unwrap().is_none());
        // All edges of a face: the face and the rest.
        let lid: Vec<usize> = cube.trims_of(0).iter().filter_map(|t| cube.trims()[*t].edge).collect();
        let mut apart = cube.unjoined(&lid).unwrap();
        apart.sort_by_key(|brep| brep.faces().len());
        assert_eq!(apart.iter().map(|brep| brep.faces().len()).collect::<Vec<_>>(), [1, 5]);
        assert!((area(&apart[0]) + area(&apart[1]) - 22.0).abs() < 1e-9);
        let all: Vec<usize> = (0..cube.edges().len()).collect();
        assert_eq!(cube.unjoined(&all).unwrap().len(), 6);
        assert!(cube.unjoined(&[99]).is_err());
        assert!(cube.with_edges_joined(0, 99, &Tolerance::default()).is_err());
    }

    #[test]
    fn fins_go() {
        assert_eq!(cube().without_fins().unwrap().map(|brep| brep.faces().len()), Some(6));
        let five = cube().sub_brep(&[0, 1, 2, 3, 4]).unwrap();
        assert!(five.without_fins().unwrap().is_none());
    }
}
