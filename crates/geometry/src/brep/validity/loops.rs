//! Loops: chains of trims that close.

use super::super::{Iso, Loop, LoopKind, Parts, TrimKind};
use super::{Faults, Symptom, ZERO, occurrences};

const LOOP: &str = "loop";
/// How far ends of neighbours may be apart, as a fraction of the sum of their coordinates.
const RELATIVE_GAP: f64 = 1e-10;

impl Parts {
    pub(super) fn loop_faults(&self, faults: &mut Faults) {
        for (i, chain) in self.loops.iter().enumerate() {
            if chain.deleted {
                faults.unless(chain.trims.is_empty() && chain.face.is_none(), LOOP, i, || {
                    "it is deleted, but names other parts".into()
                });
                continue;
            }
            let face = chain.face.and_then(|f| self.faces.get(f)).filter(|face| !face.deleted);
            faults.unless(face.is_some_and(|face| face.loops.contains(&i)), LOOP, i, || {
                "it bounds no face".into()
            });
            faults.unless(chain.kind != LoopKind::Unknown, LOOP, i, || "its kind is not known".into());
            faults.unless(!chain.trims.is_empty(), LOOP, i, || "it has no trims".into());
            for &place in &chain.trims {
                faults.unless(occurrences(&chain.trims, place) == 1, LOOP, i, || {
                    format!("trim {place} is named more than once")
                });
                let own = self.trims.get(place).is_some_and(|trim| trim.in_loop == Some(i) && !trim.deleted);
                faults.unless(own, LOOP, i, || format!("trim {place} is not in it"));
            }
            self.slit_faults(i, chain, faults);
            self.joint_faults(i, chain, faults);
        }
    }

    /// A slit runs along a cut and back.
    fn slit_faults(&self, i: usize, chain: &Loop, faults: &mut Faults) {
        if chain.kind != LoopKind::Slit {
            return;
        }
        let count = chain.trims.len();
        faults.unless(count >= 2 && count.is_multiple_of(2), LOOP, i, || {
            format!("it is a slit of {count} trims")
        });
        for trim in chain.trims.iter().filter_map(|t| self.trims.get(*t)) {
            let inner = trim.kind == TrimKind::Seam && !matches!(trim.iso, Iso::Side(_));
            faults.shown_unless(inner, Symptom::Seam, LOOP, i, || {
                "it is a slit, but a trim of it is no seam inside".into()
            });
        }
    }

    /// Each trim begins where the one before it ends.
    fn joint_faults(&self, i: usize, chain: &Loop, faults: &mut Faults) {
        let next = chain.trims.iter().cycle().skip(1);
        for (&before, &after) in chain.trims.iter().zip(next) {
            let (Some(a), Some(b)) = (self.trims.get(before), self.trims.get(after)) else { continue };
            faults.shown_unless(a.vertices[1] == b.vertices[0], Symptom::Gap, LOOP, i, || {
                format!("trims {before} and {after} do not share a vertex")
            });
            let (Some(p), Some(q)) = (self.trim_curve(a), self.trim_curve(b)) else { continue };
            let p = a.part.point_at(p, a.part.domain.end);
            let q = b.part.point_at(q, b.part.domain.start);
            let meet = |x: f64, y: f64| (x - y).abs() <= ZERO.max(RELATIVE_GAP * (x.abs() + y.abs()));
            faults.shown_unless(meet(p.x, q.x) && meet(p.y, q.y), Symptom::Gap, LOOP, i, || {
                format!(
                    "trim {before} ends at ({}, {}), but trim {after} begins at ({}, {})",
                    p.x, p.y, q.x, q.y
                )
            });
        }
    }
}
