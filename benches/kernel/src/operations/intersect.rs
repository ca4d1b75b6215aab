//! Intersections.

use std::error::Error;

use curvo::prelude::{CurveIntersectionSolverOptions, Intersects};
use katydid_geometry::{Curve, intersect as meet};

use super::{Operation, keep, operation};
use crate::Inputs;
use crate::timing::Contender;

/// Curves that cross.
///
/// # Errors
/// The inputs lack something, or a kernel refuses it.
pub fn intersect(inputs: &Inputs) -> Result<Vec<Operation>, Box<dyn Error>> {
    let mut out = Vec::new();
    for (a, b, name, wanted) in [
        ("cc_a", "cc_b", "curve with curve, 7 crossings", 1.0),
        ("wv_a", "wv_b", "curve with curve, two weaving cubics with 67 crossings", 0.6),
    ] {
        let (a, b) = (inputs.curve(a)?, inputs.curve(b)?);
        let ours: [Curve; 2] = [a.katydid()?.into(), b.katydid()?.into()];
        let theirs = [a.curvo_flat()?, b.curvo_flat()?];
        let tight = theirs.clone();
        let options = CurveIntersectionSolverOptions::default()
            .with_minimum_distance(1e-9)
            .with_step_size_tolerance(1e-14)
            .with_cost_tolerance(1e-20);
        out.push(operation(
            name,
            wanted,
            "curvo",
            vec![
                Contender::new("katydid", 1, move || keep(meet::curve_curve(&ours[0], &ours[1], 1e-9))),
                Contender::new("curvo", 1, move || {
                    keep(theirs[0].find_intersection(&theirs[1], None).ok());
                }),
                Contender::new("curvo to 1e-13", 1, move || {
                    keep(tight[0].find_intersection(&tight[1], Some(options.clone())).ok());
                }),
            ],
        ));
    }
    Ok(out)
}
