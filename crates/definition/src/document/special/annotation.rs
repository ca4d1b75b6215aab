use uuid::Uuid;

use crate::archive::{Chunk, Colour, ItemValue};

/// A group: a frame around objects.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Group {
    /// The label.
    pub label: String,
    /// The ids of the objects in it, in the file's order; a member may be another group.
    pub members: Vec<Uuid>,
    /// The colour.
    pub colour: Option<Colour>,
    /// The shape of the frame.
    pub border: Border,
}

/// The shape of a group's frame, by the number in the file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Border {
    /// One box around all.
    Box,
    /// A blob around all.
    Blob,
    /// A rectangle around all.
    Rectangle,
    /// Another.
    Other(i32),
}

/// A text on the canvas.
#[derive(Debug, Clone, PartialEq)]
pub struct Scribble {
    /// The text.
    pub text: String,
    /// The typeface.
    pub font: String,
    /// The size in points.
    pub size: f64,
    /// Whether it is bold.
    pub bold: bool,
    /// Whether it is italic.
    pub italic: bool,
    /// The corners of its box on the canvas: it may be turned.
    pub corners: [[f32; 2]; 4],
}

/// Lines drawn on the canvas.
#[derive(Debug, Clone, PartialEq)]
pub struct Sketch {
    /// The lines.
    pub marks: Vec<Mark>,
    /// The colour.
    pub colour: Option<Colour>,
    /// The width in pixels.
    pub width: f64,
}

/// A line of a [`Sketch`].
#[derive(Debug, Clone, PartialEq)]
pub struct Mark {
    /// The points on the canvas.
    pub points: Vec<[f64; 2]>,
}

impl Group {
    /// Whether the label marks the first object in it as an input, for programs that solve the definition for others:
    /// `RH_IN` stands anywhere in it.
    pub fn marks_input(&self) -> bool {
        self.label.contains("RH_IN")
    }

    /// Whether the label marks the first object in it as an output: `RH_OUT` stands anywhere in it.
    pub fn marks_output(&self) -> bool {
        self.label.contains("RH_OUT")
    }

    /// What is behind the mark: `width` of `RH_IN:width`. The label itself where nothing is.
    pub fn marked_name(&self) -> &str {
        let label = self.label.trim();
        let after = ["RH_IN:", "RH_OUT:"].iter().find_map(|mark| label.strip_prefix(mark));
        after.map(str::trim).filter(|name| !name.is_empty()).unwrap_or(label)
    }

    pub(super) fn read(c: &Chunk) -> Self {
        Self {
            label: c.str("NickName").unwrap_or_default().to_owned(),
            members: c.list("ID").into_iter().filter_map(|(_, id)| id.as_guid()).collect(),
            colour: c.colour("Colour"),
            border: match c.i32("Border") {
                Some(1) | None => Border::Box,
                Some(2) => Border::Blob,
                Some(3) => Border::Rectangle,
                Some(other) => Border::Other(other),
            },
        }
    }
}

impl Scribble {
    pub(super) fn read(c: &Chunk) -> Self {
        Self {
            text: c.str("Text").unwrap_or_default().to_owned(),
            font: c.str("Font").unwrap_or_default().to_owned(),
            size: c.f64("Size").unwrap_or(14.0),
            bold: c.bool("Bold").unwrap_or(false),
            italic: c.bool("Italic").unwrap_or(false),
            corners: ["Ca", "Cb", "Cc", "Cd"].map(|name| c.canvas_point(name).unwrap_or_default()),
        }
    }
}

impl Sketch {
    pub(super) fn read(c: &Chunk) -> Self {
        let point = |(_, value): (i32, &ItemValue)| {
            if let ItemValue::Point2d(point) = value { Some(*point) } else { None }
        };
        let mark = |chunk: &Chunk| Mark { points: chunk.list("V").into_iter().filter_map(point).collect() };
        let properties = c.child("Attributes").and_then(|attributes| attributes.child("SketchProperties"));
        Self {
            marks: c.children("Mark").into_iter().map(mark).collect(),
            colour: properties.and_then(|p| p.colour("Color")),
            width: properties.and_then(|p| p.f64("Width")).unwrap_or(1.0),
        }
    }
}
