use std::num::NonZeroU128;

/// A part of a surface bounded by loops.
#[derive(Debug, Clone, PartialEq)]
pub struct Face {
    /// Its loops, the outer one first.
    pub loops: Vec<usize>,
    /// Its surface among [`Parts::surfaces`](super::Parts::surfaces).
    pub surface: Option<usize>,
    /// Whether its normal is opposite to the surface's.
    pub reversed: bool,
    /// Which of the object's materials it has; 0 is the object's own.
    pub material_channel: u32,
    /// Its identifier, if it has one.
    pub id: Option<NonZeroU128>,
    /// Its own colour as red, green, blue and alpha.
    pub colour: Option<[u8; 4]>,
    /// Whether the face is a gap in the list that operations left behind.
    pub deleted: bool,
}

impl Face {
    /// A face without loops.
    pub fn new(surface: usize, reversed: bool) -> Self {
        Self {
            loops: Vec::new(),
            surface: Some(surface),
            reversed,
            material_channel: 0,
            id: None,
            colour: None,
            deleted: false,
        }
    }
}
