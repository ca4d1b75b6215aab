//! Elementary functions with the same bits on every machine.
//!
//! What `f64::sin` and its like give is up to the system's library: two of them differ in the last bit of some results, and
//! what is decided by such a bit may differ by more. A definition that is solved in a page, on a server and on a desk must
//! give one result. So everything that computes uses [`Elementary`]: the functions of `libm`, a port of musl's, which are in
//! Rust and the same everywhere. Their error is below one unit in the last place, as is that of the systems'.
//!
//! `sqrt`, `mul_add`, `powi` and the four operations are exact to rounding or made of such, and stay those of the standard library.
//!
//! ```
//! use katydid_elementary::Elementary;
//!
//! let (sine, cosine) = 0.5_f64.sine_cosine();
//! assert!((sine.hypotenuse(cosine) - 1.0).abs() < 1e-15);
//! assert_eq!(8.0_f64.cube_root(), 2.0);
//! ```

mod whole;

/// Elementary functions of a number, by names that the standard library does not use.
pub trait Elementary: Copy {
    /// The sine of an angle in radians.
    #[must_use]
    fn sine(self) -> f64;

    /// The cosine of an angle in radians.
    #[must_use]
    fn cosine(self) -> f64;

    /// The tangent of an angle in radians.
    #[must_use]
    fn tangent(self) -> f64;

    /// The angle in radians, from −π/2 to π/2, whose sine this is; NaN outside of −1 to 1.
    #[must_use]
    fn arcsine(self) -> f64;

    /// The angle in radians, from 0 to π, whose cosine this is; NaN outside of −1 to 1.
    #[must_use]
    fn arccosine(self) -> f64;

    /// The angle in radians, from −π/2 to π/2, whose tangent this is.
    #[must_use]
    fn arctangent(self) -> f64;

    /// The hyperbolic sine.
    #[must_use]
    fn hyperbolic_sine(self) -> f64;

    /// The hyperbolic cosine.
    #[must_use]
    fn hyperbolic_cosine(self) -> f64;

    /// The hyperbolic tangent.
    #[must_use]
    fn hyperbolic_tangent(self) -> f64;

    /// The number whose hyperbolic sine this is.
    #[must_use]
    fn area_sine(self) -> f64;

    /// The number, 0 or more, whose hyperbolic cosine this is; NaN below 1.
    #[must_use]
    fn area_cosine(self) -> f64;

    /// The number whose hyperbolic tangent this is; NaN beyond −1 and 1.
    #[must_use]
    fn area_tangent(self) -> f64;

    /// e to the power of this.
    #[must_use]
    fn exponential(self) -> f64;

    /// 2 to the power of this.
    #[must_use]
    fn power_of_two(self) -> f64;

    /// e to the power of this, less 1: exact to rounding near 0.
    #[must_use]
    fn exponential_less_one(self) -> f64;

    /// The natural logarithm; NaN below 0.
    #[must_use]
    fn logarithm(self) -> f64;

    /// The natural logarithm of 1 more: exact to rounding near 0.
    #[must_use]
    fn logarithm_of_one_more(self) -> f64;

    /// The logarithm to base 2; NaN below 0.
    #[must_use]
    fn logarithm_2(self) -> f64;

    /// The logarithm to base 10; NaN below 0.
    #[must_use]
    fn logarithm_10(self) -> f64;

    /// The number whose cube this is.
    #[must_use]
    fn cube_root(self) -> f64;

    /// The angle in radians, from −π to π, of the point with this as y and `x`.
    #[must_use]
    fn arctangent_of(self, x: f64) -> f64;

    /// The length of the vector of these two.
    #[must_use]
    fn hypotenuse(self, other: f64) -> f64;

    /// This to a power; whole powers are rounded once.
    #[must_use]
    fn raised_to(self, power: f64) -> f64;

    /// Sine and cosine of an angle in radians.
    #[must_use]
    fn sine_cosine(self) -> (f64, f64);
}

impl Elementary for f64 {
    #[inline]
    fn sine(self) -> f64 {
        libm::sin(self)
    }

    #[inline]
    fn cosine(self) -> f64 {
        libm::cos(self)
    }

    #[inline]
    fn tangent(self) -> f64 {
        libm::tan(self)
    }

    #[inline]
    fn arcsine(self) -> f64 {
        libm::asin(self)
    }

    #[inline]
    fn arccosine(self) -> f64 {
        libm::acos(self)
    }

    #[inline]
    fn arctangent(self) -> f64 {
        libm::atan(self)
    }

    #[inline]
    fn hyperbolic_sine(self) -> f64 {
        libm::sinh(self)
    }

