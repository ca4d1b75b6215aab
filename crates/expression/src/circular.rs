//! Sine and cosine with the same bits on every machine: those of the C library differ between systems.
//!
//! One by one they are the functions of the crate `libm`, which follow FDLIBM (Sun Microsystems, 1993; its files
//! `s_sin.c`, `k_sin.c`, `k_cos.c`, `e_rem_pio2.c`), but for large angles: FDLIBM multiplies them with hundreds of bits of
//! 2/π (M. Payne and R. Hanek, Radian reduction for trigonometric functions, 1983), which takes ten times as long as the
//! rest. Up to 2³⁰ four parts of π/2 do (W. Cody and W. Waite, Software manual for the elementary functions, 1980).
//!
//! Over columns several angles go through the same operations side by side; an angle for which FDLIBM takes another way
//! than most is done by itself, so that the bits are the same.

/// Angles that go side by side.
const LANES: usize = 8;

/// Two over π.
const TURNS: f64 = std::f64::consts::FRAC_2_PI;
/// The first 33 bits of π/2: a product with a number of at most 20 bits is exact.
const QUARTER: f64 = 1.570_796_326_734_125_6;
/// π/2 less [`QUARTER`].
const QUARTER_REST: f64 = 6.077_100_506_506_192e-11;
/// A number added and taken away again rounds to an integer, whose last bits are then the last of the sum.
const TO_INTEGER: f64 = 1.5 / f64::EPSILON;
/// Larger angles have more quarter turns than the product above allows.
const LARGEST: f64 = 1e6;
/// From here on, 2²⁰ quarter turns, FDLIBM takes its long way.
const FAR: f64 = 1_647_099.0;
/// Up to here the products of quarter turns and the parts of π/2 are exact: 30 bits with 22.
const FARTHEST: f64 = 1_073_741_824.0;
/// π/2 in three parts of 22 bits, and the 53 bits after them.
const QUARTERS: [f64; 4] =
    [1.570_796_012_878_418, 3.139_164_164_167_596e-7, 6.223_371_969_669_989e-14, 2.022_266_248_795_950_6e-21];
/// What is left of an angle is known to 2⁻⁸⁷; if it is smaller than this, that may be too little for its last bit.
const TOO_NEAR: f64 = 1.0 / 1_048_576.0;
/// An angle so much nearer to a quarter turn than it is large needs more bits of π/2.
const CANCELS: f64 = 1.0 / 65536.0;
/// So near to an eighth of a turn the number of quarter turns is not found by rounding alone.
const NEAR_EIGHTH: f64 = std::f64::consts::FRAC_PI_4 - 1e-6;

/// Coefficients of the sine's polynomial on −π/4…π/4, from x³ on.
const SINE: [f64; 6] = [
    -1.666_666_666_666_663_2e-1,
    8.333_333_333_322_49e-3,
    -1.984_126_982_985_795e-4,
    2.755_731_370_707_006_8e-6,
    -2.505_076_025_340_686_3e-8,
    1.589_690_995_211_55e-10,
];
/// Coefficients of the cosine's polynomial there, from x⁴ on.
const COSINE: [f64; 6] = [
    4.166_666_666_666_66e-2,
    -1.388_888_888_887_411e-3,
    2.480_158_728_947_673e-5,
    -2.755_731_435_139_066_3e-7,
    2.087_572_321_298_175e-9,
    -1.135_964_755_778_819_5e-11,
];

/// The sine of an angle in radians.
pub fn sin(x: f64) -> f64 {
    far(x, 0).unwrap_or_else(|| libm::sin(x))
}

/// The cosine of an angle in radians.
pub fn cos(x: f64) -> f64 {
    far(x, 1).unwrap_or_else(|| libm::cos(x))
}

/// The sine of a large angle that is `ahead` quarter turns further; none where FDLIBM is as fast or has to be asked.
fn far(x: f64, ahead: u64) -> Option<f64> {
    if !(FAR..FARTHEST).contains(&x.abs()) {
        return None;
    }
    let sum = x * TURNS + TO_INTEGER;
    let turns = sum - TO_INTEGER;
    let [first, second, third, fourth] = QUARTERS;
    // Both differences are exact: their terms are of one size, and multiples of one power of two.
    let rest = (x - turns * first) - turns * second;
    // The next is the sum of two numbers (D. Knuth, The Art of Computer Programming 2, 4.2.2, theorem C).
    let product = turns * third;
    let near = rest - product;
    let back = near - rest;
    let lost = (rest - (near - back)) - (product + back);
    let small = lost - turns * fourth;
    let y = near + small;
    let tail = (near - y) + small;
    (y.abs() > TOO_NEAR).then(|| of_rest(y, tail, sum.to_bits().wrapping_add(ahead)))
}

/// Angles in radians become their sines.
pub fn sines(angles: &mut [f64]) {
    all(angles, 0, sin);
}

/// Angles in radians become their cosines.
pub fn cosines(angles: &mut [f64]) {
    all(angles, 1, cos);
}

fn all(angles: &mut [f64], ahead: u64, one: impl Fn(f64) -> f64) {
    let (blocks, rest) = angles.as_chunks_mut::<LANES>();
    for block in blocks {
        // The compiler sees two arrays that are filled alike.
        let (mut found, mut as_most) = ([0.0; LANES], true);
        for (slot, &x) in found.iter_mut().zip(block.iter()) {
            let (y, is_as_most) = lane(x, ahead);
            *slot = y;
            as_most &= is_as_most;
        }
        *block = if as_most { found } else { block.map(&one) };
    }
    rest.iter_mut().for_each(|x| *x = one(*x));
}

