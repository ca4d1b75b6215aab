use super::CurvePart;

/// A part of one of the brep's space curves between two vertices.
#[derive(Debug, Clone, PartialEq)]
pub struct Edge {
    /// Its curve among [`Parts::curves_3d`](super::Parts::curves_3d), and which part of it.
    pub part: CurvePart,
    /// The vertices at its start and end; the same one twice when it is closed.
    pub vertices: [Option<usize>; 2],
    /// The trims that run along it: none on a wire, one on a naked edge, two where faces meet or a seam closes, more
    /// where more than two faces meet.
    pub trims: Vec<usize>,
    /// How far the trims' images on their surfaces may be from it, in model units; negative when it was never
    /// computed.
    pub tolerance: f64,
    /// Whether the edge is a gap in the list that operations left behind.
    pub deleted: bool,
}
