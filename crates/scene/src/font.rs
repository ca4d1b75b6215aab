//! The typeface that texts are measured in, and pictures are lettered in: DejaVu Sans Condensed.

use std::sync::LazyLock;

use ttf_parser::{Face, GlyphId};

static FACE: LazyLock<Option<Face<'static>>> =
    LazyLock::new(|| Face::parse(dejavu::sans_condensed::regular(), 0).ok());

/// The typeface; `None` only if its file were broken.
pub fn face() -> Option<&'static Face<'static>> {
    FACE.as_ref()
}

/// The glyphs of a text with where each starts, in units of the type's size.
pub fn glyphs(text: &str) -> (Vec<(GlyphId, f64)>, f64) {
    let Some(face) = face() else { return (Vec::new(), 0.5 * text.chars().count() as f64) };
    let scale = 1.0 / f64::from(face.units_per_em());
    let mut x = 0.0;
    let mut list = Vec::new();
    for c in text.chars().map(|c| if c == '\t' { ' ' } else { c }) {
        // A sign that the typeface does not have is drawn as its box for such signs.
        let glyph = face.glyph_index(c).unwrap_or(GlyphId(0));
        list.push((glyph, x));
        x += f64::from(face.glyph_hor_advance(glyph).unwrap_or(0)) * scale;
    }
    (list, x)
}

/// How wide a text is, in pixels at a size in pixels.
pub fn width(text: &str, size: f64) -> f64 {
    glyphs(text).1 * size
}
