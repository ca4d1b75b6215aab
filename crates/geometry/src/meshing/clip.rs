//! How a segment meets a rectangle. All answers are exact.

use super::outline::{Outline, side};
use crate::Point2;

/// How a segment that touches a closed rectangle does so.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Contact {
    /// It passes through, or touches it elsewhere than below.
    Through,
    /// It lies within one side.
    Along,
    /// One of its ends is a corner of the rectangle, and nothing else of it is in the rectangle.
    Corner,
}

/// Whether a segment and a closed rectangle have a point in common.
pub(super) fn touches(a: Point2, b: Point2, [u, v]: [[f64; 2]; 2]) -> bool {
    if a.x.max(b.x) < u[0] || a.x.min(b.x) > u[1] || a.y.max(b.y) < v[0] || a.y.min(b.y) > v[1] {
        return false;
    }
    let corners = [(u[0], v[0]), (u[1], v[0]), (u[1], v[1]), (u[0], v[1])];
    let sides = corners.map(|(x, y)| side(a, b, Point2::new(x, y)));
    !(sides.iter().all(|s| *s > 0.0) || sides.iter().all(|s| *s < 0.0))
}

/// How a segment touches a closed rectangle; [`Contact::Corner`] also when it does not touch it.
pub(super) fn contact(a: Point2, b: Point2, own: [[f64; 2]; 2]) -> Contact {
    let of = |p: Point2, d: usize| if d == 0 { p.x } else { p.y };
    let within = |x: f64, d: usize| x >= own[d][0] && x <= own[d][1];
    for d in 0..2 {
        let level = of(a, d);
        if level != of(b, d) || !(level == own[d][0] || level == own[d][1]) {
            continue;
        }
        let (x, y) = (of(a, 1 - d), of(b, 1 - d));
        if within(x, 1 - d) && within(y, 1 - d) {
            return Contact::Along;
        }
        // On the line of a side, but beyond it.
        if x.max(y) <= own[1 - d][0] || x.min(y) >= own[1 - d][1] {
            return Contact::Corner;
        }
        return Contact::Through;
    }
    for (p, q) in [(a, b), (b, a)] {
        let is_corner = (0..2).all(|d| of(p, d) == own[d][0] || of(p, d) == own[d][1]);
        let leaves = (0..2).any(|d| {
            (of(p, d) == own[d][0] && of(q, d) < own[d][0]) || (of(p, d) == own[d][1] && of(q, d) > own[d][1])
        });
        if is_corner && leaves {
            return Contact::Corner;
        }
    }
    if touches(a, b, own) { Contact::Through } else { Contact::Corner }
}

impl Outline {
    /// Whether no segment touches a closed rectangle.
    pub(super) fn none_touches(&self, own: [[f64; 2]; 2]) -> bool {
        self.near(own[1]).all(|k| self.segment(k).is_none_or(|[a, b]| !touches(a.uv, b.uv, own)))
    }
}

#[cfg(test)]
mod tests {
    use super::{Contact, contact, touches};
    use crate::Point2;

    #[test]
    fn contacts() {
        let own = [[0.0, 1.0], [0.0, 1.0]];
        let case = |a: [f64; 2], b: [f64; 2]| {
            let (a, b) = (Point2::new(a[0], a[1]), Point2::new(b[0], b[1]));
            (touches(a, b, own), contact(a, b, own))
        };
        assert_eq!(case([0.0, 0.0], [1.0, 0.0]), (true, Contact::Along));
        assert_eq!(case([0.2, 1.0], [0.7, 1.0]), (true, Contact::Along));
        assert_eq!(case([-0.2, 1.0], [0.7, 1.0]), (true, Contact::Through));
        assert_eq!(case([1.0, 0.0], [2.0, 0.0]), (true, Contact::Corner));
        assert_eq!(case([0.0, 0.0], [-1.0, 0.5]), (true, Contact::Corner));
        assert_eq!(case([0.0, 0.0], [1.0, 0.5]), (true, Contact::Through));
        assert_eq!(case([0.5, 0.0], [0.5, -1.0]), (true, Contact::Through));
        assert_eq!(case([-1.0, 0.5], [2.0, 0.6]), (true, Contact::Through));
        assert!(!case([-1.0, 0.5], [0.4, 2.0]).0);
    }
}
