//! Transforms.

use std::error::Error;

use katydid_geometry::{Point3, Vector3, Xform};

use super::{Operation, keep, operation};
use crate::Inputs;
use crate::timing::Contender;

/// A million points moved, beside a copy of them.
///
/// # Errors
/// The inputs lack something, or a kernel refuses it.
pub fn transform(_: &Inputs) -> Result<Vec<Operation>, Box<dyn Error>> {
    let mut out = Vec::new();
    let many: Vec<Point3> = (0..1_000_000).map(|i| Point3::new(f64::from(i), 1.0, -2.0)).collect();
    let turn = Xform::rotation(0.7, Vector3::new(0.3, 0.4, 0.5), Point3::new(1.0, 2.0, 3.0))?;
    let (mut a, b, mut to) = (many.clone(), many.clone(), many.clone());
    out.push(operation(
        "transform 1,000,000 points in place",
        1.3,
        "copy",
        vec![
            Contender::new("katydid", many.len(), move || {
                turn.transform_points(&mut a);
                keep(&a);
            }),
            Contender::new("copy", many.len(), move || {
                to.copy_from_slice(&b);
                keep(&to);
            }),
        ],
    ));
    Ok(out)
}
