//! Complex arithmetic on (re, im) pairs.

use katydid_elementary::Elementary;

pub(crate) type Complex = (f64, f64);

pub(crate) fn multiply(a: Complex, b: Complex) -> Complex {
    (a.0 * b.0 - a.1 * b.1, a.0 * b.1 + a.1 * b.0)
}

/// Smith's division (CACM 5, 1962): scaled so that large parts do not overflow. `None` by zero.
pub(crate) fn divide(a: Complex, b: Complex) -> Option<Complex> {
    if b == (0.0, 0.0) {
        return None;
    }
    Some(if b.0.abs() >= b.1.abs() {
        let r = b.1 / b.0;
        let d = b.0 + b.1 * r;
        ((a.0 + a.1 * r) / d, (a.1 - a.0 * r) / d)
    } else {
        let r = b.0 / b.1;
        let d = b.0 * r + b.1;
        ((a.0 * r + a.1) / d, (a.1 * r - a.0) / d)
    })
}

pub(crate) fn modulus(a: Complex) -> f64 {
    a.0.hypotenuse(a.1)
}

pub(crate) fn exp(a: Complex) -> Complex {
    let r = a.0.exponential();
    (r * a.1.cosine(), r * a.1.sine())
}

/// The principal logarithm, argument in -π..π.
pub(crate) fn ln(a: Complex) -> Complex {
    (modulus(a).logarithm(), a.1.arctangent_of(a.0))
}

/// The principal power exp(b ln a); zero to any power but zero is zero.
pub(crate) fn power(a: Complex, b: Complex) -> Complex {
    if b == (0.0, 0.0) {
        return (1.0, 0.0);
    }
    if a == (0.0, 0.0) {
        return (0.0, 0.0);
    }
    exp(multiply(b, ln(a)))
}

/// The root with a real part not below zero.
pub(crate) fn sqrt(a: Complex) -> Complex {
    let m = modulus(a);
    if m == 0.0 {
        return (0.0, 0.0);
    }
    // The sum without cancellation first, the other part from the product re·im = a.1/2.
    let big = ((m + a.0.abs()) / 2.0).sqrt();
    let small = a.1.abs() / (2.0 * big);
    let (re, im) = if a.0 >= 0.0 { (big, small) } else { (small, big) };
    (re, if a.1.is_sign_negative() { -im } else { im })
}

pub(crate) fn sin(a: Complex) -> Complex {
    (a.0.sine() * a.1.hyperbolic_cosine(), a.0.cosine() * a.1.hyperbolic_sine())
}

pub(crate) fn cos(a: Complex) -> Complex {
    (a.0.cosine() * a.1.hyperbolic_cosine(), -a.0.sine() * a.1.hyperbolic_sine())
}
