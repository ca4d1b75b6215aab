//! Noises: smooth functions of places that look random, the same on each machine for the same seed.
//!
//! Each takes a place of any number of dimensions; random numbers come from a hash of whole coordinates, so that there is
//! no table and no period.

/// A vector with a smaller square of its length is not used: few bits of its direction would be drawn.
const SHORT: f64 = 1e-4;
/// The multiplier of SplitMix64 (Steele, Lea, Flood, *Fast splittable pseudorandom number generators*, 2014).
const GOLDEN: u64 = 0x9e37_79b9_7f4a_7c15;

/// Mixes the bits of a number so that each depends on all: the finisher of SplitMix64.
fn mixed(mut x: u64) -> u64 {
    x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    x ^ (x >> 31)
}

/// A random number for a cell.
fn hash<const N: usize>(seed: i32, cell: [i64; N]) -> u64 {
    let start = mixed(GOLDEN.wrapping_add(u64::from(seed.cast_unsigned())));
    cell.iter().fold(start, |hash, x| mixed(hash.wrapping_add(GOLDEN) ^ x.cast_unsigned()))
}

/// A hash as a number from 0 to below 1, of 53 random bits.
fn unit(hash: u64) -> f64 {
    (hash >> 11) as f64 / (1_u64 << 53) as f64
}

/// A random number from -1 to 1 for a cell.
fn corner<const N: usize>(seed: i32, cell: [i64; N]) -> f64 {
    2.0 * unit(hash(seed, cell)) - 1.0
}

/// The cell of a place, and where in it the place lies.
fn split<const N: usize>(p: [f64; N]) -> ([i64; N], [f64; N]) {
    let whole = p.map(f64::floor);
    let mut part = p;
    for (x, floor) in part.iter_mut().zip(whole) {
        *x -= floor;
    }
    (whole.map(|x| x as i64), part)
}

/// A gradient of length 1 for a cell: a random place in the unit ball, pushed out to the sphere, so that no direction is
/// preferred.
fn gradient<const N: usize>(seed: i32, cell: [i64; N]) -> [f64; N] {
    let mut state = hash(seed, cell);
    // In four dimensions three of ten tries hit the ball: a hundred that all miss are out of the question.
    for _ in 0..100 {
        let g: [f64; N] = std::array::from_fn(|_| {
            state = mixed(state.wrapping_add(GOLDEN));
            2.0 * unit(state) - 1.0
        });
        let square: f64 = g.iter().map(|x| x * x).sum();
        if square > SHORT && square <= 1.0 {
            let length = square.sqrt();
            return g.map(|x| x / length);
        }
    }
    std::array::from_fn(|k| if k == 0 { 1.0 } else { 0.0 })
}

fn dot<const N: usize>(a: [f64; N], b: [f64; N]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// How values between corners are found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Blend {
    /// Straight lines.
    Linear,
    /// 3t² − 2t³: slopes are 0 at the corners.
    Hermite,
    /// 6t⁵ − 15t⁴ + 10t³: curvatures are 0 too (K. Perlin, *Improving noise*, 2002).
    Quintic,
}

impl Blend {
    /// The one of a number: 0 linear, 1 Hermite, others quintic.
    pub(crate) fn of(number: i32) -> Self {
        match number {
            0 => Self::Linear,
            1 => Self::Hermite,
            _ => Self::Quintic,
        }
    }

    fn at(self, t: f64) -> f64 {
        match self {
            Self::Linear => t,
            Self::Hermite => t * t * (3.0 - 2.0 * t),
            Self::Quintic => t * t * t * (t * (t * 6.0 - 15.0) + 10.0),
        }
    }
}

/// Blends a value at each of the 2ᴺ corners of the cell of a place.
fn blended<const N: usize>(p: [f64; N], blend: Blend, value: impl Fn([i64; N], [f64; N]) -> f64) -> f64 {
    let (cell, part) = split(p);
    let shares = part.map(|t| blend.at(t));
    (0..1_usize << N)
        .map(|bits| {
            let up = |k: usize| (bits >> k) & 1 == 1;
            let mut weight = 1.0;
            let (mut at, mut offset) = (cell, part);
            for (k, ((x, off), share)) in at.iter_mut().zip(&mut offset).zip(shares).enumerate() {
                if up(k) {
                    *x = x.wrapping_add(1);
                    *off -= 1.0;
                    weight *= share;
                } else {
                    weight *= 1.0 - share;
                }
            }
            if weight == 0.0 { 0.0 } else { weight * value(at, offset) }
        })
        .sum()
}

