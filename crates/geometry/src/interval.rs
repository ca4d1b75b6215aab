/// A directed range of numbers, from `start` to `end`; the start may be the larger of the two.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interval {
    /// Where the range begins.
    pub start: f64,
    /// Where it ends.
    pub end: f64,
}

impl Interval {
    /// From 0 to 1.
    pub const UNIT: Self = Self::new(0.0, 1.0);

    /// The range from `start` to `end`.
    #[inline]
    pub const fn new(start: f64, end: f64) -> Self {
        Self { start, end }
    }

    /// The smaller end.
    #[inline]
    pub fn min(self) -> f64 {
        self.start.min(self.end)
    }

    /// The larger end.
    #[inline]
    pub fn max(self) -> f64 {
        self.start.max(self.end)
    }

    /// `end − start`: negative for a reversed range.
    #[inline]
    pub fn length(self) -> f64 {
        self.end - self.start
    }

    /// The number at normalised parameter `x`: the start at 0, the end at 1, both exactly.
    #[inline]
    pub fn at(self, x: f64) -> f64 {
        (1.0 - x) * self.start + x * self.end
    }

    /// The normalised parameter of `t`: 0 at the start, 1 at the end. In a range without length it is the
    /// start itself, as openNURBS has it.
    #[inline]
    pub fn normalized(self, t: f64) -> f64 {
        if self.start == self.end {
            self.start
        } else if t == self.end {
            1.0
        } else {
            (t - self.start) / (self.end - self.start)
        }
    }

    /// Whether `t` lies between the ends, the ends included.
    #[inline]
    pub fn contains(self, t: f64) -> bool {
        self.min() <= t && t <= self.max()
    }
}
