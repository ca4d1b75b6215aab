//! Walks over a tree of boxes by any test, and over two trees at once.

use std::ops::ControlFlow;

use super::{Bounds, BoxTree, DEEPEST, LEAF};
use crate::cancellation;

/// Whether two boxes come within `margin` of each other along every axis.
#[inline]
pub(crate) fn boxes_meet(a: &Bounds, b: &Bounds, margin: f64) -> bool {
    (0..3).all(|c| a[0][c] <= b[1][c] + margin && b[0][c] <= a[1][c] + margin)
}

impl BoxTree {
    /// Visits the things whose boxes, and all boxes around them, `enter` lets in, until a visit breaks off.
    #[inline]
    pub(crate) fn visit_where(
        &self,
        mut enter: impl FnMut(&Bounds) -> bool,
        mut visit: impl FnMut(usize) -> ControlFlow<()>,
    ) {
        let mut stack = [0_u32; DEEPEST];
        let mut top = 1;
        while top > 0 {
            top -= 1;
            let mut here = stack[top];
            while let Some(node) = self.nodes.get(here as usize) {
                if !enter(&node.bounds) {
                    break;
                }
                if node.link & LEAF != 0 {
                    if visit((node.link & !LEAF) as usize).is_break() {
                        return;
                    }
                    break;
                }
                if top < DEEPEST {
                    stack[top] = node.link;
                    top += 1;
                }
                here += 1;
            }
        }
    }

    /// Visits all pairs of a thing here and a thing there whose boxes come within `margin` of each other, until a visit
    /// breaks off.
    pub(crate) fn visit_pairs(
        &self,
        other: &Self,
        margin: f64,
        mut visit: impl FnMut(usize, usize) -> ControlFlow<()>,
    ) {
        let size = |b: &Bounds| (0..3).map(|c| b[1][c] - b[0][c]).sum::<f64>();
        let (mut stack, mut steps) = (vec![(0_u32, 0_u32)], 0_u32);
        while let Some((i, j)) = stack.pop() {
            steps = steps.wrapping_add(1);
            // Who waits no longer does not look at what was found either.
            if steps.is_multiple_of(1024) && cancellation::check_now().is_err() {
                return;
            }
            let (Some(a), Some(b)) = (self.nodes.get(i as usize), other.nodes.get(j as usize)) else {
                continue;
            };
            if !boxes_meet(&a.bounds, &b.bounds, margin) {
                continue;
            }
            match (a.link & LEAF != 0, b.link & LEAF != 0) {
                (true, true) => {
                    if visit((a.link & !LEAF) as usize, (b.link & !LEAF) as usize).is_break() {
                        return;
                    }
                }
                // The larger box is opened first, so that both shrink together.
                (false, last) if last || size(&a.bounds) >= size(&b.bounds) => {
                    stack.extend([(a.link, j), (i + 1, j)]);
                }
                _ => stack.extend([(i, b.link), (i, j + 1)]),
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use std::ops::ControlFlow;

    use super::boxes_meet;
    use crate::box_tree::BoxTree;

    #[test]
    fn all_pairs_and_no_others() {
        let boxes = |shift: f64| -> Vec<_> {
            (0..60)
                .map(|i| f64::from(i) * 1.7 + shift)
                .map(|i| {
                    let p = [i.sin() * 3.0, (1.3 * i).cos() * 3.0, (0.4 * i).sin() * 3.0];
                    [p, p.map(|x| x + 0.5)]
                })
                .collect()
        };
        let (a, b) = (boxes(0.0), boxes(0.3));
        let (s, t) = (BoxTree::by_place(&a), BoxTree::by_place(&b));
        let mut found = Vec::new();
        s.visit_pairs(&t, 0.01, |i, j| {
            found.push((i, j));
            ControlFlow::Continue(())
        });
        found.sort_unstable();
        let all = (0..60).flat_map(|i| (0..60).map(move |j| (i, j)));
        let want: Vec<_> = all.filter(|&(i, j)| boxes_meet(&a[i], &b[j], 0.01)).collect();
        assert_eq!(found, want);
        assert!(found.len() > 10);
        let mut seen = 0;
        s.visit_where(
            |_| true,
            |_| {
                seen += 1;
                if seen == 7 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
            },
        );
        assert_eq!(seen, 7);
        BoxTree::default().visit_pairs(&t, 1.0, |_, _| panic!("nothing is there"));
    }
}
