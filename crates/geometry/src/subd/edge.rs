use super::SubDSide;

/// How the surface behaves across an edge.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum SubDEdgeTag {
    /// Not known.
    Unset,
    /// Smooth.
    #[default]
    Smooth,
    /// A crease, boundaries among them.
    Crease,
    /// Smooth, though both ends lie on creases: it becomes smooth edges when it is subdivided.
    SmoothX,
}

/// An edge of a control net.
#[derive(Debug, Clone, PartialEq)]
pub struct SubDEdge {
    /// A number that no other edge of the net has.
    pub id: u32,
    /// How the surface behaves across it.
    pub tag: SubDEdgeTag,
    /// How sharp a smooth edge is at each end: 0 for not at all, and more for so many subdivisions in which it is
    /// treated as a crease.
    pub sharpness: [f64; 2],
    /// The weight of an end that lies on a crease, a corner or a dart in the rule for the midpoint, that of the opposite
    /// end being the rest to 1; 0 where it has no meaning.
    pub sector_coefficients: [f64; 2],
    /// The vertices it joins.
    pub vertices: [usize; 2],
    /// The faces it bounds; reversed where the face runs through it from the second vertex to the first.
    pub faces: Vec<SubDSide>,
}
