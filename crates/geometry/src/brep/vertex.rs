use crate::Point3;

/// A point where edges end.
#[derive(Debug, Clone, PartialEq)]
pub struct Vertex {
    /// Where it is.
    pub point: Point3,
    /// The edges that begin or end here; one that does both stands here twice.
    pub edges: Vec<usize>,
    /// How far from the point edges may end, in model units; negative when it was never computed.
    pub tolerance: f64,
    /// Whether the vertex is a gap in the list that operations left behind.
    pub deleted: bool,
}

impl Vertex {
    /// A vertex without edges.
    pub fn new(point: Point3, tolerance: f64) -> Self {
        Self { point, edges: Vec::new(), tolerance, deleted: false }
    }
}
