//! What is wrong with an object, by a sign of its own shape beside its colour.

use katydid_elementary::Elementary;
use katydid_solver::Status;

use super::{Placed, theme};
use crate::drawing::{Item, Path, Shape};

use super::capsule::middle;

/// Half the size of a sign.
const R: f64 = 7.0;

/// The sign at the upper right corner; none where all is well.
pub(super) fn of(one: &Placed<'_>) -> Vec<Item> {
    let [x, y, w, _] = one.frame.rect;
    let (cx, cy) = (x + w - 3.0, y - 2.0);
    let corners = |n: u32, turn: f64| {
        (0..n).map(move |k| {
            let (sin, cos) = (std::f64::consts::TAU * (f64::from(k) + turn) / f64::from(n)).sine_cosine();
            [cx + R * sin, cy - R * cos]
        })
    };
    let (outline, mark, colour, ink) = match one.status() {
        Status::Ok => return Vec::new(),
        Status::Warning => (Path::polygon(corners(3, 0.0)), "!", theme::ORANGE, theme::INK),
        Status::Error => (Path::polygon(corners(8, 0.5)), "×", theme::RED, theme::WHITE),
        Status::Unsupported => (Path::polygon(corners(4, 0.0)), "?", theme::ORANGE, theme::INK),
        Status::NoData => (Path::circle([cx, cy], 0.85 * R), "∅", theme::ORANGE, theme::INK),
        Status::Disabled => (Path::circle([cx, cy], 0.85 * R), "–", theme::FAINT, theme::WHITE),
    };
    let down = if one.status() == Status::Warning { 1.0 } else { 0.0 };
    vec![
        Shape::filled(outline, colour).outlined(theme::INK, 0.8).into(),
        middle([cx, cy + down], mark.to_owned(), 9.0, ink),
    ]
}
