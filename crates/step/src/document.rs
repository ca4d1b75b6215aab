//! What a file holds.

use std::sync::Arc;

use katydid_geometry::{Brep, Curve, Point3};

/// Exact geometry with names, colours and layers, in one unit.
#[derive(Debug, Clone, PartialEq)]
pub struct Document {
    /// The length of the unit in metres.
    pub metres: f64,
    /// How near places are that count as one, in units.
    pub tolerance: f64,
    /// The name of the product.
    pub name: String,
    /// What is in it, in order.
    pub parts: Vec<Part>,
    /// What a file had that could not become a part.
    pub left_out: Vec<LeftOut>,
}

impl Default for Document {
    /// Empty, in millimetres.
    fn default() -> Self {
        Self { metres: 1e-3, tolerance: 1e-3, name: String::new(), parts: Vec::new(), left_out: Vec::new() }
    }
}

/// One piece of geometry.
#[derive(Debug, Clone, PartialEq)]
pub struct Part {
    /// Its name; may be empty.
    pub name: String,
    /// The name of its layer, with those above it before it, joined by `::`.
    pub layer: Option<String>,
    /// Its colour as red, green, blue, alpha, as a screen shows them.
    pub colour: Option<[u8; 4]>,
    /// Its form.
    pub shape: Shape,
}

impl Part {
    /// A part with a name, on no layer, without a colour.
    pub fn named(name: impl Into<String>, shape: Shape) -> Self {
        Self { name: name.into(), layer: None, colour: None, shape }
    }
}

/// The forms of exact geometry.
#[derive(Debug, Clone, PartialEq)]
pub enum Shape {
    /// One point or many.
    Points(Vec<Point3>),
    /// A curve.
    Curve(Curve),
    /// Faces, joined along their edges or not.
    Brep(Arc<Brep>),
}

impl Shape {
    /// What it is in a few words, for messages.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Points(points) if points.len() == 1 => "point",
            Self::Points(_) => "points",
            Self::Curve(_) => "curve",
            Self::Brep(_) => "brep",
        }
    }
}

/// Something that could not be carried over.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LeftOut {
    /// What it is: a kind of part, or the keyword of an entity.
    pub what: String,
    /// The reason, with the entity's name where there is one.
    pub why: String,
}

impl LeftOut {
    /// A thing and the reason.
    pub fn new(what: impl Into<String>, why: impl Into<String>) -> Self {
        Self { what: what.into(), why: why.into() }
    }
}
