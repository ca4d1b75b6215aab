//! Arc length.

use std::error::Error;

use katydid_geometry::{ArcLength, Curve};

use super::{Operation, keep, operation};
use crate::Inputs;
use crate::timing::Contender;

/// The length of a curve, and parameters at lengths.
///
/// # Errors
/// The inputs lack something, or a kernel refuses it.
pub fn length(inputs: &Inputs) -> Result<Vec<Operation>, Box<dyn Error>> {
    let mut out = Vec::new();
    for (name, kind) in [("c_nr", "plain"), ("c_r", "rational")] {
        let record = inputs.curve(name)?;
        let ours: Curve = record.katydid()?.into();
        let curvo = record.curvo()?;
        let (a, b) = (ours.clone(), curvo.clone());
        out.push(operation(
            format!("length, {kind}"),
            0.3,
            "curvo",
            vec![
                Contender::new("katydid", 1, move || keep(a.length())),
                Contender::new("curvo", 1, move || keep(b.try_length())),
            ],
        ));
        let (a, b) = (ours.clone(), curvo.clone());
        out.push(operation(
            format!("parameter at length, 1,000 on one curve, {kind}"),
            0.03,
            "curvo",
            vec![
                Contender::new("katydid", 1000, move || {
                    let table = ArcLength::new(&a);
                    for i in 0..1000 {
                        keep(table.parameter_at(table.total() * f64::from(i) / 1000.0));
                    }
                }),
                Contender::new("curvo", 50, {
                    let total = b.try_length()?;
                    move || {
                        for i in 0..50 {
                            keep(b.try_parameter_at_length(total * f64::from(i) / 50.0, Some(1e-9)).ok());
                        }
                    }
                }),
            ],
        ));
    }
    Ok(out)
}
