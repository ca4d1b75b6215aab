//! Some faces of a brep as a brep of their own, and several breps as one.

use super::{Brep, Parts, Solidity};
use crate::Result;

/// The new places of what is kept.
struct Kept {
    places: Vec<Option<usize>>,
    count: usize,
}

impl Kept {
    fn new(count: usize) -> Self {
        Self { places: vec![None; count], count: 0 }
    }

    fn keep(&mut self, old: usize) {
        if let Some(place @ None) = self.places.get_mut(old) {
            *place = Some(self.count);
            self.count += 1;
        }
    }

    fn new_place(&self, old: Option<usize>) -> Option<usize> {
        self.places.get(old?).copied().flatten()
    }

    fn each(&self, old: &[usize]) -> Vec<usize> {
        old.iter().filter_map(|place| self.new_place(Some(*place))).collect()
    }

    /// The kept ones of a list, in their new order.
    fn pick<T: Clone>(&self, list: &[T]) -> Vec<T> {
        let mut order: Vec<(usize, usize)> =
            self.places.iter().enumerate().filter_map(|(old, new)| Some(((*new)?, old))).collect();
        order.sort_unstable();
        order.into_iter().filter_map(|(_, old)| list.get(old).cloned()).collect()
    }
}

impl Brep {
    /// The given faces with what bounds them, in the order given: a copy without gaps in its lists. Edges that lose a
    /// neighbour become naked. Faces that do not exist are left out.
    ///
    /// # Errors
    /// Numbers that are not finite.
    pub fn sub_brep(&self, faces: &[usize]) -> Result<Self> {
        let parts = self.parts();
        let mut keep = [(); 8].map(|()| Kept::new(0));
        let lengths = [
            parts.faces.len(),
            parts.loops.len(),
            parts.trims.len(),
            parts.edges.len(),
            parts.vertices.len(),
            parts.curves_2d.len(),
            parts.curves_3d.len(),
            parts.surfaces.len(),
        ];
        keep.iter_mut().zip(lengths).for_each(|(kept, length)| *kept = Kept::new(length));
        let [keep_faces, loops, trims, edges, vertices, flat, space, surfaces] = &mut keep;
        for &place in faces {
            let Some(face) = parts.faces.get(place).filter(|face| !face.deleted) else { continue };
            keep_faces.keep(place);
            face.surface.into_iter().for_each(|s| surfaces.keep(s));
            for &chain in &face.loops {
                let Some(chain_parts) = parts.loops.get(chain).filter(|l| !l.deleted) else { continue };
                loops.keep(chain);
                for &trim in &chain_parts.trims {
                    let Some(own) = parts.trims.get(trim).filter(|t| !t.deleted) else { continue };
                    trims.keep(trim);
                    own.part.curve.into_iter().for_each(|c| flat.keep(c));
                    own.vertices.into_iter().flatten().for_each(|v| vertices.keep(v));
                    let Some(edge) = own.edge.and_then(|e| Some((e, parts.edges.get(e)?))) else { continue };
                    edges.keep(edge.0);
                    edge.1.part.curve.into_iter().for_each(|c| space.keep(c));
                    edge.1.vertices.into_iter().flatten().for_each(|v| vertices.keep(v));
                }
            }
        }
        let [keep_faces, loops, trims, edges, vertices, flat, space, surfaces] = &keep;
        let mut out = Parts {
            curves_2d: flat.pick(&parts.curves_2d),
            curves_3d: space.pick(&parts.curves_3d),
            surfaces: surfaces.pick(&parts.surfaces),
            vertices: vertices.pick(&parts.vertices),
            edges: edges.pick(&parts.edges),
            trims: trims.pick(&parts.trims),
            loops: loops.pick(&parts.loops),
            faces: keep_faces.pick(&parts.faces),
            solidity: Solidity::Unknown,
            regions: None,
        };
        out.vertices.iter_mut().for_each(|vertex| vertex.edges = edges.each(&vertex.edges));
        for edge in &mut out.edges {
            edge.part.curve = space.new_place(edge.part.curve);
            edge.vertices = edge.vertices.map(|v| vertices.new_place(v));
            edge.trims = trims.each(&edge.trims);
        }
        for trim in &mut out.trims {
            trim.part.curve = flat.new_place(trim.part.curve);
            trim.edge = edges.new_place(trim.edge);
            trim.vertices = trim.vertices.map(|v| vertices.new_place(v));
            trim.in_loop = loops.new_place(trim.in_loop);
        }
        for chain in &mut out.loops {
            chain.trims = trims.each(&chain.trims);
            chain.face = keep_faces.new_place(chain.face);
        }
        for face in &mut out.faces {
            face.surface = surfaces.new_place(face.surface);
            face.loops = loops.each(&face.loops);
        }
        out.set_kinds();
        let brep = Self::from_parts(out)?;
        Ok(if faces.len() >= lengths[0] { brep.with_solidity_of(self) } else { brep })
    }

    fn with_solidity_of(mut self, other: &Self) -> Self {
        self.parts.solidity = other.parts.solidity;
        self
    }

