/// A face of a mesh: the indices of its corners, counter-clockwise seen from outside.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum MeshFace {
    /// Three corners.
    Triangle([u32; 3]),
    /// Four corners.
    Quad([u32; 4]),
}

impl MeshFace {
    /// The corners in order.
    #[inline]
    pub fn indices(&self) -> &[u32] {
        match self {
            Self::Triangle(f) => f,
            Self::Quad(f) => f,
        }
    }

    /// The face as triangles; a quad is cut from its first to its third corner.
    pub fn triangles(self) -> impl Iterator<Item = [u32; 3]> {
        let (first, second) = match self {
            Self::Triangle(f) => (f, None),
            Self::Quad([a, b, c, d]) => ([a, b, c], Some([a, c, d])),
        };
        std::iter::once(first).chain(second)
    }

    /// The face walked the other way round, from the same first corner.
    #[must_use]
    pub fn flipped(self) -> Self {
        match self {
            Self::Triangle([a, b, c]) => Self::Triangle([a, c, b]),
            Self::Quad([a, b, c, d]) => Self::Quad([a, d, c, b]),
        }
    }

    /// The face with other indices in the same corners.
    #[must_use]
    pub fn map(self, f: impl Fn(u32) -> u32) -> Self {
        match self {
            Self::Triangle(c) => Self::Triangle(c.map(f)),
            Self::Quad(c) => Self::Quad(c.map(f)),
        }
    }

    /// Sets corner `k`; nothing happens when there is none.
    pub(super) fn set(&mut self, k: usize, index: u32) {
        let corners: &mut [u32] = match self {
            Self::Triangle(c) => c,
            Self::Quad(c) => c,
        };
        if let Some(corner) = corners.get_mut(k) {
            *corner = index;
        }
    }
}
