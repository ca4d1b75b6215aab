//! What keeps a brep from being a sound boundary.
//!
//! The rules are those by which openNURBS calls a brep valid; where it stops at the first fault, all are named here.

mod edges;
mod faces;
mod loops;
pub(super) mod refusal;
mod seams;
mod trims;

use std::fmt;

use super::{Brep, Parts};
use crate::Curve;

/// 2⁻³²: what openNURBS takes for zero among coordinates.
const ZERO: f64 = 2.328_306_436_538_696_3e-10;

/// One thing that is wrong with a brep.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fault {
    /// The kind of part: `edge`, `trim`, `brep`….
    pub part: &'static str,
    /// The part's place in its list; none for the brep as a whole.
    pub place: Option<usize>,
    /// What is wrong with it.
    pub why: String,
    /// What it looks like from outside.
    pub symptom: Symptom,
}

/// What a fault looks like from outside, where nobody sees lists of parts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Symptom {
    /// An edge does not lie on the face beside it.
    EdgeOffFace,
    /// An edge is longer than its curve.
    EdgeBeyondCurve,
    /// An edge has no length.
    EdgeWithoutLength,
    /// An edge ends where it begins, but is no closed curve.
    EdgeToItself,
    /// A closed edge runs against the boundary of its face.
    EdgeTurned,
    /// The boundary of a face has a gap.
    Gap,
    /// The two sides of a face that closes do not match.
    Seam,
    /// Two faces have one boundary.
    SharedBoundary,
    /// A face, an edge or a trim has no surface or curve.
    Missing,
    /// Nothing but parts that do not name each other as they should.
    Parts,
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.place {
            Some(place) => write!(f, "{} {place}: {}", self.part, self.why),
            None => write!(f, "{}: {}", self.part, self.why),
        }
    }
}

/// The faults found so far.
#[derive(Default)]
struct Faults(Vec<Fault>);

impl Faults {
    /// Notes a fault of a part, which only shows in the lists, unless `sound`.
    fn unless(&mut self, sound: bool, part: &'static str, place: usize, why: impl FnOnce() -> String) {
        self.shown_unless(sound, Symptom::Parts, part, place, why);
    }

    /// Notes a fault of a part that can be seen from outside, unless `sound`.
    fn shown_unless(
        &mut self,
        sound: bool,
        symptom: Symptom,
        part: &'static str,
        place: usize,
        why: impl FnOnce() -> String,
    ) {
        if !sound {
            self.0.push(Fault { part, place: Some(place), why: why(), symptom });
        }
    }

    fn whole(&mut self, why: &str) {
        self.0.push(Fault { part: "brep", place: None, why: why.to_owned(), symptom: Symptom::Parts });
    }
}

impl Brep {
    /// Everything that keeps the brep from being a sound boundary, in words; nothing for a valid one.
    ///
    /// Parts must name each other both ways; edges and trims must have curves over increasing domains; the trims of a
    /// loop must meet end to end, in the parameter plane and in the same vertices; trims must carry the right flags,
    /// lie on their surfaces' domains, and run where their edges run, within the tolerances of both.
    pub fn faults(&self) -> Vec<Fault> {
        let parts = self.parts();
        let mut faults = Faults::default();
        parts.lists(&mut faults);
        parts.parameter_curves(&mut faults);
        parts.vertex_faults(&mut faults);
        parts.edge_faults(&mut faults);
        parts.trim_faults(&mut faults);
        parts.loop_faults(&mut faults);
        parts.face_faults(&mut faults);
        parts.seam_faults(&mut faults);
        faults.0
    }

    /// Whether [`Brep::faults`] finds none.
    pub fn is_valid(&self) -> bool {
        self.faults().is_empty()
    }
}

impl Parts {
    /// Lists that may not be empty.
    fn lists(&self, faults: &mut Faults) {
        if self.faces.is_empty() && self.edges.is_empty() && self.vertices.is_empty() {
            faults.whole("it has no faces, edges or vertices");
        }
        if !self.faces.is_empty() {
            let needed = [
                (self.edges.is_empty(), "it has faces, but no edges"),
                (self.loops.is_empty(), "it has faces, but no loops"),
                (self.surfaces.is_empty(), "it has faces, but no surfaces"),
                (self.trims.is_empty(), "it has faces, but no trims"),
                (self.curves_2d.is_empty(), "it has faces, but no parameter curves"),
            ];
            needed.into_iter().filter(|(missing, _)| *missing).for_each(|(_, why)| faults.whole(why));
        }
        if !self.edges.is_empty() && self.curves_3d.is_empty() {
            faults.whole("it has edges, but no space curves");
        }
        if !self.edges.is_empty() && self.vertices.is_empty() {
            faults.whole("it has edges, but no vertices");
        }
    }

    /// Curves of the parameter plane lie in it, and no chain of curves holds chains.
    fn parameter_curves(&self, faults: &mut Faults) {
        for (i, curve) in self.curves_2d.iter().enumerate() {
            let Some(curve) = curve else { continue };
            let flat = curve.extent_along(crate::Vector3::Z);
            faults.unless(flat.start == 0.0 && flat.end == 0.0, "parameter curve", i, || {
                "it leaves the parameter plane".into()
            });
            faults.unless(!is_nested(curve), "parameter curve", i, || "it is a chain of chains".into());
        }
        for (i, curve) in self.curves_3d.iter().enumerate() {
            let Some(curve) = curve else { continue };
            faults.unless(!is_nested(curve), "space curve", i, || "it is a chain of chains".into());
        }
    }
}

fn is_nested(curve: &Curve) -> bool {
    matches!(curve, Curve::Poly(chain) if chain.segments().iter().any(|s| matches!(s, Curve::Poly(_))))
}

/// How often `place` stands in a list.
fn occurrences(list: &[usize], place: usize) -> usize {
    list.iter().filter(|p| **p == place).count()
}
