use super::CurvePart;
use crate::Side;

/// One piece of a loop: a part of a curve in the parameter plane of a surface.
#[derive(Debug, Clone, PartialEq)]
pub struct Trim {
    /// Its curve among [`Parts::curves_2d`](super::Parts::curves_2d), and which part of it.
    pub part: CurvePart,
    /// The edge that it runs along in space; none where the surface is singular.
    pub edge: Option<usize>,
    /// Whether it runs against its edge.
    pub reversed: bool,
    /// The vertices at its start and end.
    pub vertices: [Option<usize>; 2],
    /// What its edge is for its face.
    pub kind: TrimKind,
    /// Whether it runs along a line of constant parameter.
    pub iso: Iso,
    /// The loop that it is a piece of.
    pub in_loop: Option<usize>,
    /// How far its ends may be from those of its neighbours, in u and in v; negative when never computed.
    pub tolerance: [f64; 2],
    /// Tolerances of older programs, in parameters and in model units: kept, and used by nothing.
    pub older_tolerances: [f64; 2],
    /// Whether the trim is a gap in the list that operations left behind.
    pub deleted: bool,
}

/// What the edge of a trim is for the trim's face.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum TrimKind {
    /// Not determined.
    #[default]
    Unknown,
    /// The edge has no other trim: it is naked.
    Boundary,
    /// The edge is shared with another face or loop.
    Mated,
    /// The edge has another trim of the same loop: the surface closes there.
    Seam,
    /// There is no edge: the surface is a single point along the trim.
    Singular,
}

/// How a trim runs in the parameter plane.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Iso {
    /// Anyhow.
    #[default]
    None,
    /// Along a line of constant u inside the domain.
    InnerU,
    /// Along a line of constant v inside the domain.
    InnerV,
    /// Along a side of the domain.
    Side(Side),
}