    #[inline]
    fn hyperbolic_cosine(self) -> f64 {
        libm::cosh(self)
    }

    #[inline]
    fn hyperbolic_tangent(self) -> f64 {
        libm::tanh(self)
    }

    #[inline]
    fn area_sine(self) -> f64 {
        libm::asinh(self)
    }

    #[inline]
    fn area_cosine(self) -> f64 {
        libm::acosh(self)
    }

    #[inline]
    fn area_tangent(self) -> f64 {
        libm::atanh(self)
    }

    #[inline]
    fn exponential(self) -> f64 {
        libm::exp(self)
    }

    #[inline]
    fn power_of_two(self) -> f64 {
        libm::exp2(self)
    }

    #[inline]
    fn exponential_less_one(self) -> f64 {
        libm::expm1(self)
    }

    #[inline]
    fn logarithm(self) -> f64 {
        libm::log(self)
    }

    #[inline]
    fn logarithm_of_one_more(self) -> f64 {
        libm::log1p(self)
    }

    #[inline]
    fn logarithm_2(self) -> f64 {
        libm::log2(self)
    }

    #[inline]
    fn logarithm_10(self) -> f64 {
        libm::log10(self)
    }

    #[inline]
    fn cube_root(self) -> f64 {
        libm::cbrt(self)
    }

    #[inline]
    fn arctangent_of(self, x: f64) -> f64 {
        libm::atan2(self, x)
    }

    #[inline]
    fn hypotenuse(self, other: f64) -> f64 {
        libm::hypot(self, other)
    }

    #[inline]
    fn raised_to(self, power: f64) -> f64 {
        whole::power(self, power).unwrap_or_else(|| libm::pow(self, power))
    }

    #[inline]
    fn sine_cosine(self) -> (f64, f64) {
        libm::sincos(self)
    }
}

#[cfg(test)]
mod tests {
    use super::Elementary;

    #[test]
    fn what_is_whole_is_exact() {
        for n in -20..=20 {
            assert_eq!(10_f64.powi(n).logarithm_10().round(), f64::from(n));
            assert_eq!(2_f64.powi(n).logarithm_2(), f64::from(n));
            assert_eq!(f64::from(n).power_of_two(), 2_f64.powi(n));
        }
        for n in 0..200 {
            let x = f64::from(n);
            assert_eq!((x * x * x).cube_root(), x);
            assert_eq!(x.raised_to(2.0), x * x);
            assert_eq!((3.0 * x).hypotenuse(4.0 * x), 5.0 * x);
        }
    }

    #[test]
    fn whole_powers_are_rounded_once() {
        for n in -240..=240 {
            let exact: f64 = format!("1e{n}").parse().unwrap_or(f64::NAN);
            assert_eq!(10_f64.raised_to(f64::from(n)), exact, "10^{n}");
            assert_eq!((-10_f64).raised_to(f64::from(n)), if n % 2 == 0 { exact } else { -exact });
        }
        for n in 0..=80_u32 {
            assert_eq!(3_f64.raised_to(f64::from(n)), 3_u128.pow(n) as f64, "3^{n}");
        }
        // At the ends of what doubles hold, and where nothing is whole.
        assert_eq!(10_f64.raised_to(400.0), f64::INFINITY);
        assert_eq!(10_f64.raised_to(-400.0), 0.0);
        assert_eq!(0_f64.raised_to(-1.0), f64::INFINITY);
        assert_eq!(0_f64.raised_to(0.0), 1.0);
        assert!(f64::NAN.raised_to(3.0).is_nan());
        assert_eq!(f64::NAN.raised_to(0.0), 1.0);
        assert_eq!(f64::INFINITY.raised_to(-3.0), 0.0);
        assert_eq!(2.25_f64.raised_to(0.5), 1.5);
    }

    #[test]
    fn inverses_lead_back() {
        for k in -50..=50 {
            let x = f64::from(k) * 0.03;
            let near = |a: f64, b: f64| assert!((a - b).abs() <= 4e-15 * (1.0 + b.abs()), "{a} {b}");
            near(x.sine().arcsine(), x.clamp(-1.5, 1.5));
            near(x.tangent().arctangent(), x);
            near(x.hyperbolic_sine().area_sine(), x);
            near(x.exponential().logarithm(), x);
            near(x.exponential_less_one().logarithm_of_one_more(), x);
            let (sine, cosine) = x.sine_cosine();
            near(sine.arctangent_of(cosine), x);
            assert_eq!((sine, cosine), (x.sine(), x.cosine()));
        }
    }
}
