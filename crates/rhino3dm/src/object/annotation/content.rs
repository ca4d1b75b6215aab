//! The text of an annotation.

use katydid_geometry::Plane;

use crate::chunk::{Reader, Writer};
use crate::{Result, StoredPlane};

/// Text with its formatting.
#[derive(Debug, Clone, PartialEq)]
pub struct TextContent {
    /// The text: in rich text format when it begins with `{\rtf1`, else plain.
    pub rich_text: String,
    /// The width at which it is wrapped.
    pub width: f64,
    /// Its rotation in radians.
    pub rotation: f64,
    /// Where it stands from its point: 0 left, 1 centre, 2 right, 3 as the leader runs.
    pub horizontal_alignment: i32,
    /// The same up and down: 0 top, 1 middle of the first line, 2 bottom of it, 3 middle, 4 bottom, 5 bottom of
    /// the last line, 6 middle of it.
    pub vertical_alignment: i32,
    /// Whether it is wrapped at the width.
    pub wrapped: bool,
}

impl TextContent {
    /// Text as it comes, not wrapped.
    pub fn new(text: impl Into<String>) -> Self {
        Self {
            rich_text: text.into(),
            width: 0.0,
            rotation: 0.0,
            horizontal_alignment: 0,
            vertical_alignment: 0,
            wrapped: false,
        }
    }
}

const WHAT: &str = "text of an annotation";
/// What openNURBS stores in the place of a plane that is of no use any more.
const UNUSED_PLANE: StoredPlane = StoredPlane { frame: Plane::XY, equation: Some([0.0, 0.0, 1.0, -0.0]) };

pub(super) fn read(body: &mut Reader<'_>) -> Result<TextContent> {
    let (mut body, _) = body.versioned_1(WHAT)?;
    let rich_text = body.string(WHAT)?;
    // A plane of no use, always that of the world.
    body.take(128, WHAT)?;
    let width = body.f64(WHAT)?;
    let rotation = body.f64(WHAT)?;
    let horizontal_alignment = body.i32(WHAT)?;
    let vertical_alignment = body.i32(WHAT)?;
    // A height of no use: styles have it.
    body.f64(WHAT)?;
    let wrapped = body.bool(WHAT)?;
    body.finish();
    Ok(TextContent { rich_text, width, rotation, horizontal_alignment, vertical_alignment, wrapped })
}

pub(super) fn write(text: &TextContent, w: &mut Writer) -> Result<()> {
    w.versioned(1, 0, |w| {
        w.string(&text.rich_text)?;
        w.stored_plane(&UNUSED_PLANE);
        w.f64(text.width);
        w.f64(text.rotation);
        w.i32(text.horizontal_alignment);
        w.i32(text.vertical_alignment);
        w.f64(1.0);
        w.bool(text.wrapped);
        Ok(())
    })
}
