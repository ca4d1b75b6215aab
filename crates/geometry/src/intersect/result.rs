//! What an intersection of curves consists of.

use crate::{Interval, Point3};

/// How two curves stand to each other where they meet.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum ContactKind {
    /// Their directions differ: they cross, or one ends on the other.
    Transversal,
    /// They touch without a difference of direction, or their crossings lie so near to each other that between them
    /// the curves part by no more than the tolerance.
    Tangent,
}

/// A point that two curves have in common.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Crossing {
    /// The parameter on the first curve.
    pub a: f64,
    /// The parameter on the second curve.
    pub b: f64,
    /// The point halfway between the two curves there.
    pub point: Point3,
    /// The distance between the curves there: rounding noise where they truly meet, at most the tolerance.
    pub gap: f64,
    /// Crossing or touch.
    pub kind: ContactKind,
}

/// A stretch along which two curves lie within the tolerance of each other.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Overlap {
    /// The parameters on the first curve, increasing.
    pub a: Interval,
    /// The parameters on the second curve: `b.start` belongs to `a.start`, so that the interval decreases when the
    /// curves run in opposite directions.
    pub b: Interval,
    /// Whether the second curve runs along the stretch in the direction of the first.
    pub same_direction: bool,
}

/// All that two curves, or a curve and itself, have in common.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct CurveIntersections {
    /// The points, sorted by the parameter on the first curve, then on the second.
    pub crossings: Vec<Crossing>,
    /// The stretches, sorted likewise.
    pub overlaps: Vec<Overlap>,
    /// Whether the search came to its end. `false` says that the input was so degenerate that the budget of work ran
    /// out (long curves that run beside each other at little more than the tolerance, curves crumpled into a heap
    /// of its size, thousands of stretches of a curve upon each other): what is listed is right, but something may be
    /// missing. That takes about a second.
    pub complete: bool,
    /// The pairs of parts that were looked at: a measure of the work that does not depend on any clock.
    pub visits: u64,
}

impl CurveIntersections {
    /// Whether the curves have nothing in common.
    pub fn is_empty(&self) -> bool {
        self.crossings.is_empty() && self.overlaps.is_empty()
    }

    /// The same with first and second curve exchanged.
    #[must_use]
    pub(super) fn swapped(mut self) -> Self {
        for c in &mut self.crossings {
            (c.a, c.b) = (c.b, c.a);
        }
        for o in &mut self.overlaps {
            (o.a, o.b) = if o.same_direction { (o.b, o.a) } else { (o.b.reversed(), o.a.reversed()) };
        }
        self.sort();
        self
    }

    pub(super) fn sort(&mut self) {
        self.crossings.sort_by(|x, y| x.a.total_cmp(&y.a).then(x.b.total_cmp(&y.b)));
        let key = |o: &Overlap| (o.a.start, o.b.start);
        self.overlaps.sort_by(|x, y| key(x).0.total_cmp(&key(y).0).then(key(x).1.total_cmp(&key(y).1)));
    }
}
