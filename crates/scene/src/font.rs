//! The typeface that texts are measured in, and pictures are lettered in: DejaVu Sans Condensed.

use katydid_geometry::lettering;

/// How wide a text is, in pixels at a size in pixels.
pub fn width(text: &str, size: f64) -> f64 {
    lettering::width(text) * size
}
