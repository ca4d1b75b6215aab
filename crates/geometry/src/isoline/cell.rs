//! How lines of equal height run through one cell of a grid.

/// A way through a cell, from one of its sides to another: 0 bottom, 1 right, 2 top, 3 left.
pub(crate) type Way = [u8; 2];

/// No way.
const NONE: Way = [4, 4];

/// The ways by which corners are high, bit 0 the corner at the lower left, then counter-clockwise; high on the left.
/// Cells whose high corners face each other are settled apart.
const WAYS: [Way; 16] = [
    NONE,
    [0, 3],
    [1, 0],
    [1, 3],
    [2, 1],
    NONE,
    [2, 0],
    [2, 3],
    [3, 2],
    [0, 2],
    NONE,
    [1, 2],
    [3, 1],
    [0, 1],
    [3, 0],
    NONE,
];

/// The ways of the line of height 0 through a cell with given heights at its corners, counter-clockwise from the lower
/// left. A height of 0 counts as high.
#[inline]
pub(crate) fn ways(heights: [f64; 4]) -> (Way, Option<Way>) {
    let case = heights.iter().enumerate().fold(0_usize, |case, (k, &h)| case | usize::from(h >= 0.0) << k);
    ways_of(case, highs_joined(heights))
}

/// Whether the high corners of a cell are joined where they face each other: the height at the saddle of the bilinear
/// surface through the corners tells (G. M. Nielson, B. Hamann, *The asymptotic decider*, 1991). It has the sign of the
/// product of the high corners less that of the low ones. Whichever corner comes first, the answer is the same.
#[inline]
pub(crate) fn highs_joined([a, b, c, d]: [f64; 4]) -> bool {
    if a >= 0.0 { a * c >= b * d } else { b * d >= a * c }
}

/// The ways by which corners are high, bit 0 the first, and whether two that face each other are joined.
#[inline]
pub(crate) fn ways_of(case: usize, joined: bool) -> (Way, Option<Way>) {
    match (case, joined) {
        (5, true) => ([0, 1], Some([2, 3])),
        (5, false) => ([0, 3], Some([2, 1])),
        (10, true) => ([3, 0], Some([1, 2])),
        (10, false) => ([1, 0], Some([3, 2])),
        _ => (WAYS.get(case).copied().unwrap_or(NONE), None),
    }
}

/// Whether a way is one.
#[inline]
pub(crate) fn is_way(way: Way) -> bool {
    way[0] < 4
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn high_lies_to_the_left() {
        // The middle of each side and the corners.
        let side = [[0.5, 0.0], [1.0, 0.5], [0.5, 1.0], [0.0, 0.5]];
        let corner = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        for case in 0..16_u32 {
            for tilt in [0.1, -0.1] {
                let h: [f64; 4] =
                    std::array::from_fn(|k| if case >> k & 1 == 1 { 1.0 + tilt } else { -1.0 + tilt });
                let (first, second) = ways(h);
                let all: Vec<Way> =
                    [Some(first), second].into_iter().flatten().filter(|w| is_way(*w)).collect();
                assert_eq!(all.is_empty(), case == 0 || case == 15);
                for [from, to] in all {
                    // Each end parts a high corner on its left from a low one on its right.
                    let (from, to) = (usize::from(from), usize::from(to));
                    assert!(h[from] < 0.0 || h[(from + 1) % 4] < 0.0);
                    assert!((h[from] >= 0.0) != (h[(from + 1) % 4] >= 0.0));
                    let (p, q) = (side[from], side[to]);
                    let left = |c: [f64; 2]| (q[0] - p[0]) * (c[1] - p[1]) - (q[1] - p[1]) * (c[0] - p[0]);
                    for c in [from, (from + 1) % 4] {
                        assert_eq!(left(corner[c]) > 0.0, h[c] >= 0.0, "case {case}");
                    }
                }
            }
        }
        // Joined across the saddle, so that the low corners are cut off.
        assert_eq!(ways([2.0, -1.0, 2.0, -1.0]), ([0, 1], Some([2, 3])));
        assert_eq!(ways([1.0, -2.0, 1.0, -2.0]), ([0, 3], Some([2, 1])));
    }
}
