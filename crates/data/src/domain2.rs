use katydid_geometry::Interval;

/// A two-dimensional domain: a range for u and one for v.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Domain2 {
    /// The range of the first parameter.
    pub u: Interval,
    /// The range of the second parameter.
    pub v: Interval,
}
