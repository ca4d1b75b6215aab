use std::num::NonZeroU128;

use super::{Brep, Iso, LoopKind};

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

impl Brep {
    /// Whether a face has no trims but the sides of its surface.
    pub(crate) fn is_whole(&self, face: &Face) -> bool {
        let parts = self.parts();
        let loops = face.loops.iter().filter_map(|l| parts.loops.get(*l));
        loops.clone().count() == 1
            && loops.clone().all(|chain| chain.kind == LoopKind::Outer)
            && loops
                .flat_map(|chain| &chain.trims)
                .all(|t| parts.trims.get(*t).is_some_and(|trim| matches!(trim.iso, Iso::Side(_))))
    }
}
