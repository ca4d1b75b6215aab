//! The outlines of letters, from a typeface that travels in the program: DejaVu Sans Condensed.
//!
//! Lengths are in units of the type's size (the em); x runs along the base line, y upwards. No font of the machine is
//! used, so that a text has the same shape everywhere.
//!
//! ```
//! use katydid_geometry::lettering;
//! let letters = lettering::letters("io")?;
//! // The dot of the i is an outline of its own; the o has one outside and one inside.
//! assert_eq!(letters.iter().map(|letter| letter.outlines.len()).collect::<Vec<_>>(), [2, 2]);
//! # Ok::<(), katydid_geometry::Error>(())
//! ```

use std::sync::LazyLock;

use ttf_parser::{Face, GlyphId, OutlineBuilder};

use crate::{Curve, Line, NurbsCurve, Point2, Point3, PolyCurve, Result};

static FACE: LazyLock<Option<Face<'static>>> =
    LazyLock::new(|| Face::parse(dejavu::sans_condensed::regular(), 0).ok());

/// A piece of the outlines of a text.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Stroke {
    /// A new outline begins here.
    Move(Point2),
    /// A straight piece to a point.
    Line(Point2),
    /// A piece of a parabola: its control point and its end.
    Quadratic(Point2, Point2),
    /// A cubic Bézier piece: two control points and its end.
    Cubic(Point2, Point2, Point2),
    /// The outline goes back to where it began.
    Close,
}

/// A letter of a text.
#[derive(Debug, Clone, PartialEq)]
pub struct Letter {
    /// Where its room on the base line starts.
    pub start: f64,
    /// How wide its room is.
    pub advance: f64,
    /// Closed curves in the XY plane, at their place in the text. What they run around is the letter; a blank has none.
    pub outlines: Vec<Curve>,
}

/// How high a capital letter is.
pub fn capital_height() -> f64 {
    let height = FACE.as_ref().and_then(|face| {
        let capital = face.capital_height().filter(|h| *h > 0)?;
        Some(f64::from(capital) / f64::from(face.units_per_em()))
    });
    height.unwrap_or(0.729)
}

/// How wide a text is.
pub fn width(text: &str) -> f64 {
    glyphs(text).1
}

/// The outlines of a text whose base line starts at 0, 0.
pub fn strokes(text: &str) -> Vec<Stroke> {
    glyphs(text).0.into_iter().flat_map(|glyph| glyph.strokes()).collect()
}

/// The letters of a text in a line, with closed curves around them.
///
/// # Errors
/// None with a typeface that is sound.
pub fn letters(text: &str) -> Result<Vec<Letter>> {
    let (glyphs, _) = glyphs(text);
    let letter = |glyph: Glyph| {
        Ok(Letter { start: glyph.start, advance: glyph.advance, outlines: curves(&glyph.strokes())? })
    };
    glyphs.into_iter().map(letter).collect()
}

/// A glyph of the typeface at its place in a text.
struct Glyph {
    id: GlyphId,
    start: f64,
    advance: f64,
}

impl Glyph {
    fn strokes(&self) -> Vec<Stroke> {
        let Some(face) = FACE.as_ref() else { return Vec::new() };
        let mut pen = Pen { strokes: Vec::new(), x: self.start, scale: scale(face) };
        face.outline_glyph(self.id, &mut pen);
        pen.strokes
    }
}

fn scale(face: &Face<'_>) -> f64 {
    1.0 / f64::from(face.units_per_em())
}

/// The glyphs of a text, and its width.
fn glyphs(text: &str) -> (Vec<Glyph>, f64) {
    // Only if the file of the typeface were broken: half a size a letter.
    let Some(face) = FACE.as_ref() else { return (Vec::new(), 0.5 * text.chars().count() as f64) };
    let mut start = 0.0;
    let mut list = Vec::new();
    for c in text.chars().map(|c| if c == '\t' { ' ' } else { c }) {
        // A sign that the typeface does not have is its box for such signs.
        let id = face.glyph_index(c).unwrap_or(GlyphId(0));
        let advance = f64::from(face.glyph_hor_advance(id).unwrap_or(0)) * scale(face);
        list.push(Glyph { id, start, advance });
        start += advance;
    }
    (list, start)
}

