//! Parameters of one span side by side: as many as an instruction of the machine takes, found out when the program runs.
//!
//! Every lane does the same operations in the same order as a parameter alone, and no multiplication is fused with an
//! addition, so that a point has the same bits on every machine.

use pulp::{Arch, Simd, WithSimd};

use super::batch::Span;
use super::curve::project;
use crate::Point3;

/// Parameters side by side where the compiler finds the instructions: two for each of the oldest processors.
const PORTABLE: usize = 4;
/// The most parameters that an instruction takes: 512 bits.
const MOST: usize = 8;

/// How N coordinates become a point.
pub(super) trait Place<const N: usize> {
    /// The point of one parameter.
    fn point(p: [f64; N]) -> Point3;
    /// x, y and z of several, lane by lane.
    fn lanes<S: Simd>(simd: S, p: [S::f64s; N]) -> [S::f64s; 3];
    /// x, y and z of several as arrays.
    fn arrays(p: [[f64; PORTABLE]; N]) -> [[f64; PORTABLE]; 3];
}

/// x, y and z as they are.
pub(super) struct Coordinates;

impl Place<3> for Coordinates {
    #[inline(always)]
    fn point(p: [f64; 3]) -> Point3 {
        p.into()
    }

    #[inline(always)]
    fn lanes<S: Simd>(_: S, p: [S::f64s; 3]) -> [S::f64s; 3] {
        p
    }

    #[inline(always)]
    fn arrays(p: [[f64; PORTABLE]; 3]) -> [[f64; PORTABLE]; 3] {
        p
    }
}

/// x, y and z times a weight, and the weight.
pub(super) struct Homogeneous;

impl Place<4> for Homogeneous {
    #[inline(always)]
    fn point(p: [f64; 4]) -> Point3 {
        project(p)
    }

    #[inline(always)]
    fn lanes<S: Simd>(simd: S, [x, y, z, w]: [S::f64s; 4]) -> [S::f64s; 3] {
        [simd.div_f64s(x, w), simd.div_f64s(y, w), simd.div_f64s(z, w)]
    }

    #[inline(always)]
    fn arrays([x, y, z, w]: [[f64; PORTABLE]; 4]) -> [[f64; PORTABLE]; 3] {
        [x, y, z].map(|c| std::array::from_fn(|k| c[k] / w[k]))
    }
}

/// The points at many parameters of a span of degree P.
pub(super) fn side_by_side<const N: usize, F: Place<N>, const P: usize>(
    span: &Span<N>,
    parameters: &[f64],
    out: &mut [Point3],
) {
    Arch::new().dispatch(Run::<N, F, P> { span, parameters, out, place: std::marker::PhantomData });
}

/// Parameters of one span and the places of their points.
struct Run<'a, const N: usize, F, const P: usize> {
    span: &'a Span<N>,
    parameters: &'a [f64],
    out: &'a mut [Point3],
    place: std::marker::PhantomData<F>,
}

impl<const N: usize, F: Place<N>, const P: usize> WithSimd for Run<'_, N, F, P> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let Self { span, parameters, out, .. } = self;
        let lanes = S::F64_LANES;
        if !(2..=MOST).contains(&lanes) {
            return span.portable::<F, P>(parameters, out);
        }
        let (wide, others) = S::as_simd_f64s(parameters);
        let Some((places, last)) = out.split_at_mut_checked(wide.len() * lanes) else { return };
        let points = span.points.map(|p| p.map(|x| simd.splat_f64s(x)));
        let [low, scale, one] = [span.low, 1.0 / span.width, 1.0].map(|x| simd.splat_f64s(x));
        for (slots, &t) in places.chunks_exact_mut(lanes).zip(wide) {
            let s = simd.mul_f64s(simd.sub_f64s(t, low), scale);
            let r = simd.sub_f64s(one, s);
            let (mut v, mut power) = (points[0], one);
            for i in 1..=P {
                power = simd.mul_f64s(power, s);
                v = std::array::from_fn(|c| {
                    simd.add_f64s(simd.mul_f64s(v[c], r), simd.mul_f64s(points[i][c], power))
                });
            }
            let mut columns = [[0.0; MOST]; 3];
            for (column, values) in columns.iter_mut().zip(F::lanes(simd, v)) {
                if let Some(slot) = S::as_mut_simd_f64s(column).0.first_mut() {
                    *slot = values;
                }
            }
            let [x, y, z] = &columns;
            for (((slot, &x), &y), &z) in slots.iter_mut().zip(x).zip(y).zip(z) {
                *slot = Point3::new(x, y, z);
            }
        }
        span.one_by_one::<F, P>(others, last);
    }
}

