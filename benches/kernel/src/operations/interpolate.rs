//! Interpolation.

use std::error::Error;

use curvo::prelude::{Interpolation, NurbsCurve3D};
use katydid_geometry::{KnotSpacing, NurbsCurve};

use super::{Operation, keep, operation};
use crate::Inputs;
use crate::timing::Contender;

/// A cubic through a thousand points.
///
/// # Errors
/// The inputs lack something, or a kernel refuses it.
pub fn interpolate(inputs: &Inputs) -> Result<Vec<Operation>, Box<dyn Error>> {
    let mut out = Vec::new();
    let points = inputs.points("interp1000")?.to_vec();
    let theirs: Vec<_> = points.iter().map(|p| nalgebra::Point3::new(p.x, p.y, p.z)).collect();
    out.push(operation(
        "interpolate 1,000 points",
        0.003,
        "curvo",
        vec![
            Contender::new("katydid", 1, move || {
                keep(NurbsCurve::interpolate(3, &points, KnotSpacing::Chord, None, None).ok());
            }),
            Contender::new("curvo", 1, move || {
                keep(NurbsCurve3D::interpolate(&theirs, 3).ok());
            }),
        ],
    ));
    Ok(out)
}