/// Value noise: random values at whole coordinates, blended. From -1 to 1.
pub(crate) fn value<const N: usize>(seed: i32, p: [f64; N], blend: Blend) -> f64 {
    blended(p, blend, |cell, _| corner(seed, cell))
}

/// Gradient noise (K. Perlin, *An image synthesizer*, 1985): random slopes at whole coordinates, where it is 0. From -1 to 1.
pub(crate) fn perlin_blended<const N: usize>(seed: i32, p: [f64; N], blend: Blend) -> f64 {
    // In the middle of a cell all N half sides may add up along unit gradients: √N / 2 is the most.
    let most = (N as f64).sqrt() / 2.0;
    blended(p, blend, |cell, offset| dot(gradient(seed, cell), offset)) / most
}

/// Gradient noise with quintic blending.
pub(crate) fn perlin<const N: usize>(seed: i32, p: [f64; N]) -> f64 {
    perlin_blended(seed, p, Blend::Quintic)
}

/// What brings the sum of simplex noise to at most 1, by dimension: one over the largest sum of (½ − d²)⁴·d over the corners of
/// a simplex, found by search.
const SIMPLEX: [f64; 4] = [71.5, 99.2, 107.65, 108.56];

/// Simplex noise (K. Perlin, *Noise hardware*, 2001; S. Gustavson, *Simplex noise demystified*, 2005), with reach ½ so that it is
/// smooth everywhere. From -1 to 1.
pub(crate) fn simplex<const N: usize>(seed: i32, p: [f64; N]) -> f64 {
    let n = N as f64;
    let skew = ((n + 1.0).sqrt() - 1.0) / n;
    let back = (1.0 - 1.0 / (n + 1.0).sqrt()) / n;
    let shift = p.iter().sum::<f64>() * skew;
    let (cell, _) = split(p.map(|x| x + shift));
    let origin = cell.iter().map(|x| *x as f64).sum::<f64>() * back;
    let mut first = p;
    for (x, c) in first.iter_mut().zip(cell) {
        *x -= c as f64 - origin;
    }
    // The simplex is entered along the axes by size of the coordinates.
    let mut order: [usize; N] = std::array::from_fn(|k| k);
    let size = |k: usize| first.get(k).copied().unwrap_or(0.0);
    order.sort_by(|a, b| size(*b).total_cmp(&size(*a)).then(a.cmp(b)));
    let (mut at, mut offset) = (cell, first);
    let mut sum = 0.0;
    for step in 0..=N {
        let reach = 0.5 - dot(offset, offset);
        if reach > 0.0 {
            sum += reach * reach * reach * reach * dot(gradient(seed, at), offset);
        }
        if let Some(axis) = order.get(step).copied() {
            for (k, (x, off)) in at.iter_mut().zip(&mut offset).enumerate() {
                if k == axis {
                    *x = x.wrapping_add(1);
                    *off -= 1.0;
                }
                *off += back;
            }
        }
    }
    let scale = SIMPLEX.get(N.saturating_sub(1)).copied().unwrap_or(1.0);
    (sum * scale).clamp(-1.0, 1.0)
}

/// Cubic noise: random values at whole coordinates, with cubics of Catmull and Rom through them. From -1 to 1.
pub(crate) fn cubic<const N: usize>(seed: i32, p: [f64; N]) -> f64 {
    let (cell, part) = split(p);
    let weights = part.map(|t| {
        let (t2, t3) = (t * t, t * t * t);
        [
            -0.5 * t3 + t2 - 0.5 * t,
            1.5 * t3 - 2.5 * t2 + 1.0,
            -1.5 * t3 + 2.0 * t2 + 0.5 * t,
            0.5 * t3 - 0.5 * t2,
        ]
    });
    let sum: f64 = (0..1_usize << (2 * N))
        .map(|bits| {
            let mut weight = 1.0;
            let mut at = cell;
            for (k, (x, weights)) in at.iter_mut().zip(&weights).enumerate() {
                let step = (bits >> (2 * k)) & 3;
                *x = x.wrapping_add(step as i64 - 1);
                weight *= weights.get(step).copied().unwrap_or(0.0);
            }
            weight * corner(seed, at)
        })
        .sum();
    // Half way between corners the sizes of the weights add up to 1.25 a dimension.
    sum / 1.25_f64.powi(i32::try_from(N).unwrap_or(1))
}

/// White noise: a random value for each cell. From -1 to 1.
pub(crate) fn white<const N: usize>(seed: i32, p: [f64; N]) -> f64 {
    corner(seed, split(p).0)
}

