use crate::{Interval, Line, Point3};

/// A straight segment as a curve: the line over a domain of its own.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LineCurve {
    /// The segment.
    pub line: Line,
    /// The parameters of its ends; increasing.
    pub domain: Interval,
}

impl LineCurve {
    /// The segment over 0…length, over 0…1 when it has no length.
    pub fn new(line: Line) -> Self {
        let length = line.length();
        let end = if length > 0.0 && length.is_finite() { length } else { 1.0 };
        Self { line, domain: Interval::new(0.0, end) }
    }

    /// The point at parameter `t` of the domain; beyond it the line goes on straight.
    #[inline]
    pub fn point_at(&self, t: f64) -> Point3 {
        self.line.at(self.domain.normalized(t))
    }
}

impl From<Line> for LineCurve {
    fn from(line: Line) -> Self {
        Self::new(line)
    }
}
