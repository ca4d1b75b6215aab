//! Breps sewn together along their naked edges.

mod cut;
mod sew;

use super::{Brep, TrimKind};
use crate::{Error, Result, Tolerance, cancellation};

/// Breps that were joined, and where each came from.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Joined {
    /// The results, in the order of their first members.
    pub breps: Vec<Brep>,
    /// For each result the places of its members in the list given.
    pub members: Vec<Vec<usize>>,
}

impl Brep {
    /// Joins breps along naked edges that run together within `tolerance.absolute`. Where an edge ends on another one
    /// that one is cut there first, so that faces of different sizes fit. No edge gets more than two faces; of
    /// several pairs the nearest is joined. Faces are turned to agree with the first of each result, and what encloses
    /// a volume gets its normals outward.
    ///
    /// Places of parts do not last. Edges keep the curve of the first face, and get a tolerance as large as the
    /// gap.
    ///
    /// # Errors
    /// The tolerance is not above 0, or a brep has faults.
    pub fn join(breps: &[Self], tolerance: &Tolerance) -> Result<Joined> {
        let limit = tolerance.positive_distance()?;
        let mut parts = super::Parts::default();
        let mut origin: Vec<usize> = Vec::new();
        for (place, brep) in breps.iter().enumerate() {
            cancellation::check()?;
            let faces: Vec<usize> = (0..brep.faces().len()).collect();
            let compact = brep.sub_brep(&faces)?;
            origin.extend(std::iter::repeat_n(place, compact.faces().len()));
            parts.append(compact.parts());
        }
        parts.cut_at_foreign_vertices(limit)?;
        parts.sew(limit)?;
        parts.set_kinds();
        parts.agree_faces();
        let whole = Self { parts };
        let mut joined = Joined::default();
        for faces in whole.components() {
            cancellation::check()?;
            let mut members: Vec<usize> = faces.iter().filter_map(|f| origin.get(*f).copied()).collect();
            members.dedup();
            if let ([only], Some(same)) = (members.as_slice(), members.first().and_then(|m| breps.get(*m)))
                && same.faces().len() == faces.len()
                && same.naked_edges().len() == whole.sub_brep(&faces)?.naked_edges().len()
            {
                // Nothing was joined to it.
                joined.members.push(vec![*only]);
                joined.breps.push(same.clone());
                continue;
            }
            let mut parts = whole.sub_brep(&faces)?.into_parts();
            parts.set_kinds();
            parts.set_iso();
            parts.measure_tolerances();
            let brep = Self::from_parts(parts)?.checked()?;
            joined.breps.push(brep.turned_outward());
            joined.members.push(members);
        }
        Ok(joined)
    }

    /// The one brep that several make together.
    ///
    /// # Errors
    /// As [`Brep::join`]; or they do not hang together.
    pub(crate) fn joined_into_one(breps: &[Self], tolerance: &Tolerance) -> Result<Self> {
        let mut joined = Self::join(breps, tolerance)?.breps;
        match (joined.pop(), joined.len()) {
            (Some(only), 0) => Ok(only),
            (None, _) => Err(Error::degenerate("brep", "there are no faces")),
            (Some(_), more) => Err(Error::Invalid {
                what: "brep",
                why: format!("its faces do not meet within the tolerance: there are {} parts", more + 1),
            }),
        }
    }
}

impl super::Parts {
    /// Turns faces over so that neighbours agree, starting from the first of each connected set.
    pub(super) fn agree_faces(&mut self) {
        let count = self.faces.len();
        let mut seen = vec![false; count];
        for first in 0..count {
            let mut stack = vec![(first, false)];
            while let Some((face, turn)) = stack.pop() {
                match seen.get_mut(face) {
                    Some(seen @ false) => *seen = true,
                    _ => continue,
                }
                if let Some(face) = self.faces.get_mut(face).filter(|_| turn) {
                    face.reversed = !face.reversed;
                }
                stack.extend(self.mates(face));
            }
        }
    }

    /// The faces across the edges of a face, and whether they have to be turned over to agree with it.
    fn mates(&self, face: usize) -> Vec<(usize, bool)> {
        let mut out = Vec::new();
        let Some(own) = self.faces.get(face) else { return out };
        let trims =
            own.loops.iter().filter_map(|l| self.loops.get(*l)).flat_map(|chain| chain.trims.iter().copied());
        for trim in trims {
            let Some(this) = self.trims.get(trim).filter(|t| t.kind == TrimKind::Mated) else { continue };
            let Some([a, b]) = this.edge.and_then(|e| self.edges.get(e)).map(|e| e.trims.as_slice()) else {
                continue;
            };
            let other = if *a == trim { *b } else { *a };
            let Some(that) = self.trims.get(other) else { continue };
            let Some(mate) = that.in_loop.and_then(|l| self.loops.get(l)).and_then(|chain| chain.face) else {
                continue;
            };
            let Some(other_face) = self.faces.get(mate).filter(|_| mate != face) else { continue };
            let agree = (this.reversed != own.reversed) != (that.reversed != other_face.reversed);
            out.push((mate, !agree));
        }
        out
    }
}

#[cfg(test)]
mod tests {
    use crate::{Brep, Interval, Plane, PlaneSurface, Point3, Tolerance};

    fn square(x: f64, y: f64) -> Brep {
        let plane = Plane::XY.with_origin(Point3::new(x, y, 0.0));
        let surface = PlaneSurface::new(plane, Interval::UNIT, Interval::UNIT);
        Brep::from_kinked_surface(&surface.unwrap().into(), &Tolerance::default()).unwrap()
    }

    /// The counts of a square lattice, whatever the order in which its faces are given.
    #[test]
    fn a_lattice_of_squares_becomes_one() {
        const SIDE: usize = 12;
        let at = |k: usize| square((k % SIDE) as f64, (k / SIDE) as f64);
        // 5 and 144 have no common divisor: every face once, neighbours far apart.
        for step in [1, 5] {
            let faces: Vec<Brep> = (0..SIDE * SIDE).map(|k| at(k * step % (SIDE * SIDE))).collect();
            let joined = Brep::join(&faces, &Tolerance::default()).unwrap();
            let [one] = joined.breps.as_slice() else { panic!("{} parts", joined.breps.len()) };
            assert_eq!(one.faces().len(), SIDE * SIDE);
            assert_eq!(one.edges().len(), 2 * SIDE * (SIDE + 1));
            assert_eq!(one.vertices().len(), (SIDE + 1) * (SIDE + 1));
            assert_eq!(one.naked_edges().len(), 4 * SIDE);
            assert_eq!(joined.members, [(0..SIDE * SIDE).collect::<Vec<_>>()]);
        }
    }
}