/// How distances to the points of cellular noise are measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Metric {
    Euclidean,
    /// The sum of the differences.
    Manhattan,
    /// The sum of the differences and of their squares: what FastNoise calls natural.
    Natural,
}

impl Metric {
    /// The one of a number: 0 Euclidean, 1 Manhattan, others natural.
    pub(crate) fn of(number: i32) -> Self {
        match number {
            0 => Self::Euclidean,
            1 => Self::Manhattan,
            _ => Self::Natural,
        }
    }

    fn size<const N: usize>(self, d: [f64; N]) -> f64 {
        let sum = || d.iter().map(|x| x.abs()).sum::<f64>();
        match self {
            Self::Euclidean => dot(d, d).sqrt(),
            Self::Manhattan => sum(),
            Self::Natural => sum() + dot(d, d),
        }
    }
}

/// What the points of cellular noise near a place tell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Cells {
    /// The distance to the nearest point.
    pub(crate) first: f64,
    /// The distance to the next one.
    pub(crate) second: f64,
    /// A random number of the nearest point, from -1 to 1.
    pub(crate) value: f64,
}

/// Cellular noise (S. Worley, *A cellular texture basis function*, 1996): a point in each cell, moved from its centre by up to half
/// a cell times `jitter`.
pub(crate) fn cells<const N: usize>(seed: i32, p: [f64; N], jitter: f64, metric: Metric) -> Cells {
    let (cell, part) = split(p);
    // Two cells around hold the nearest point for certain; in four dimensions one cell has to do.
    let reach: i64 = if N > 3 { 1 } else { 2 };
    let side = (2 * reach + 1) as usize;
    let mut found = Cells { first: f64::INFINITY, second: f64::INFINITY, value: 0.0 };
    for number in 0..side.pow(u32::try_from(N).unwrap_or(1)) {
        let mut rest = number;
        let steps: [i64; N] = std::array::from_fn(|_| {
            let step = (rest % side) as i64 - reach;
            rest /= side;
            step
        });
        let mut at = cell;
        for (x, step) in at.iter_mut().zip(steps) {
            *x = x.wrapping_add(step);
        }
        let start = hash(seed, at);
        let mut state = start;
        let mut offset = part;
        for (x, step) in offset.iter_mut().zip(steps) {
            state = mixed(state.wrapping_add(GOLDEN));
            *x -= step as f64 + 0.5 + jitter * (unit(state) - 0.5);
        }
        let far = metric.size(offset);
        if far < found.first {
            found = Cells { first: far, second: found.first, value: 2.0 * unit(mixed(start)) - 1.0 };
        } else if far < found.second {
            found.second = far;
        }
    }
    found
}

/// The most octaves of a sum: each is half as large as the one before as a rule, and below rounding by then.
pub(crate) const MOST_OCTAVES: i32 = 32;

/// How octaves are added up.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Fractal {
    /// As they are: fractional Brownian motion.
    Brownian,
    /// Their sizes, so that valleys are sharp.
    Billow,
    /// One less their sizes, so that ridges are sharp.
    Rigid,
}

impl Fractal {
    /// The one of a number: 0 Brownian, 1 billow, others rigid.
    pub(crate) fn of(number: i32) -> Self {
        match number {
            0 => Self::Brownian,
            1 => Self::Billow,
            _ => Self::Rigid,
        }
    }

