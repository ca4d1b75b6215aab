//! Breps for tests, and what they are asked.

use super::Brep;
use crate::{BoundingBox, Box3, Point3, construct};

/// A box of 1 by 2 by 3, from the origin.
pub(crate) fn cube() -> Brep {
    let bounds = BoundingBox { min: Point3::ORIGIN, max: Point3::new(1.0, 2.0, 3.0) };
    construct::box_brep(&Box3::from(bounds)).unwrap()
}

/// The area of all faces.
pub(crate) fn area(brep: &Brep) -> f64 {
    brep.area_properties(1e-9, || true).unwrap().amount
}
