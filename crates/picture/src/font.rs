//! The typeface that pictures are measured in, and that PNG is drawn in: DejaVu Sans Condensed.

pub(crate) use katydid_scene::font::width;
use katydid_scene::font::{face, glyphs};
use ttf_parser::OutlineBuilder;

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
    let Some(face) = face() else { return path };
    let scale = 1.0 / f64::from(face.units_per_em());
    for (glyph, x) in glyphs(text).0 {
        let mut pen = Pen { path: &mut path, x, scale, at: [0.0; 2] };
        face.outline_glyph(glyph, &mut pen);
    }
    path
}

struct Pen<'a> {
    path: &'a mut Path,
    x: f64,
    scale: f64,
    at: [f64; 2],
}

impl Pen<'_> {
    fn point(&self, x: f32, y: f32) -> [f64; 2] {
        [self.x + f64::from(x) * self.scale, -f64::from(y) * self.scale]
    }

    fn add(&mut self, segment: Segment, to: [f64; 2]) {
        self.at = to;
        self.path.segments.push(segment);
    }
}

impl OutlineBuilder for Pen<'_> {
    fn move_to(&mut self, x: f32, y: f32) {
        let p = self.point(x, y);
        self.add(Segment::Move(p), p);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        let p = self.point(x, y);
        self.add(Segment::Line(p), p);
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        let (c, p) = (self.point(x1, y1), self.point(x, y));
        // The same curve by degree elevation.
        let handle = |end: [f64; 2]| [0, 1].map(|k| end[k] + (c[k] - end[k]) * 2.0 / 3.0);
        self.add(Segment::Cubic(handle(self.at), handle(p), p), p);
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        let p = self.point(x, y);
        self.add(Segment::Cubic(self.point(x1, y1), self.point(x2, y2), p), p);
    }

    fn close(&mut self) {
        self.path.segments.push(Segment::Close);
    }
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
