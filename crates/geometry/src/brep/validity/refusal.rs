//! Why a shape cannot be made, in the words of who asked for it.
//!
//! Faults name parts by their places in lists, which mean nothing to somebody who has curves and surfaces; here each
//! symptom is said as it looks from outside, with what usually causes it.

use super::{Fault, Symptom};
use crate::Error;

/// How many things a refusal names.
const MOST_SAID: usize = 2;

/// What would be seen of a shape with such a fault.
fn seen(symptom: Symptom) -> &'static str {
    match symptom {
        Symptom::EdgeOffFace => "an edge would not lie on the face beside it",
        Symptom::EdgeBeyondCurve => "an edge would be longer than its curve",
        Symptom::EdgeWithoutLength => "an edge would have no length",
        Symptom::EdgeToItself => "an edge would end where it begins",
        Symptom::EdgeTurned => "a closed edge would run against the boundary of its face",
        Symptom::Gap => "the boundary of a face would have a gap",
        Symptom::Seam => "the two sides of a closed face would not match",
        Symptom::SharedBoundary => "two faces would have one boundary",
        Symptom::Missing => "a face or an edge would have no shape",
        Symptom::Parts => "its faces and edges would not fit together",
    }
}

/// The refusal of a shape that would have faults.
pub(in crate::brep) fn of_faults(faults: &[Fault]) -> Error {
    let mut all: Vec<&str> = Vec::new();
    for said in faults.iter().map(|fault| seen(fault.symptom)) {
        if all.len() < MOST_SAID && !all.contains(&said) {
            all.push(said);
        }
    }
    refused(&all.join(", and "))
}

/// The refusal of a shape with an edge too far off its faces.
pub(in crate::brep) fn of_distance(distance: f64) -> Error {
    if distance.is_finite() {
        refused(&format!("an edge would lie {distance:.3e} off the faces beside it"))
    } else {
        refused("an edge would have no place on the faces beside it")
    }
}

/// The refusal of parts that name others that do not exist, or hold what is no number.
pub(in crate::brep) fn of_parts() -> Error {
    let why = "a part of it would hold a number that is not finite, or belongs to another shape";
    Error::Invalid { what: "result", why: why.into() }
}

fn refused(what: &str) -> Error {
    const CAUSE: &str = "the input may cross or touch itself, fold back, or be too small for the tolerance";
    Error::Invalid { what: "result", why: format!("{what}; {CAUSE}") }
}

#[cfg(test)]
mod tests {
    use super::{Fault, Symptom, of_distance, of_faults};

    #[test]
    fn no_places_in_lists() {
        let fault = |symptom| Fault { part: "trim", place: Some(12), why: "edge 12".into(), symptom };
        let faults = [Symptom::EdgeTurned, Symptom::EdgeTurned, Symptom::Gap, Symptom::EdgeTurned].map(fault);
        let said = of_faults(&faults).to_string();
        assert!(said.contains("closed edge") && said.contains("gap") && !said.contains("12"), "{said}");
        assert_eq!(said.matches("closed edge").count(), 1, "{said}");
        assert!(of_distance(0.25).to_string().contains("2.500e-1"));
        assert!(of_distance(f64::NAN).to_string().contains("no place"));
    }
}