/// The sine of an angle that is `ahead` quarter turns further, and whether FDLIBM takes this way for it.
#[inline(always)]
fn lane(x: f64, ahead: u64) -> (f64, bool) {
    let sum = x * TURNS + TO_INTEGER;
    let turns = sum - TO_INTEGER;
    let rest = x - turns * QUARTER;
    let correction = turns * QUARTER_REST;
    // What is left is the sum of two numbers.
    let y = rest - correction;
    let tail = (rest - y) - correction;
    let size = x.abs();
    let as_most =
        (size < LARGEST) & (size > NEAR_EIGHTH + 2e-6) & (y.abs() > size * CANCELS) & (y.abs() < NEAR_EIGHTH);
    (of_rest(y, tail, sum.to_bits().wrapping_add(ahead)), as_most)
}

/// The sine of an angle of so many quarter turns, of which the last two bits count, and a rest that is the sum of two
/// numbers.
#[inline(always)]
fn of_rest(y: f64, tail: f64, turn: u64) -> f64 {
    let z = y * y;
    let w = z * z;
    let cube = z * y;
    let [s0, s1, s2, s3, s4, s5] = SINE;
    let r = s1 + z * (s2 + z * s3) + z * w * (s4 + z * s5);
    let sine = y - ((z * (0.5 * tail - cube * r) - tail) - cube * s0);
    let [c0, c1, c2, c3, c4, c5] = COSINE;
    let r = z * (c0 + z * (c1 + z * c2)) + w * w * (c3 + z * (c4 + z * c5));
    let half = 0.5 * z;
    let high = 1.0 - half;
    let cosine = high + (((1.0 - high) - half) + (z * r - y * tail));

    // Odd quarter turns take the cosine, those beyond half a turn the other sign.
    let odd = 0u64.wrapping_sub(turn & 1);
    let picked = (sine.to_bits() & !odd) | (cosine.to_bits() & odd);
    f64::from_bits(picked ^ ((turn & 2) << 62))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(angles: &[f64]) {
        for (all, one) in [(sines as fn(&mut [f64]), sin as fn(f64) -> f64), (cosines, cos)] {
            let mut out = angles.to_vec();
            all(&mut out);
            for (x, y) in angles.iter().zip(&out) {
                assert_eq!(y.to_bits(), one(*x).to_bits(), "{x:?}");
            }
        }
    }

    #[test]
    fn columns_have_the_bits_of_single_values() {
        // A generator of 64 bits, Steele and others' SplitMix, for angles of all sizes up to 10⁷.
        let mut state = 7_u64;
        let mut random = || {
            state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
            let mut z = state;
            z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
            z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
            ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
        };
        for exponent in -8..=7 {
            let size = 10_f64.powi(exponent);
            check(&(0..40_000).map(|_| (2.0 * random() - 1.0) * size).collect::<Vec<_>>());
        }
        // Near all eighths of a turn, where another way begins.
        for eighth in -4000..4000 {
            let at = f64::from(eighth) * std::f64::consts::FRAC_PI_4;
            check(&(-8..8).map(|i| at * (1.0 + f64::from(i) * f64::EPSILON)).collect::<Vec<_>>());
            check(&(0..16).map(|_| at + (random() - 0.5) * 4e-6).collect::<Vec<_>>());
        }
    }

    #[test]
    fn large_angles_are_those_of_fdlibm() {
        // Multiples of the golden ratio lie evenly on the circle.
        let golden = 0.5 * (1.0 + 5_f64.sqrt());
        let mut other = 0;
        for i in 0..400_000_u32 {
            let x = (FAR + f64::from(i) * golden * 1000.0) * if i % 2 == 0 { 1.0 } else { -1.0 };
            for (ours, theirs) in [(sin(x), libm::sin(x)), (cos(x), libm::cos(x))] {
                assert!((ours - theirs).abs() <= f64::EPSILON * theirs.abs(), "{x}: {ours} is not {theirs}");
                other += u32::from(ours != theirs);
            }
        }
        // Where a sine lies half-way between two numbers they may differ: as rarely as once in ten thousand.
        assert!(other <= 80, "{other} differ");
        // Near quarter turns and at the ends of the range.
        for k in [1_048_577_u32, 1_500_000, 100_000_001, 683_565_275] {
            let at = f64::from(k) * std::f64::consts::FRAC_PI_2;
            for x in (-40..40).map(|i| at * (1.0 + f64::from(i) * f64::EPSILON)) {
                for (ours, theirs) in [(sin(x), libm::sin(x)), (cos(x), libm::cos(x))] {
                    assert!(
                        (ours - theirs).abs() <= f64::EPSILON * theirs.abs(),
                        "{x}: {ours} is not {theirs}"
                    );
                }
            }
        }
        // sin 10⁹ and cos 10⁹, as Wolfram and mpmath give them.
        assert!((sin(1e9) - 0.545_843_449_448_699_6).abs() < 2e-16);
        assert!((cos(1e9) - 0.837_887_181_363_902_3).abs() < 2e-16);
    }

    #[test]
    fn what_is_no_angle() {
        let mut out = [f64::NAN, f64::INFINITY, -0.0, 1e300, 0.0, 5e-324, -1e-300, 1.0];
        sines(&mut out);
        assert!(out[0].is_nan() && out[1].is_nan());
        assert_eq!(out[2].to_bits(), (-0.0_f64).to_bits());
        assert_eq!(out[3], sin(1e300));
        assert_eq!(out[5], 5e-324);
    }
}
