//! Functions of a complex number, principal values throughout.

use katydid_data::Complex;
use katydid_elementary::Elementary;

pub(super) const I: Complex = Complex { re: 0.0, im: 1.0 };

pub(super) const fn real(re: f64) -> Complex {
    Complex { re, im: 0.0 }
}

pub(super) fn add(a: Complex, b: Complex) -> Complex {
    Complex { re: a.re + b.re, im: a.im + b.im }
}

pub(super) fn subtract(a: Complex, b: Complex) -> Complex {
    Complex { re: a.re - b.re, im: a.im - b.im }
}

pub(super) fn multiply(a: Complex, b: Complex) -> Complex {
    Complex { re: a.re * b.re - a.im * b.im, im: a.re * b.im + a.im * b.re }
}

pub(super) fn scale(a: Complex, s: f64) -> Complex {
    Complex { re: a.re * s, im: a.im * s }
}

/// a ÷ b by Smith's method (CACM 5, 1962), which does not overflow before its result does; NaN by zero.
pub(super) fn divide(a: Complex, b: Complex) -> Complex {
    if b.re.abs() >= b.im.abs() {
        let r = b.im / b.re;
        let d = b.re + b.im * r;
        Complex { re: (a.re + a.im * r) / d, im: (a.im - a.re * r) / d }
    } else {
        let r = b.re / b.im;
        let d = b.re * r + b.im;
        Complex { re: (a.re * r + a.im) / d, im: (a.im * r - a.re) / d }
    }
}

pub(super) fn modulus(a: Complex) -> f64 {
    a.re.hypotenuse(a.im)
}

/// The angle from the positive real axis, -π to π.
pub(super) fn argument(a: Complex) -> f64 {
    a.im.arctangent_of(a.re)
}

pub(super) fn exp(a: Complex) -> Complex {
    let size = a.re.exponential();
    // exp(x) is real, also where the sine of 0 meets infinity.
    if a.im == 0.0 { real(size) } else { Complex { re: size * a.im.cosine(), im: size * a.im.sine() } }
}

pub(super) fn ln(a: Complex) -> Complex {
    Complex { re: modulus(a).logarithm(), im: argument(a) }
}

/// The root with a real part that is not negative.
pub(super) fn sqrt(a: Complex) -> Complex {
    let size = modulus(a);
    if size == 0.0 {
        return a;
    }
    // The part that adds up without cancellation first; the other from re · im = a.im ÷ 2.
    let large = (0.5 * (size + a.re.abs())).sqrt();
    let small = a.im.abs() / (2.0 * large);
    let (re, im) = if a.re >= 0.0 { (large, small) } else { (small, large) };
    Complex { re, im: if a.im.is_sign_negative() { -im } else { im } }
}

/// The principal power, by repeated products for small whole exponents so that i² is -1 exactly.
pub(super) fn power(a: Complex, b: Complex) -> Complex {
    if b.im == 0.0 && b.re.fract() == 0.0 && b.re.abs() <= 64.0 {
        let product = (0..b.re.abs() as u32).fold(real(1.0), |product, _| multiply(product, a));
        return if b.re < 0.0 { divide(real(1.0), product) } else { product };
    }
    if a == real(0.0) {
        return real(0.0);
    }
    exp(multiply(b, ln(a)))
}

pub(super) fn sin(a: Complex) -> Complex {
    Complex { re: a.re.sine() * a.im.hyperbolic_cosine(), im: a.re.cosine() * a.im.hyperbolic_sine() }
}

pub(super) fn cos(a: Complex) -> Complex {
    Complex { re: a.re.cosine() * a.im.hyperbolic_cosine(), im: -a.re.sine() * a.im.hyperbolic_sine() }
}

pub(super) fn tan(a: Complex) -> Complex {
    divide(sin(a), cos(a))
}

/// asin z = -i ln(iz + √(1 - z²)).
pub(super) fn asin(a: Complex) -> Complex {
    let root = sqrt(subtract(real(1.0), multiply(a, a)));
    let log = ln(add(multiply(I, a), root));
    Complex { re: log.im, im: -log.re }
}

/// acos z = π/2 - asin z.
pub(super) fn acos(a: Complex) -> Complex {
    subtract(real(std::f64::consts::FRAC_PI_2), asin(a))
}

/// atan z = i/2 (ln(1 - iz) - ln(1 + iz)).
pub(super) fn atan(a: Complex) -> Complex {
    let iz = multiply(I, a);
    let difference = subtract(ln(subtract(real(1.0), iz)), ln(add(real(1.0), iz)));
    scale(multiply(I, difference), 0.5)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn functions_undo_their_inverses() {
        let z = Complex { re: 0.4, im: -0.7 };
        let near = |a: Complex, b: Complex| modulus(subtract(a, b)) < 1e-14;
        assert!(near(exp(ln(z)), z));
        assert!(near(multiply(sqrt(z), sqrt(z)), z));
        assert!(near(sin(asin(z)), z));
        assert!(near(cos(acos(z)), z));
        assert!(near(tan(atan(z)), z));
        assert!(near(multiply(divide(z, I), I), z));
        assert!(near(power(power(z, real(0.5)), real(2.0)), z));
        assert_eq!(sqrt(real(-4.0)), Complex { re: 0.0, im: 2.0 });
        assert_eq!(power(I, real(2.0)), real(-1.0));
    }
}
