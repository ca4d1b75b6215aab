use super::{Brep, TrimKind};

/// What a brep says about its inside.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Solidity {
    /// It does not say.
    #[default]
    Unknown,
    /// Closed, with normals outward.
    Outward,
    /// Closed, with normals inward.
    Inward,
}

impl Brep {
    /// Whether the brep encloses a volume: every edge joins exactly two trims, which run along it in opposite
    /// senses seen from the side of the normal, and no trim is naked.
    pub fn is_solid(&self) -> bool {
        let parts = self.parts();
        let live = parts.faces.iter().filter(|face| !face.deleted);
        !parts.faces.is_empty()
            && live.clone().all(|face| {
                !face.loops.is_empty()
                    && face.loops.iter().filter_map(|l| parts.loops.get(*l)).all(|chain| {
                        !chain.trims.is_empty() && chain.trims.iter().all(|t| self.is_joined(*t))
                    })
            })
    }

    /// Whether a trim is where the surface is singular, or has exactly one partner, which runs against it.
    fn is_joined(&self, place: usize) -> bool {
        let parts = self.parts();
        let Some(trim) = parts.trims.get(place) else { return false };
        match trim.kind {
            TrimKind::Singular => true,
            TrimKind::Mated | TrimKind::Seam => {
                let Some(edge) = trim.edge.and_then(|e| parts.edges.get(e)) else { return false };
                let [a, b] = edge.trims.as_slice() else { return false };
                let partner = if *a == place { *b } else { *a };
                match (self.sense(place), self.sense(partner)) {
                    (Some(own), Some(other)) => own != other,
                    _ => false,
                }
            }
            TrimKind::Unknown | TrimKind::Boundary => false,
        }
    }

    /// Whether a trim runs against its edge, seen from the side that its face's normal points to.
    fn sense(&self, trim: usize) -> Option<bool> {
        let parts = self.parts();
        let trim = parts.trims.get(trim)?;
        let face = parts.faces.get(parts.loops.get(trim.in_loop?)?.face?)?;
        Some(trim.reversed != face.reversed)
    }
}
