use crate::BoundingBox;

/// How the faces divide space into regions.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Regions {
    /// The two sides of every face.
    pub sides: Vec<FaceSide>,
    /// The regions; one of them is infinite.
    pub regions: Vec<Region>,
}

/// One side of a face.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FaceSide {
    /// The face.
    pub face: Option<usize>,
    /// The region on this side.
    pub region: Option<usize>,
    /// 1 for the side that the surface's normal points away to, −1 for the other.
    pub direction: i32,
}

/// A connected piece of space bounded by sides of faces.
#[derive(Debug, Clone, PartialEq)]
pub struct Region {
    /// Whether it is the outside.
    pub kind: RegionKind,
    /// The sides that bound it, among [`Regions::sides`].
    pub sides: Vec<usize>,
    /// A box around it; none when it was never computed.
    pub bounds: Option<BoundingBox>,
}

/// Whether a region has an end.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum RegionKind {
    /// Not determined.
    #[default]
    Unknown,
    /// It goes on for ever.
    Infinite,
    /// It is enclosed.
    Finite,
}
