//! Degree and knots.

use std::error::Error;

use super::{Operation, keep, operation};
use crate::Inputs;
use crate::timing::Contender;

/// A degree raised, a knot inserted.
///
/// # Errors
/// The inputs lack something, or a kernel refuses it.
pub fn raise_degree(inputs: &Inputs) -> Result<Vec<Operation>, Box<dyn Error>> {
    let mut out = Vec::new();
    // openNURBS raises the degree in 6.5 µs where curvo's point takes 32 ns: 1 µs on that scale is 31 of curvo's
    // points.
    let record = inputs.curve("c_nr")?;
    let (ours, curvo) = (record.katydid()?, record.curvo()?);
    let (t, u) = (inputs.t()?, ours.clone());
    out.push(operation(
        "raise degree 3→4, against 1,000 ns where curvo's point takes 32",
        1000.0 / 32.0,
        "curvo point",
        vec![
            Contender::new("katydid", 100, move || (0..100).for_each(|_| keep(ours.raised_to(4)))),
            Contender::new("curvo point", t.len(), move || {
                t.iter().for_each(|&t| keep(curvo.point_at(t)));
            }),
            Contender::new("katydid insert knot", 100, move || {
                (0..100).for_each(|_| keep(u.insert_knot(0.4321, 1)));
            }),
        ],
    ));
    Ok(out)
}
