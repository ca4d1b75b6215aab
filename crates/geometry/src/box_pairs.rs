//! Which boxes come near each other.

use std::ops::ControlFlow;

use crate::BoundingBox;
use crate::box_tree::{Bounds, BoxTree, boxes_meet};

fn bounds(b: &BoundingBox) -> Bounds {
    [b.min.into(), b.max.into()]
}

/// Boxes prepared for questions which of them come near another one.
#[derive(Debug, Clone)]
pub struct BoxIndex {
    tree: BoxTree,
}

impl BoxIndex {
    /// The index of some boxes. O(n log n) for n boxes.
    pub fn new<'a>(boxes: impl IntoIterator<Item = &'a BoundingBox>) -> Self {
        let boxes: Vec<Bounds> = boxes.into_iter().map(bounds).collect();
        Self { tree: BoxTree::by_place(&boxes) }
    }

    /// The boxes that come within `reach` of another along every axis, by their places in the list, increasing.
    pub fn near(&self, other: &BoundingBox, reach: f64) -> Vec<usize> {
        let mut out = Vec::new();
        self.visit(&bounds(other), reach, |i| {
            out.push(i);
            ControlFlow::Continue(())
        });
        out.sort_unstable();
        out
    }

    fn visit(&self, other: &Bounds, reach: f64, visit: impl FnMut(usize) -> ControlFlow<()>) {
        self.tree.visit_where(|b| boxes_meet(b, other, reach), visit);
    }
}

/// Pairs of boxes that come within reach of each other: within one list, or of one and another. Sorted; `None` when
/// there are more than `most`.
pub(crate) fn near_pairs(
    first: &[BoundingBox],
    second: Option<&[BoundingBox]>,
    reach: f64,
    most: usize,
) -> Option<Vec<(usize, usize)>> {
    let index = BoxIndex::new(second.unwrap_or(first));
    let mut out = Vec::new();
    for (i, own) in first.iter().enumerate() {
        let from = out.len();
        let mut many = false;
        index.visit(&bounds(own), reach, |j| {
            if second.is_some() || j > i {
                many = out.len() >= most;
                out.push((i, j));
            }
            if many { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        });
        if many {
            return None;
        }
        if let Some(found) = out.get_mut(from..) {
            found.sort_unstable();
        }
    }
    Some(out)
}

#[cfg(test)]
mod tests {
    use super::{BoxIndex, near_pairs};
    use crate::{BoundingBox, Point3, Vector3};

    fn boxes(n: u32, shift: f64) -> Vec<BoundingBox> {
        (0..n)
            .map(|i| f64::from(i) * 1.7 + shift)
            .map(|x| {
                let min = Point3::new(9.0 * x.sin(), 9.0 * (1.3 * x).cos(), (0.4 * x).sin());
                BoundingBox { min, max: min + Vector3::new(3.0, 2.0 + x.cos(), 0.0) }
            })
            .collect()
    }

    #[test]
    fn all_pairs_in_order() {
        let (a, b) = (boxes(120, 0.0), boxes(70, 0.3));
        let meet = |p: &BoundingBox, q: &BoundingBox| {
            let apart = |a: f64, b: f64, c: f64, d: f64| a > d + 0.1 || c > b + 0.1;
            !(apart(p.min.x, p.max.x, q.min.x, q.max.x)
                || apart(p.min.y, p.max.y, q.min.y, q.max.y)
                || apart(p.min.z, p.max.z, q.min.z, q.max.z))
        };
        let own: Vec<_> = (0..120)
            .flat_map(|i| (i + 1..120).map(move |j| (i, j)))
            .filter(|&(i, j)| meet(&a[i], &a[j]))
            .collect();
        assert_eq!(near_pairs(&a, None, 0.1, own.len()), Some(own.clone()));
        assert_eq!(near_pairs(&a, None, 0.1, own.len() - 1), None);
        let both: Vec<_> = (0..120)
            .flat_map(|i| (0..70).map(move |j| (i, j)))
            .filter(|&(i, j)| meet(&a[i], &b[j]))
            .collect();
        assert!(both.len() > 30 && own.len() > 30);
        assert_eq!(near_pairs(&a, Some(&b), 0.1, 1 << 20), Some(both.clone()));
        let index = BoxIndex::new(&b);
        let some: Vec<_> = both.iter().filter(|p| p.0 == both[9].0).map(|p| p.1).collect();
        assert_eq!(index.near(&a[both[9].0], 0.1), some);
        assert!(BoxIndex::new([]).near(&a[0], 1.0).is_empty());
    }
}