    /// The sum of octaves of a noise from -1 to 1, brought to that range. Each octave has its own seed.
    pub(crate) fn sum<const N: usize>(
        self,
        p: [f64; N],
        octaves: i32,
        lacunarity: f64,
        gain: f64,
        noise: impl Fn(i32, [f64; N]) -> f64,
    ) -> f64 {
        let (mut size, mut scale, mut sum, mut most) = (1.0, 1.0, 0.0, 0.0);
        for octave in 0..octaves.clamp(1, MOST_OCTAVES) {
            let x = noise(octave, p.map(|x| x * scale));
            sum += size
                * match self {
                    Self::Brownian => x,
                    Self::Billow => 2.0 * x.abs() - 1.0,
                    Self::Rigid => 1.0 - 2.0 * x.abs(),
                };
            most += f64::abs(size);
            size *= gain;
            scale *= lacunarity;
        }
        if most > 0.0 { sum / most } else { 0.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Places spread over many cells, without a pattern that a cell would share.
    fn places<const N: usize>(count: usize) -> impl Iterator<Item = [f64; N]> {
        (0..count).map(|i| {
            std::array::from_fn(|k| {
                let x = mixed((i * N + k) as u64);
                unit(x) * 200.0 - 100.0
            })
        })
    }

    fn statistics<const N: usize>(noise: impl Fn([f64; N]) -> f64) -> (f64, f64, f64) {
        let values: Vec<f64> = places::<N>(20_000).map(noise).collect();
        let mean = values.iter().sum::<f64>() / values.len() as f64;
        let square = values.iter().map(|x| x * x).sum::<f64>() / values.len() as f64;
        let most = values.iter().fold(0.0, |a: f64, x| a.max(x.abs()));
        (mean, square.sqrt(), most)
    }

    #[test]
    fn noises_keep_their_range_and_have_no_bias() {
        let all: [(&str, f64, (f64, f64, f64)); 10] = [
            ("perlin 2", 0.02, statistics::<2>(|p| perlin(1, p))),
            ("perlin 3", 0.02, statistics::<3>(|p| perlin(1, p))),
            ("perlin 4", 0.02, statistics::<4>(|p| perlin(1, p))),
            ("simplex 2", 0.02, statistics::<2>(|p| simplex(1, p))),
            ("simplex 3", 0.02, statistics::<3>(|p| simplex(1, p))),
            ("simplex 4", 0.02, statistics::<4>(|p| simplex(1, p))),
            ("value 3", 0.02, statistics::<3>(|p| value(1, p, Blend::Quintic))),
            ("cubic 2", 0.02, statistics::<2>(|p| cubic(1, p))),
            ("cubic 4", 0.02, statistics::<4>(|p| cubic(1, p))),
            ("white 3", 0.02, statistics::<3>(|p| white(1, p))),
        ];
        for (name, bias, (mean, deviation, most)) in all {
            assert!(mean.abs() < bias, "{name}: mean {mean}");
            assert!(most <= 1.0, "{name}: {most}");
            assert!(deviation > 0.05, "{name}: deviation {deviation}");
        }
        // Numbers that are spread evenly from -1 to 1 deviate by 1/√3.
        let (_, deviation, _) = statistics::<3>(|p| white(7, p));
        assert!((deviation - 1.0 / 3_f64.sqrt()).abs() < 0.01);
    }

    #[test]
    fn noises_are_smooth() {
        let jump = |noise: &dyn Fn([f64; 3]) -> f64| {
            let step = 1e-4;
            (0..40_000)
                .map(|i| {
                    let at = |k: f64| [k * step, 0.3 + 0.7 * k * step, 0.1 - 0.4 * k * step];
                    (noise(at(f64::from(i) + 1.0)) - noise(at(f64::from(i)))).abs()
                })
                .fold(0.0, f64::max)
        };
        for noise in
            [&(|p| perlin(3, p)) as &dyn Fn([f64; 3]) -> f64, &|p| simplex(3, p), &|p| cubic(3, p), &|p| {
                value(3, p, Blend::Hermite)
            }]
        {
            // Slopes stay below ten a cell.
            assert!(jump(noise) < 1.5e-3, "{}", jump(noise));
        }
    }

    #[test]
    fn gradient_noise_is_nothing_at_whole_places() {
        for p in [[0.0, 0.0, 0.0], [3.0, -2.0, 5.0], [100.0, 7.0, -1.0]] {
            assert_eq!(perlin(5, p), 0.0);
        }
        assert_ne!(perlin(5, [0.5, 0.5, 0.5]), perlin(6, [0.5, 0.5, 0.5]));
    }

    #[test]
    fn cells_without_jitter_are_a_grid() {
        // The points are centres of cells.
        let found = cells(1, [0.5, 0.5], 0.0, Metric::Euclidean);
        assert_eq!((found.first, found.second), (0.0, 1.0));
        let found = cells(1, [1.0, 0.5], 0.0, Metric::Euclidean);
        assert_eq!((found.first, found.second), (0.5, 0.5));
        let found = cells(1, [0.0, 0.0, 0.0], 0.0, Metric::Manhattan);
        assert_eq!(found.first, 1.5);
        assert!(places::<3>(2000).all(|p| {
            let found = cells(4, p, 1.0, Metric::Euclidean);
            found.first <= found.second && found.first <= 3_f64.sqrt()
        }));
    }

    #[test]
    fn octaves_keep_the_range() {
        for fractal in [Fractal::Brownian, Fractal::Billow, Fractal::Rigid] {
            let (_, _, most) = statistics::<2>(|p| fractal.sum(p, 6, 2.0, 0.5, perlin));
            assert!(most <= 1.0, "{most}");
        }
    }
}
