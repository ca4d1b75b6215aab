//! The Mesh tab.

mod analysis;
mod depth;
mod light;
mod of_surface;
mod parts;
mod primitive;
mod settings;
mod smooth;
mod spray;
mod triangulation;
mod util;

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message};
use katydid_data::Colour;
use katydid_geometry::Mesh;

/// The colours of a list as a mesh holds them: red, green, blue, opacity. Nulls are left out.
fn colours(list: &List<'_, Colour>) -> Vec<[u8; 4]> {
    list.present().map(|c| [c.r, c.g, c.b, c.a]).collect()
}

/// A number of faces along a side.
fn count(n: i32, what: &str) -> Result<usize, Message> {
    match usize::try_from(n) {
        Ok(n) if n > 0 => Ok(n),
        _ => Err(Message::error(format!("{what} is {n}: it must be at least 1"))),
    }
}

/// A place in a list as a number of 32 bits.
fn integer(n: usize) -> i32 {
    i32::try_from(n).unwrap_or(i32::MAX)
}

fn shared(mesh: Mesh) -> Shared<Mesh> {
    Shared::new(mesh)
}

/// Asks for the room that a mesh of so many faces takes.
fn room(context: &Context<'_>, faces: usize) -> Result<(), Message> {
    /// Corners, a vertex and its normal.
    const BYTES: usize = 80;
    context.bytes(faces.saturating_mul(BYTES))
}
