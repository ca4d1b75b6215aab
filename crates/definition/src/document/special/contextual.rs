use crate::archive::Chunk;

/// An input that Grasshopper Player, Hops or a Compute server asks its caller for: Get Number, Get Geometry and
/// the like. What is wired into it or kept in it is the default.
#[derive(Debug, Clone, PartialEq)]
pub struct Contextual {
    /// What the caller is told.
    pub prompt: String,
    /// The fewest values.
    pub at_least: i32,
    /// The most values; 2³¹ − 1 for any number.
    pub at_most: i32,
    /// The smallest number, where numbers are asked for.
    pub minimum: Option<f64>,
    /// The largest number, where numbers are asked for.
    pub maximum: Option<f64>,
    /// Whether the caller gives a whole tree.
    pub tree_access: bool,
    /// The kinds of geometry that are taken, as bits of RhinoCommon's `ObjectType`.
    pub filter: Option<i64>,
}

impl Contextual {
    pub(super) fn read(c: &Chunk) -> Option<Self> {
        Some(Self {
            at_least: c.i32("AtLeast")?,
            at_most: c.i32("AtMost")?,
            prompt: c.str("Prompt")?.to_owned(),
            minimum: c.f64("Minimum"),
            maximum: c.f64("Maximum"),
            tree_access: c.bool("TreeAccess").unwrap_or(false),
            filter: c.i64("Filter"),
        })
    }
}
