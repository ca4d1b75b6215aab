//! Sobol's sequence: points that fill a cube evenly.

use crate::random::{hashed, unit};

/// How many coordinates a point may have.
pub(crate) const DIMENSIONS: usize = NUMBERS.len() + 1;
/// Bits of a coordinate; the sequence repeats after 2^52 points.
const BITS: usize = 52;

/// Sobol's sequence in base 2, with a digital shift for each seed but 0: the points of a seed fill the cube as evenly as those
/// of the sequence itself.
#[derive(Debug, Clone)]
pub(crate) struct Sobol {
    /// For each coordinate, the direction number of each bit.
    directions: Vec<[u64; BITS]>,
    shifts: Vec<u64>,
}

impl Sobol {
    /// The sequence in so many dimensions, at most [`DIMENSIONS`].
    pub(crate) fn new(dimensions: usize, seed: u64) -> Self {
        let shift = |d: usize| if seed == 0 { 0 } else { hashed(seed, d as u64, 0) >> (64 - BITS) };
        let dimensions = dimensions.min(DIMENSIONS);
        Self {
            directions: (0..dimensions).map(directions).collect(),
            shifts: (0..dimensions).map(shift).collect(),
        }
    }

    /// Point `k`, numbers from 0 to 1, without 1. The first point of seed 0 is the origin.
    pub(crate) fn point(&self, k: u64) -> Vec<f64> {
        let coordinate = |(directions, shift): (&[u64; BITS], &u64)| {
            let bits = directions
                .iter()
                .enumerate()
                .filter(|(bit, _)| k >> bit & 1 == 1)
                .fold(*shift, |x, (_, v)| x ^ v);
            unit(bits << (64 - BITS))
        };
        self.directions.iter().zip(&self.shifts).map(coordinate).collect()
    }
}

/// The direction numbers of a coordinate by the recurrence of its primitive polynomial (Bratley, Fox 1988, Algorithm 659).
fn directions(dimension: usize) -> [u64; BITS] {
    let mut v = [0_u64; BITS];
    let Some((a, m)) = dimension.checked_sub(1).and_then(|k| NUMBERS.get(k)) else {
        for (bit, v) in v.iter_mut().enumerate() {
            *v = 1 << (BITS - 1 - bit);
        }
        return v;
    };
    let s = m.len();
    for bit in 0..BITS {
        v[bit] = match m.get(bit) {
            Some(m) => m << (BITS - 1 - bit),
            None => (1..s)
                .filter(|k| a >> (s - 1 - k) & 1 == 1)
                .fold(v[bit - s] ^ (v[bit - s] >> s), |x, k| x ^ v[bit - k]),
        };
    }
    v
}

