//! Colours and sizes of the canvas, after what users of Grasshopper know.

use katydid_data::Colour;
use katydid_solver::Status;

use super::Placed;

pub(super) const PAPER: Colour = Colour::rgb(255, 255, 255);
pub(super) const INK: Colour = Colour::rgb(30, 31, 36);
pub(super) const FAINT: Colour = Colour::rgb(112, 114, 122);
pub(super) const EDGE: Colour = Colour::rgb(62, 64, 72);
pub(super) const BAND: Colour = Colour::rgb(52, 54, 62);
pub(super) const WHITE: Colour = Colour::rgb(255, 255, 255);
pub(super) const WIRE: Colour = Colour::rgb(88, 90, 100);
pub(super) const EMPTY_WIRE: Colour = Colour::rgb(232, 128, 24);
pub(super) const PANEL: Colour = Colour::rgb(255, 247, 196);
pub(super) const GROUP: Colour = Colour::argb(150, 170, 150, 230);
pub(super) const ORANGE: Colour = Colour::rgb(240, 150, 30);
pub(super) const RED: Colour = Colour::rgb(196, 40, 32);

/// The size of names, of ports, and of the names of types, in pixels.
pub(super) const NAME: f64 = 10.0;
pub(super) const PORT: f64 = 9.0;
pub(super) const TYPE: f64 = 8.0;
/// The radius of a capsule's corners.
pub(super) const CORNER: f64 = 4.0;

/// The colours of a capsule and of the text on it, by how it came out.
pub(super) fn capsule(one: &Placed<'_>) -> (Colour, Colour) {
    match one.status() {
        Status::Error => (Colour::rgb(214, 84, 72), WHITE),
        Status::Warning | Status::NoData | Status::Unsupported => (Colour::rgb(250, 184, 96), INK),
        Status::Disabled => (Colour::rgb(206, 206, 206), Colour::rgb(96, 96, 100)),
        Status::Ok if one.object.hidden => (Colour::rgb(178, 180, 196), INK),
        Status::Ok => (Colour::rgb(226, 227, 230), INK),
    }
}