    /// Every face as a brep of its own, on its whole surface, trimmed as it is.
    ///
    /// # Errors
    /// As [`Brep::sub_brep`].
    pub fn exploded(&self) -> Result<Vec<Self>> {
        let live = (0..self.faces().len()).filter(|f| self.faces().get(*f).is_some_and(|face| !face.deleted));
        live.map(|face| self.sub_brep(&[face])).collect()
    }

    /// The breps that do not hang together, each with its faces in order.
    ///
    /// # Errors
    /// As [`Brep::sub_brep`].
    pub fn connected_components(&self) -> Result<Vec<Self>> {
        self.components().iter().map(|faces| self.sub_brep(faces)).collect()
    }

    /// The faces in sets that hang together by edges.
    pub(super) fn components(&self) -> Vec<Vec<usize>> {
        let count = self.faces().len();
        let mut seen = vec![false; count];
        let mut out = Vec::new();
        for first in 0..count {
            let dead = self.faces().get(first).is_none_or(|face| face.deleted);
            if dead || seen.get(first) != Some(&false) {
                continue;
            }
            let mut stack = vec![first];
            let mut found = Vec::new();
            while let Some(face) = stack.pop() {
                match seen.get_mut(face) {
                    Some(seen @ false) => *seen = true,
                    _ => continue,
                }
                found.push(face);
                stack.extend(self.neighbours(face).into_iter().map(|(face, _)| face));
            }
            found.sort_unstable();
            out.push(found);
        }
        out
    }

    /// The faces across the edges of a face, and whether they run along the edge as if one of both were seen from
    /// behind.
    pub(super) fn neighbours(&self, face: usize) -> Vec<(usize, bool)> {
        let mut out = Vec::new();
        for trim in self.trims_of(face) {
            let Some(edge) = self.trims().get(trim).and_then(|t| t.edge).and_then(|e| self.edges().get(e))
            else {
                continue;
            };
            for &other in edge.trims.iter().filter(|t| **t != trim) {
                let Some(owner) = self.face_of(other) else { continue };
                let sense = |t: usize| self.trims().get(t).map(|trim| trim.reversed);
                let reversed = |f: usize| self.faces().get(f).is_some_and(|face| face.reversed);
                let agree = (sense(trim) != sense(other)) == (reversed(face) == reversed(owner));
                out.push((owner, !agree));
            }
        }
        out
    }

    /// The trims of a face, loop by loop.
    pub(crate) fn trims_of(&self, face: usize) -> Vec<usize> {
        let loops = self.faces().get(face).map_or(&[] as &[usize], |face| &face.loops);
        loops
            .iter()
            .filter_map(|l| self.loops().get(*l))
            .flat_map(|chain| chain.trims.iter().copied())
            .collect()
    }

    /// The face that a trim bounds.
    pub(crate) fn face_of(&self, trim: usize) -> Option<usize> {
        self.loops().get(self.trims().get(trim)?.in_loop?)?.face
    }

    /// All parts of several breps in one, nothing joined.
    pub fn merged(breps: &[Self]) -> Self {
        let mut out = Parts::default();
        for brep in breps {
            out.append(brep.parts());
        }
        Self { parts: out }
    }
}

impl Parts {
    /// Adds the parts of another brep, with nothing joined.
    pub(super) fn append(&mut self, other: &Self) {
        let base = (
            self.curves_2d.len(),
            self.curves_3d.len(),
            self.surfaces.len(),
            self.vertices.len(),
            self.edges.len(),
            self.trims.len(),
            self.loops.len(),
            self.faces.len(),
        );
        let moved =
            |list: &[usize], by: usize| -> Vec<usize> { list.iter().map(|place| place + by).collect() };
        self.curves_2d.extend_from_slice(&other.curves_2d);
        self.curves_3d.extend_from_slice(&other.curves_3d);
        self.surfaces.extend_from_slice(&other.surfaces);
        self.vertices.extend(
            other.vertices.iter().map(|v| super::Vertex { edges: moved(&v.edges, base.4), ..v.clone() }),
        );
        self.edges.extend(other.edges.iter().map(|e| super::Edge {
            part: super::CurvePart { curve: e.part.curve.map(|c| c + base.1), ..e.part },
            vertices: e.vertices.map(|v| v.map(|v| v + base.3)),
            trims: moved(&e.trims, base.5),
            ..e.clone()
        }));
        self.trims.extend(other.trims.iter().map(|t| super::Trim {
            part: super::CurvePart { curve: t.part.curve.map(|c| c + base.0), ..t.part },
            edge: t.edge.map(|e| e + base.4),
            vertices: t.vertices.map(|v| v.map(|v| v + base.3)),
            in_loop: t.in_loop.map(|l| l + base.6),
            ..t.clone()
        }));
        self.loops.extend(other.loops.iter().map(|l| super::Loop {
            trims: moved(&l.trims, base.5),
            face: l.face.map(|f| f + base.7),
            ..l.clone()
        }));
        self.faces.extend(other.faces.iter().map(|f| super::Face {
            loops: moved(&f.loops, base.6),
            surface: f.surface.map(|s| s + base.2),
            ..f.clone()
        }));
    }
}
