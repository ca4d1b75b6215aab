//! Points as lists of numbers, and their sums.

use super::{Number, Quantity, Step};
use crate::NurbsCurve;

/// A control point with a name: x, y, z, and for rational curves w, in homogeneous form.
#[derive(Debug, Clone)]
pub(super) struct Named {
    pub(super) name: String,
    pub(super) numbers: Vec<Number>,
}

impl Named {
    pub(super) fn quantity(&self) -> Quantity {
        Quantity::new(self.name.clone(), self.numbers.clone())
    }
}

/// The control points of a curve, three numbers each, or four (x w, y w, z w, w) where some weight is not 1.
pub(super) fn controls(curve: &NurbsCurve, name: impl Fn(usize) -> String) -> Vec<Named> {
    let is_weighted = curve.weights().iter().any(|&weight| weight != 1.0);
    let numbers = |i: usize| -> Vec<Number> {
        let [x, y, z, w] = curve.homogeneous_point(i).unwrap_or([0.0, 0.0, 0.0, 1.0]);
        let all = [x, y, z, w].map(Number::given);
        if is_weighted { all.to_vec() } else { all.into_iter().take(3).collect() }
    };
    (0..curve.point_count()).map(|i| Named { name: name(i), numbers: numbers(i) }).collect()
}

/// The step from two points to the one that divides the line between them in the ratio `share` to the rest.
pub(super) fn between(name: String, a: &Named, b: &Named, share: Number) -> (Named, Step) {
    let rest = Number::given(1.0).minus(share);
    let pairs = a.numbers.iter().zip(&b.numbers);
    let numbers: Vec<Number> = pairs.map(|(a, b)| rest.times(*a).plus(share.times(*b))).collect();
    let made = Named { name, numbers };
    let step = Step {
        made: made.quantity(),
        rule: String::new(),
        terms: vec![(rest, a.name.clone()), (share, b.name.clone())],
    };
    (made, step)
}

/// The point itself: homogeneous coordinates divided by their weight.
pub(super) fn divided(numbers: &[Number]) -> Vec<Number> {
    match numbers {
        [x, y, z, w] => [x, y, z].map(|c| c.over(*w)).to_vec(),
        plain => plain.to_vec(),
    }
}