/// For each coordinate from the second on: the inner coefficients of its primitive polynomial, and the first direction numbers
/// (Joe, Kuo 2008, "Constructing Sobol sequences with better two-dimensional projections", set D(6)).
const NUMBERS: &[(u64, &[u64])] = &[
    (0, &[1]),
    (1, &[1, 3]),
    (1, &[1, 3, 1]),
    (2, &[1, 1, 1]),
    (1, &[1, 1, 3, 3]),
    (4, &[1, 3, 5, 13]),
    (2, &[1, 1, 5, 5, 17]),
    (4, &[1, 1, 5, 5, 5]),
    (7, &[1, 1, 7, 11, 19]),
    (11, &[1, 1, 5, 1, 1]),
    (13, &[1, 1, 1, 3, 11]),
    (14, &[1, 3, 5, 5, 31]),
    (1, &[1, 3, 3, 9, 7, 49]),
    (13, &[1, 1, 1, 15, 21, 21]),
    (16, &[1, 3, 1, 13, 27, 49]),
    (19, &[1, 1, 1, 15, 7, 5]),
    (22, &[1, 3, 1, 15, 13, 25]),
    (25, &[1, 1, 5, 5, 19, 61]),
    (1, &[1, 3, 7, 11, 23, 15, 103]),
    (4, &[1, 3, 7, 13, 13, 15, 69]),
    (7, &[1, 1, 3, 13, 7, 35, 63]),
    (8, &[1, 3, 5, 9, 1, 25, 53]),
    (14, &[1, 3, 1, 13, 9, 35, 107]),
    (19, &[1, 3, 1, 5, 27, 61, 31]),
    (21, &[1, 1, 5, 11, 19, 41, 61]),
    (28, &[1, 3, 5, 3, 3, 13, 69]),
    (31, &[1, 1, 7, 13, 1, 19, 1]),
    (32, &[1, 3, 7, 5, 13, 19, 59]),
    (37, &[1, 1, 3, 9, 25, 29, 41]),
    (41, &[1, 3, 5, 13, 23, 1, 55]),
    (42, &[1, 3, 7, 3, 13, 59, 17]),
    (50, &[1, 3, 1, 3, 5, 53, 69]),
    (55, &[1, 1, 5, 5, 23, 33, 13]),
    (56, &[1, 1, 7, 7, 1, 61, 123]),
    (59, &[1, 1, 7, 9, 13, 61, 49]),
    (62, &[1, 3, 3, 5, 3, 55, 33]),
    (14, &[1, 3, 1, 15, 31, 13, 49, 245]),
    (21, &[1, 3, 5, 15, 31, 59, 63, 97]),
    (22, &[1, 3, 1, 11, 11, 11, 77, 249]),
    (38, &[1, 3, 1, 11, 27, 43, 71, 9]),
    (47, &[1, 1, 7, 15, 21, 11, 81, 45]),
    (49, &[1, 3, 7, 3, 25, 31, 65, 79]),
    (50, &[1, 3, 1, 1, 19, 11, 3, 205]),
    (52, &[1, 1, 5, 9, 19, 21, 29, 157]),
    (56, &[1, 3, 7, 11, 1, 33, 89, 185]),
    (67, &[1, 3, 3, 3, 15, 9, 79, 71]),
    (70, &[1, 3, 7, 11, 15, 39, 119, 27]),
    (84, &[1, 1, 3, 1, 11, 31, 97, 225]),
    (97, &[1, 1, 1, 3, 23, 43, 57, 177]),
    (103, &[1, 3, 7, 7, 17, 17, 37, 71]),
    (115, &[1, 3, 1, 5, 27, 63, 123, 213]),
    (122, &[1, 1, 3, 5, 11, 43, 53, 133]),
    (8, &[1, 3, 5, 5, 29, 17, 47, 173, 479]),
    (13, &[1, 3, 3, 11, 3, 1, 109, 9, 69]),
    (16, &[1, 1, 1, 5, 17, 39, 23, 5, 343]),
    (22, &[1, 3, 1, 5, 25, 15, 31, 103, 499]),
    (25, &[1, 1, 1, 11, 11, 17, 63, 105, 183]),
    (44, &[1, 1, 5, 11, 9, 29, 97, 231, 363]),
    (47, &[1, 1, 5, 15, 19, 45, 41, 7, 383]),
    (52, &[1, 3, 7, 7, 31, 19, 83, 137, 221]),
    (55, &[1, 1, 1, 3, 23, 15, 111, 223, 83]),
    (59, &[1, 1, 5, 13, 31, 15, 55, 25, 161]),
    (62, &[1, 1, 3, 13, 25, 47, 39, 87, 257]),
];

#[cfg(test)]
mod tests {
    use super::*;

    /// Of each power of two of points, each coordinate has one in each equal part, and each pair of the first two coordinates is a
    /// (0, 2)-sequence: one point in each box of that volume.
    #[test]
    fn points_are_a_net() {
        for seed in [0, 7] {
            let sobol = Sobol::new(DIMENSIONS, seed);
            let points: Vec<Vec<f64>> = (0..1024).map(|k| sobol.point(k)).collect();
            for dimension in 0..DIMENSIONS {
                let mut parts: Vec<usize> = points.iter().map(|p| (p[dimension] * 1024.0) as usize).collect();
                parts.sort_unstable();
                assert!(parts.into_iter().eq(0..1024), "{dimension}");
            }
            for split in 0..=10 {
                let (rows, columns) = (f64::from(1 << split), f64::from(1 << (10 - split)));
                let mut boxes: Vec<usize> = points
                    .iter()
                    .map(|p| (p[0] * rows) as usize * (1 << (10 - split)) + (p[1] * columns) as usize)
                    .collect();
                boxes.sort_unstable();
                assert!(boxes.into_iter().eq(0..1024), "{split}");
            }
        }
    }

    /// The first points as Joe and Kuo's own program gives them, in natural order.
    #[test]
    fn first_points() {
        let sobol = Sobol::new(3, 0);
        assert_eq!(sobol.point(0), [0.0, 0.0, 0.0]);
        assert_eq!(sobol.point(1), [0.5, 0.5, 0.5]);
        assert_eq!(sobol.point(3), [0.75, 0.25, 0.25]);
        assert_eq!(sobol.point(2), [0.25, 0.75, 0.75]);
    }
}
