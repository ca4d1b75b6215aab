//! Adaptive numerical integration.

use katydid_elementary::Elementary;

/// Half of the abscissae and weights of the Gauss–Legendre rules of 6 and 10 points on −1…1, by the distance from the
/// middle (M. Abramowitz, I. Stegun, *Handbook of Mathematical Functions*, 1964, table 25.4).
pub(crate) const GAUSS_6: [[f64; 2]; 3] = [
    [0.238_619_186_083_196_92, 0.467_913_934_572_691_04],
    [0.661_209_386_466_264_5, 0.360_761_573_048_138_6],
    [0.932_469_514_203_152, 0.171_324_492_379_170_34],
];
pub(crate) const GAUSS_10: [[f64; 2]; 5] = [
    [0.148_874_338_981_631_22, 0.295_524_224_714_752_87],
    [0.433_395_394_129_247_2, 0.269_266_719_309_996_35],
    [0.679_409_568_299_024_4, 0.219_086_362_515_982_04],
    [0.865_063_366_688_984_5, 0.149_451_349_150_580_6],
    [0.973_906_528_517_171_7, 0.066_671_344_308_688_14],
];

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

/// Abscissae of the 31-point Kronrod rule in 0…1 half-width, largest first; every second one belongs to the 15-point
/// Gauss rule. Computed from the zeros of the Legendre and Stieltjes polynomials in 60-digit arithmetic.
const NODES_31: [f64; 16] = [
    0.998_002_298_693_397_1,
    0.987_992_518_020_485_4,
    0.967_739_075_679_139_1,
    0.937_273_392_400_706,
    0.897_264_532_344_081_9,
    0.848_206_583_410_427_2,
    0.790_418_501_442_466,
    0.724_417_731_360_170_1,
    0.650_996_741_297_417,
    0.570_972_172_608_538_8,
    0.485_081_863_640_239_7,
    0.394_151_347_077_563_4,
    0.299_180_007_153_168_84,
    0.201_194_093_997_434_51,
    0.101_142_066_918_717_5,
    0.0,
];
const KRONROD_31: [f64; 16] = [
    0.005_377_479_872_923_349,
    0.015_007_947_329_316_122,
    0.025_460_847_326_715_32,
    0.035_346_360_791_375_85,
    0.044_589_751_324_764_88,
    0.053_481_524_690_928_09,
    0.062_009_567_800_670_64,
    0.069_854_121_318_728_26,
    0.076_849_680_757_720_38,
    0.083_080_502_823_133_02,
    0.088_564_443_056_211_76,
    0.093_126_598_170_825_32,
    0.096_642_726_983_623_68,
    0.099_173_598_721_791_96,
    0.100_769_845_523_875_59,
    0.101_330_007_014_791_54,
];
const GAUSS_15: [f64; 8] = [
    0.030_753_241_996_117_27,
    0.070_366_047_488_108_12,
    0.107_159_220_467_171_94,
    0.139_570_677_926_154_32,
    0.166_269_205_816_993_92,
    0.186_161_000_015_562_2,
    0.198_431_485_327_111_58,
    0.202_578_241_925_561_3,
];

/// The 31-point value of the integral over a…b and its difference from the 15-point value.
#[inline(always)]
pub(crate) fn gauss_kronrod_31(f: impl Fn(f64) -> f64, a: f64, b: f64) -> (f64, f64) {
    let (middle, half) = (0.5 * (a + b), 0.5 * (b - a));
    let centre = f(middle);
    let (mut fine, mut coarse) = (KRONROD_31[15] * centre, GAUSS_15[7] * centre);
    for i in 0..15 {
        let step = half * NODES_31[i];
        let value = f(middle + step) + f(middle - step);
        fine += KRONROD_31[i] * value;
        if i % 2 == 1 {
            coarse += GAUSS_15[i / 2] * value;
        }
    }
    (fine * half, (fine - coarse).abs() * half.abs())
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
        let estimate =
            if scale > 0.0 { error.min(scale * (200.0 * error / scale).raised_to(1.5)) } else { error };
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
