//! The typeface that pictures are measured in, and that PNG is drawn in: DejaVu Sans Condensed.

use katydid_geometry::Point2;
use katydid_geometry::lettering::{self, Stroke};
pub(crate) use katydid_scene::font::width;

use crate::drawing::{Path, Segment};

/// The names of the typeface in SVG, the nearest first: a viewer that has none of them takes its own.
pub(crate) const FAMILY: &str = "DejaVu Sans Condensed, DejaVu Sans, Segoe UI, Helvetica, Arial, sans-serif";

/// The text cut to a width, with an ellipsis where something is cut off.
pub(crate) fn fitted(text: &str, size: f64, room: f64) -> String {
    if width(text, size) <= room {
        return text.to_owned();
    }
    let room = room - width("…", size);
    let mut used = 0.0;
    let mut short: String = text
        .chars()
        .take_while(|c| {
            used += width(c.encode_utf8(&mut [0; 4]), size);
            used <= room
        })
        .collect();
    short.truncate(short.trim_end().len());
    short.push('…');
    short
}

/// The outlines of a text whose base line starts at 0, 0, y down, at a size of 1.
pub(crate) fn outlines(text: &str) -> Path {
    let mut path = Path::default();
    let mut at = [0.0; 2];
    let down = |p: Point2| [p.x, -p.y];
    for stroke in lettering::strokes(text) {
        let (segment, to) = match stroke {
            Stroke::Move(p) => (Segment::Move(down(p)), down(p)),
            Stroke::Line(p) => (Segment::Line(down(p)), down(p)),
            Stroke::Quadratic(c, p) => {
                let (c, p) = (down(c), down(p));
                // The same curve by degree elevation.
                let handle = |end: [f64; 2]| [0, 1].map(|k| end[k] + (c[k] - end[k]) * 2.0 / 3.0);
                (Segment::Cubic(handle(at), handle(p), p), p)
            }
            Stroke::Cubic(a, b, p) => (Segment::Cubic(down(a), down(b), down(p)), down(p)),
            Stroke::Close => (Segment::Close, at),
        };
        path.segments.push(segment);
        at = to;
    }
    path
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_have_a_width_and_outlines() {
        assert!(width("iiii", 10.0) < width("MMMM", 10.0));
        assert!((width("ab", 20.0) - 2.0 * width("ab", 10.0)).abs() < 1e-9);
        assert!(!outlines("a°πλ²").segments.is_empty());
        assert!(outlines(" ").segments.is_empty());
    }

    #[test]
    fn long_texts_are_cut() {
        assert_eq!(fitted("short", 10.0, 100.0), "short");
        let cut = fitted("a rather long name", 10.0, 40.0);
        assert!(cut.ends_with('…') && width(&cut, 10.0) <= 40.0, "{cut}");
        assert_eq!(fitted("abc", 10.0, 0.0), "…");
    }
}
