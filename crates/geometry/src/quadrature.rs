//! Adaptive numerical integration.

/// Abscissae of the 15-point Kronrod rule in 0…1 half-width, largest first; every second one belongs to the 7-point
/// Gauss rule (R. Piessens et al., *QUADPACK*, 1983, routine QK15).
const NODES: [f64; 8] = [
    0.991_455_371_120_812_6,
    0.949_107_912_342_758_5,
    0.864_864_423_359_769_1,
    0.741_531_185_599_394_4,
    0.586_087_235_467_691_1,
    0.405_845_151_377_397_2,
    0.207_784_955_007_898_5,
    0.0,
];
const KRONROD: [f64; 8] = [
    0.022_935_322_010_529_22,
    0.063_092_092_629_978_55,
    0.104_790_010_322_250_18,
    0.140_653_259_715_525_92,
    0.169_004_726_639_267_9,
    0.190_350_578_064_785_4,
    0.204_432_940_075_298_9,
    0.209_482_141_084_727_83,
];
const GAUSS: [f64; 4] =
    [0.129_484_966_168_869_7, 0.279_705_391_489_276_64, 0.381_830_050_505_118_9, 0.417_959_183_673_469_4];

/// The 15-point value of the integral over a…b and its difference from the 7-point value.
fn kronrod<const N: usize>(f: &impl Fn(f64) -> [f64; N], a: f64, b: f64) -> ([f64; N], f64) {
    let (middle, half) = (0.5 * (a + b), 0.5 * (b - a));
    let (mut fine, mut coarse) = ([0.0; N], [0.0; N]);
    for (i, (&x, &weight)) in NODES.iter().zip(&KRONROD).enumerate() {
        let mut value = f(middle + half * x);
        if i < 7 {
            let other = f(middle - half * x);
            value = std::array::from_fn(|c| value[c] + other[c]);
        }
        for c in 0..N {
            fine[c] += weight * value[c];
            if i % 2 == 1 {
                coarse[c] += GAUSS[i / 2] * value[c];
            }
        }
    }
    let error = (0..N).map(|c| (fine[c] - coarse[c]).abs()).fold(0.0, f64::max) * half.abs();
    (fine.map(|x| x * half), error)
}

/// Integrates a vector-valued function over a…b by bisection until the two rules agree to `tolerance` (absolute, for
/// the whole range), or 48 halvings have been done.
pub(crate) fn integrate<const N: usize>(
    f: &impl Fn(f64) -> [f64; N],
    a: f64,
    b: f64,
    tolerance: f64,
) -> [f64; N] {
    let mut sum = [0.0; N];
    let mut stack = vec![(a, b, 0_u32)];
    // A cusp needs one branch of about 48 halvings; the bound stops input that is bad everywhere.
    let mut budget = 600;
    while let Some((a, b, depth)) = stack.pop() {
        let (value, error) = kronrod(f, a, b);
        budget -= 1;
        // The 15-point value is far better than the difference tells: QUADPACK's estimate (200 e)^1.5.
        let scale = value.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        let estimate = if scale > 0.0 { error.min(scale * (200.0 * error / scale).powf(1.5)) } else { error };
        let fine = estimate <= tolerance || !estimate.is_finite();
        if fine || depth >= 48 || budget <= 0 {
            for c in 0..N {
                sum[c] += value[c];
            }
        } else {
            let middle = 0.5 * (a + b);
            stack.push((middle, b, depth + 1));
            stack.push((a, middle, depth + 1));
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::integrate;

    #[test]
    fn smooth_and_not_so_smooth() {
        let [e] = integrate(&|x| [x.exp()], 0.0, 1.0, 1e-15);
        assert!((e - (1f64.exp() - 1.0)).abs() < 1e-15);
        let [root, one] = integrate(&|x| [x.sqrt(), 1.0], 0.0, 1.0, 1e-13);
        assert!((root - 2.0 / 3.0).abs() < 1e-13);
        assert!((one - 1.0).abs() < 1e-15);
        let [corner] = integrate(&|x| [(x - 0.3).abs()], 0.0, 1.0, 1e-14);
        assert!((corner - (0.045 + 0.245)).abs() < 1e-13);
    }
}
