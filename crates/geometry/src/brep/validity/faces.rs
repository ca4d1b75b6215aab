//! Faces: a surface, an outer loop, and holes.

use super::super::{LoopKind, Parts};
use super::{Faults, Symptom, occurrences};

const FACE: &str = "face";

impl Parts {
    pub(super) fn face_faults(&self, faults: &mut Faults) {
        for (i, face) in self.faces.iter().enumerate() {
            if face.deleted {
                faults.unless(face.loops.is_empty() && face.surface.is_none(), FACE, i, || {
                    "it is deleted, but names other parts".into()
                });
                continue;
            }
            faults.shown_unless(self.face_surface(face).is_some(), Symptom::Missing, FACE, i, || {
                "it has no surface".into()
            });
            faults.unless(!face.loops.is_empty(), FACE, i, || "it has no loops".into());
            for (at, &place) in face.loops.iter().enumerate() {
                faults.unless(occurrences(&face.loops, place) == 1, FACE, i, || {
                    format!("loop {place} is named more than once")
                });
                let Some(chain) = self.loops.get(place).filter(|chain| !chain.deleted) else {
                    faults.unless(false, FACE, i, || format!("loop {place} is deleted"));
                    continue;
                };
                faults.shown_unless(chain.face == Some(i), Symptom::SharedBoundary, FACE, i, || {
                    format!("loop {place} bounds another")
                });
                let right = match chain.kind {
                    LoopKind::Outer => at == 0,
                    LoopKind::Inner | LoopKind::Slit => at > 0,
                    LoopKind::Unknown => false,
                };
                faults.unless(right, FACE, i, || {
                    if at == 0 { "its first loop is not outer" } else { "a later loop is not a hole" }.into()
                });
            }
        }
    }
}
