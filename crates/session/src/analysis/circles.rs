//! Osculating circles along curves.

use std::f64::consts::TAU;

use katydid_geometry::{ArcLength, Circle, Curve, Point3};

use super::{Sheet, Subjects, size};
use crate::protocol::PartKind;

/// Segments of a circle.
const SEGMENTS: usize = 72;
/// A circle so many times as large as its curve is a straight line to the eye.
const LARGEST: f64 = 20.0;

/// Draws so many on each curve, at the middles of equal parts of its length.
pub(super) fn draw(sheet: &mut Sheet, subjects: &Subjects, count: usize) {
    for (origin, curve) in &subjects.curves {
        if sheet.is_full() {
            return;
        }
        let largest = LARGEST * size(Some(&curve.bounding_box()));
        for t in places(curve, count) {
            let Some(circle) = curve.osculating_circle_at(t).filter(|circle| circle.radius <= largest) else {
                continue;
            };
            sheet.line(PartKind::Circles, 0.0, &outline(&circle), *origin);
        }
    }
}

fn places(curve: &Curve, count: usize) -> Vec<f64> {
    let lengths = ArcLength::new(curve);
    let total = lengths.total();
    (0..count).map(|k| lengths.parameter_at(total * (k as f64 + 0.5) / count as f64)).collect()
}

fn outline(circle: &Circle) -> Vec<Point3> {
    (0..=SEGMENTS).map(|k| circle.at(TAU * k as f64 / SEGMENTS as f64)).collect()
}
