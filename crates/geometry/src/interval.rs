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

    /// The number nearest to `t` between the ends.
    #[inline]
    pub fn clamp(self, t: f64) -> f64 {
        t.max(self.min()).min(self.max())
    }

    /// From the end to the start.
    #[inline]
    #[must_use]
    pub const fn reversed(self) -> Self {
        Self { start: self.end, end: self.start }
    }

    /// The number halfway.
    #[inline]
    pub fn middle(self) -> f64 {
        0.5 * self.start + 0.5 * self.end
    }

    /// Whether both ends are finite and the end is larger than the start.
    #[inline]
    pub fn is_increasing(self) -> bool {
        self.start.is_finite() && self.end.is_finite() && self.start < self.end
    }

    /// The same range with the smaller end first.
    #[inline]
    #[must_use]
    pub fn ordered(self) -> Self {
        Self::new(self.min(), self.max())
    }

    /// The smallest increasing range that holds both.
    #[must_use]
    pub fn union(self, other: Self) -> Self {
        Self::new(self.min().min(other.min()), self.max().max(other.max()))
    }

    /// What both ranges have in common; `None` when they are apart.
    pub fn intersection(self, other: Self) -> Option<Self> {
        let both = Self::new(self.min().max(other.min()), self.max().min(other.max()));
        (both.start <= both.end).then_some(both)
    }
}

impl Interval {
    /// Whether the start is larger than the end.
    #[inline]
    pub fn is_decreasing(self) -> bool {
        self.start > self.end
    }

    /// Whether start and end are the same number.
    #[inline]
    pub fn is_singleton(self) -> bool {
        self.start == self.end
    }

    /// Whether both ends are finite.
    #[inline]
    pub fn is_finite(self) -> bool {
        self.start.is_finite() && self.end.is_finite()
    }

    /// Whether `other` lies between the ends; with `proper` it must also leave something over.
    pub fn includes(self, other: Self, proper: bool) -> bool {
        let inside = self.min() <= other.min() && other.max() <= self.max();
        inside && !(proper && self.min() == other.min() && self.max() == other.max())
    }

    /// The normalised parameters of another range's ends.
    #[must_use]
    pub fn normalized_interval(self, other: Self) -> Self {
        Self::new(self.normalized(other.start), self.normalized(other.end))
    }

    /// The range between two normalised parameters.
    #[must_use]
    pub fn sub_interval(self, normalized: Self) -> Self {
        Self::new(self.at(normalized.start), self.at(normalized.end))
    }

    /// The smallest increasing range that holds this one and `t`.
    #[must_use]
    pub fn including(self, t: f64) -> Self {
        Self::new(self.min().min(t), self.max().max(t))
    }

    /// The increasing range longer by `distance` at both ends; `None` when a negative distance leaves nothing.
    pub fn expanded(self, distance: f64) -> Option<Self> {
        let wider = Self::new(self.min() - distance, self.max() + distance);
        (wider.start <= wider.end).then_some(wider)
    }

    /// The range moved along the axis.
    #[must_use]
    pub fn shifted(self, distance: f64) -> Self {
        Self::new(self.start + distance, self.end + distance)
    }

    /// `t` moved by whole lengths of the range into it, the start included and the end not; `t` itself in a range
    /// without length.
    pub fn wrapped(self, t: f64) -> f64 {
        let (low, period) = (self.min(), self.length().abs());
        if !(period > 0.0 && period.is_finite()) {
            return t;
        }
        let inside = low + (t - low).rem_euclid(period);
        if inside >= self.max() { low } else { inside }
    }
}