impl<const N: usize> Span<N> {
    /// The points at many parameters without special instructions.
    #[inline(always)]
    fn portable<F: Place<N>, const P: usize>(&self, parameters: &[f64], out: &mut [Point3]) {
        let scale = 1.0 / self.width;
        let (lanes, others) = parameters.as_chunks::<PORTABLE>();
        let (places, last) = out.as_chunks_mut::<PORTABLE>();
        for (slots, t) in places.iter_mut().zip(lanes) {
            let [x, y, z] = F::arrays(self.at_lanes::<P>(&t.map(|t| (t - self.low) * scale)));
            *slots = std::array::from_fn(|k| Point3::new(x[k], y[k], z[k]));
        }
        self.one_by_one::<F, P>(others, last);
    }

    #[inline(always)]
    fn one_by_one<F: Place<N>, const P: usize>(&self, parameters: &[f64], out: &mut [Point3]) {
        let scale = 1.0 / self.width;
        for (slot, &t) in out.iter_mut().zip(parameters) {
            *slot = F::point(self.at::<P>((t - self.low) * scale));
        }
    }

    /// [`Span::at`] for several places, coordinate by coordinate: the same operations in the same order.
    #[inline(always)]
    fn at_lanes<const P: usize>(&self, s: &[f64; PORTABLE]) -> [[f64; PORTABLE]; N] {
        let r = s.map(|s| 1.0 - s);
        let mut v = self.points[0].map(|x| [x; PORTABLE]);
        let mut power = [1.0; PORTABLE];
        for i in 1..=P {
            power = std::array::from_fn(|k| power[k] * s[k]);
            v = std::array::from_fn(|c| {
                std::array::from_fn(|k| v[c][k] * r[k] + self.points[i][c] * power[k])
            });
        }
        v
    }
}

#[cfg(test)]
mod tests {
    use super::super::batch::Span;
    use super::{Homogeneous, side_by_side};
    use crate::{NurbsCurve, Point3};

    /// More than an instruction takes of them anywhere.
    const SHIFTS: usize = 9;

    /// A curve of one span: whatever the number of parameters, they are one run.
    fn arch(degree: usize, rational: bool) -> NurbsCurve {
        let corner = |i: usize| [i as f64, (i as f64 * 1.7).sin(), 0.3 * i as f64];
        let knots = [vec![0.0; degree], vec![1.0; degree]].concat();
        let made = if rational {
            let weighted = |i: usize| {
                let (w, [x, y, z]) = (1.0 + 0.25 * i as f64, corner(i));
                [x * w, y * w, z * w, w]
            };
            NurbsCurve::rational(degree, (0..=degree).map(weighted).collect(), knots)
        } else {
            NurbsCurve::new(degree, (0..=degree).map(|i| Point3::from(corner(i))).collect(), knots)
        };
        made.unwrap()
    }

    #[test]
    fn a_point_has_the_same_bits_whoever_stands_beside_it() {
        let all: Vec<f64> = (0..40).map(|i| f64::from(i) / 41.0).collect();
        for degree in 1..=5 {
            for rational in [false, true] {
                let curve = arch(degree, rational);
                // From 8 parameters on a run has a Bézier form; each shift puts a parameter into another lane.
                let whole = curve.points_at(&all);
                for shift in 0..SHIFTS {
                    assert_eq!(curve.points_at(&all[shift..]), whole[shift..], "{degree} {rational} {shift}");
                }
                // Fewer than four at the end go one by one, through the same operations.
                for count in 8..20 {
                    assert_eq!(curve.points_at(&all[..count]), whole[..count], "{degree} {rational} {count}");
                }
                for (p, &t) in whole.iter().zip(&all) {
                    assert!(p.distance_to(curve.point_at(t)) < 1e-14, "{degree} {rational} {t}");
                }
            }
        }
    }

    /// Whatever instructions the machine has, a point has the bits of the portable loop.
    #[test]
    fn wide_instructions_give_the_same_bits() {
        let span = Span {
            points: std::array::from_fn(|i| [1.1 * i as f64, (i as f64).sin(), 0.3, 1.0 + 0.2 * i as f64]),
            low: 0.25,
            width: 1.5,
        };
        let parameters: Vec<f64> =
            (0..103).map(|i| 0.25 + 1.5 * (f64::from(i) * 0.017).sin().abs()).collect();
        let mut wide = vec![Point3::ORIGIN; parameters.len()];
        let mut portable = wide.clone();
        side_by_side::<4, Homogeneous, 3>(&span, &parameters, &mut wide);
        span.portable::<Homogeneous, 3>(&parameters, &mut portable);
        assert_eq!(wide, portable);
    }
}
