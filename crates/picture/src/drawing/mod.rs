//! The drawing list: what a picture is made of, in pixels, x to the right and y down. SVG and PNG are written from it.

mod path;
mod solids;

pub use path::{Path, Segment};
pub use solids::{Corner, Face, Solids, SpaceLine};

use katydid_data::Colour;
pub(crate) use katydid_scene::colour::{blend, channel, opaque};

/// A picture as a list of what is drawn, from the bottom up.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Drawing {
    /// Width and height in pixels.
    pub size: [f64; 2],
    /// What the picture is, in a few words.
    pub title: String,
    /// What is to be seen on it, for who cannot see it.
    pub description: String,
    /// The colour behind everything; none for a clear ground.
    pub background: Option<Colour>,
    /// What is drawn.
    pub items: Vec<Item>,
}

/// One thing that is drawn.
#[derive(Debug, Clone, PartialEq)]
pub enum Item {
    /// An outline, filled or stroked or both.
    Shape(Shape),
    /// A line of text.
    Label(Label),
    /// Faces and lines that hide one another.
    Solids(Solids),
    /// Several things that belong together, with a name for who asks what they are.
    Group(String, Vec<Item>),
}

/// A path with its paint.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Shape {
    /// The outline.
    pub path: Path,
    /// The colour inside, by the nonzero rule.
    pub fill: Option<Colour>,
    /// The line along the path.
    pub stroke: Option<Stroke>,
}

/// How a path is stroked. Ends and corners are round.
#[derive(Debug, Clone, PartialEq)]
pub struct Stroke {
    /// The colour.
    pub colour: Colour,
    /// The width in pixels.
    pub width: f64,
    /// The lengths of dashes and gaps in turn, in pixels; empty for a line without gaps.
    pub dashes: Vec<f64>,
}

/// A line of text.
#[derive(Debug, Clone, PartialEq)]
pub struct Label {
    /// Where the text is anchored, on its base line.
    pub at: [f64; 2],
    /// The text.
    pub text: String,
    /// The size of the type in pixels.
    pub size: f64,
    /// Its colour.
    pub colour: Colour,
    /// Which part of the text stands at the anchor.
    pub anchor: Anchor,
    /// Whether it is bold.
    pub bold: bool,
    /// The colour of a rim that keeps the text apart from what lies below.
    pub halo: Option<Colour>,
    /// Where the text's x and y directions point on the picture: `[xx, xy, yx, yy]`; `[1, 0, 0, 1]` for upright text.
    pub turn: [f64; 4],
}

/// Which part of a text stands at its anchor.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Anchor {
    /// Its start.
    #[default]
    Start,
    /// Its middle.
    Middle,
    /// Its end.
    End,
}

impl Stroke {
    /// A line without gaps.
    pub fn solid(colour: Colour, width: f64) -> Self {
        Self { colour, width, dashes: Vec::new() }
    }
}

impl Shape {
    /// A filled outline.
    pub fn filled(path: Path, colour: Colour) -> Self {
        Self { path, fill: Some(colour), stroke: None }
    }

    /// A stroked outline.
    pub fn stroked(path: Path, colour: Colour, width: f64) -> Self {
        Self { path, fill: None, stroke: Some(Stroke::solid(colour, width)) }
    }

    /// The same with a line along it.
    #[must_use]
    pub fn outlined(mut self, colour: Colour, width: f64) -> Self {
        self.stroke = Some(Stroke::solid(colour, width));
        self
    }
}

impl Label {
    /// Upright text that starts at `at`.
    pub fn new(at: [f64; 2], text: impl Into<String>, size: f64, colour: Colour) -> Self {
        Self {
            at,
            text: text.into(),
            size,
            colour,
            anchor: Anchor::Start,
            bold: false,
            halo: None,
            turn: [1.0, 0.0, 0.0, 1.0],
        }
    }

    /// The same with another part at its anchor.
    #[must_use]
    pub fn anchored(mut self, anchor: Anchor) -> Self {
        self.anchor = anchor;
        self
    }

    /// The same in bold.
    #[must_use]
    pub fn bold(mut self) -> Self {
        self.bold = true;
        self
    }

    /// The same with a rim.
    #[must_use]
    pub fn with_halo(mut self, colour: Colour) -> Self {
        self.halo = Some(colour);
        self
    }
}

impl From<Shape> for Item {
    fn from(shape: Shape) -> Self {
        Self::Shape(shape)
    }
}

impl From<Label> for Item {
    fn from(label: Label) -> Self {
        Self::Label(label)
    }
}

impl Drawing {
    /// Puts something on top.
    pub fn push(&mut self, item: impl Into<Item>) {
        self.items.push(item.into());
    }

    /// The same `factor` times as large.
    #[must_use]
    pub fn scaled(mut self, factor: f64) -> Self {
        self.size = self.size.map(|x| x * factor);
        self.items.iter_mut().for_each(|item| item.transform(factor, [0.0, 0.0]));
        self
    }

    /// The same as large as fits into a size, in its middle.
    #[must_use]
    pub fn fitted(mut self, size: [f64; 2]) -> Self {
        let [w, h] = self.size.map(|x| x.max(1.0));
        let factor = (size[0] / w).min(size[1] / h);
        let by = [0.5 * (size[0] - w * factor), 0.5 * (size[1] - h * factor)];
        self.size = size;
        self.items.iter_mut().for_each(|item| item.transform(factor, by));
        self
    }
}

impl Item {
    /// Multiplies all lengths by `factor`, then moves everything by `by`.
    pub fn transform(&mut self, factor: f64, by: [f64; 2]) {
        let place = |p: &mut [f64; 2]| *p = [p[0] * factor + by[0], p[1] * factor + by[1]];
        match self {
            Self::Shape(shape) => {
                shape.path.for_each_point(place);
                if let Some(stroke) = &mut shape.stroke {
                    stroke.width *= factor;
                    stroke.dashes.iter_mut().for_each(|x| *x *= factor);
                }
            }
            Self::Label(label) => {
                place(&mut label.at);
                label.size *= factor;
            }
            Self::Solids(solids) => solids.transform(factor, by),
            Self::Group(_, items) => items.iter_mut().for_each(|item| item.transform(factor, by)),
        }
    }
}
