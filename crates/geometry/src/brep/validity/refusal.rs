//! Why a shape cannot be made, in the words of who asked for it.
//!
//! Faults name parts by their places in lists, which mean nothing to somebody who has curves and surfaces; here each
//! kind of fault is what it looks like from outside, with what usually causes it.

use super::Fault;
use crate::Error;

/// What words of a fault look like from outside; the first that fits holds.
const SEEN: [(&str, &str); 12] = [
    ("away from that of its edge", "an edge would not lie on the face beside it"),
    ("beyond its curve", "an edge would be longer than its curve"),
    ("runs the other way", "a closed edge would run against the boundary of its face"),
    ("in the parameter plane", "the boundary of a face would have a gap"),
    ("do not share a vertex", "the boundary of a face would have a gap"),
    ("begins at", "the boundary of a face would have a gap"),
    ("does not increase", "an edge would have no length"),
    ("it is closed, but", "an edge would have no length"),
    ("it is open, but", "an edge would end where it begins"),
    ("seam", "the two sides of a closed face would not match"),
    ("across the surface", "the two sides of a closed face would not match"),
    ("bounds another", "two faces would have one boundary"),
];

/// What a fault looks like from outside.
fn seen(fault: &Fault) -> &'static str {
    let known = SEEN.iter().find(|(words, _)| fault.why.contains(words));
    known.map_or("its faces and edges would not fit together", |(_, seen)| seen)
}

/// The refusal of a shape that would have faults.
pub(in crate::brep) fn of_faults(faults: &[Fault]) -> Error {
    let mut all: Vec<&str> = faults.iter().map(seen).collect();
    all.dedup();
    all.truncate(2);
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
    use super::{Fault, of_distance, of_faults};

    #[test]
    fn no_places_in_lists() {
        let fault = |part, why: &str| Fault { part, place: Some(12), why: why.into() };
        let faults = [
            fault("trim", "its edge is closed and runs the other way than stated"),
            fault("trim", "its edge is closed and runs the other way than stated"),
            fault("loop", "trims 3 and 4 do not share a vertex"),
        ];
        let said = of_faults(&faults).to_string();
        assert!(said.contains("closed edge") && said.contains("gap") && !said.contains("12"), "{said}");
        assert!(of_distance(0.25).to_string().contains("2.500e-1"));
        assert!(of_distance(f64::NAN).to_string().contains("no place"));
    }
}
