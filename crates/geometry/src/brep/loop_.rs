/// A closed chain of trims that bounds a face.
#[derive(Debug, Clone, PartialEq)]
pub struct Loop {
    /// Its trims, each beginning where the one before ends and the first where the last ends.
    pub trims: Vec<usize>,
    /// Which side of it is the face.
    pub kind: LoopKind,
    /// The face that it bounds.
    pub face: Option<usize>,
    /// Whether the loop is a gap in the list that operations left behind.
    pub deleted: bool,
}

/// Which side of a loop is the face.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum LoopKind {
    /// Not determined.
    #[default]
    Unknown,
    /// The inside: the loop runs counter-clockwise around the face.
    Outer,
    /// The outside: the loop runs clockwise around a hole.
    Inner,
    /// Both: the loop runs along a cut and back.
    Slit,
}
