use katydid_geometry::Xform;

/// Transforms to be done one after the other, the first one first.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Compound {
    /// The parts in the order in which they are done.
    pub parts: Vec<Xform>,
}

impl Compound {
    /// The one transform that does the same; the identity when there are no parts.
    pub fn whole(&self) -> Xform {
        self.parts.iter().fold(Xform::IDENTITY, |all, next| *next * all)
    }
}