struct Pen {
    strokes: Vec<Stroke>,
    x: f64,
    scale: f64,
}

impl Pen {
    fn point(&self, x: f32, y: f32) -> Point2 {
        Point2::new(self.x + f64::from(x) * self.scale, f64::from(y) * self.scale)
    }
}

impl OutlineBuilder for Pen {
    fn move_to(&mut self, x: f32, y: f32) {
        self.strokes.push(Stroke::Move(self.point(x, y)));
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.strokes.push(Stroke::Line(self.point(x, y)));
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        self.strokes.push(Stroke::Quadratic(self.point(x1, y1), self.point(x, y)));
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        self.strokes.push(Stroke::Cubic(self.point(x1, y1), self.point(x2, y2), self.point(x, y)));
    }

    fn close(&mut self) {
        self.strokes.push(Stroke::Close);
    }
}

/// The closed curves that strokes draw.
fn curves(strokes: &[Stroke]) -> Result<Vec<Curve>> {
    let flat = |p: Point2| Point3::new(p.x, p.y, 0.0);
    let mut out = Vec::new();
    let mut pieces: Vec<Curve> = Vec::new();
    let (mut first, mut at) = (Point3::ORIGIN, Point3::ORIGIN);
    for stroke in strokes {
        let points: Vec<Point3> = match *stroke {
            Stroke::Move(p) => {
                pieces.clear();
                (first, at) = (flat(p), flat(p));
                continue;
            }
            Stroke::Line(p) => vec![at, flat(p)],
            Stroke::Quadratic(a, p) => vec![at, flat(a), flat(p)],
            Stroke::Cubic(a, b, p) => vec![at, flat(a), flat(b), flat(p)],
            Stroke::Close => vec![at, first],
        };
        let end = points.last().copied().unwrap_or(at);
        match points.as_slice() {
            [a, b] if a == b => {}
            [a, b] => pieces.push(Line::new(*a, *b).into()),
            _ => pieces.push(NurbsCurve::bezier(&points)?.into()),
        }
        at = end;
        if *stroke == Stroke::Close && !pieces.is_empty() {
            out.push(PolyCurve::new(std::mem::take(&mut pieces))?.into());
        }
    }
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Plane;
    use crate::region::{FillRule, Region};

    #[test]
    fn outlines_enclose_letters() {
        let letters = letters("Lo i").unwrap();
        let counts: Vec<usize> = letters.iter().map(|letter| letter.outlines.len()).collect();
        assert_eq!(counts, [1, 2, 0, 2]);
        for letter in &letters {
            assert!(letter.outlines.iter().all(Curve::is_closed));
            let outlines = letter.outlines.iter();
            assert!(outlines.flat_map(Curve::hull_points).all(|p| {
                p.x > letter.start - 0.1 && p.x < letter.start + letter.advance + 0.1 && p.z == 0.0
            }));
        }
        // An L is two strokes: its corners stand at the height of a capital letter, and it is 6 lines.
        let l = Region::new(&letters[0].outlines, FillRule::NonZero, &Plane::XY, 1e-6).unwrap();
        let size = l.faces()[0].outline().bounding_box();
        assert!((size.max.y - capital_height()).abs() < 1e-3 && size.min.y.abs() < 1e-9, "{size:?}");
        let ring = Region::new(&letters[1].outlines, FillRule::NonZero, &Plane::XY, 1e-6).unwrap();
        assert_eq!((ring.faces().len(), ring.faces()[0].holes().len()), (1, 1));
    }

    #[test]
    fn texts_have_a_width() {
        assert!(width("iiii") < width("MMMM") && width("") == 0.0);
        assert!((width("ab") - width("a") - width("b")).abs() < 1e-12);
        assert!(strokes(" ").is_empty() && !strokes("a°πλ²").is_empty());
        // A sign that no typeface has is drawn as a box.
        assert!(!strokes("\u{10FFFE}").is_empty());
    }
}
