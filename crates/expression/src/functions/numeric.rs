//! Functions of real numbers, used one by one and on columns alike, so that both give the same bits.
//!
//! Outside its domain a function gives NaN or infinity, or `None` where that would hide the reason; the caller
//! makes an error of it.

use katydid_elementary::Elementary;

use super::Function;
use crate::circular;

/// Two numbers to one, or `None` outside the domain.
pub(crate) type OfTwo = fn(f64, f64) -> Option<f64>;

/// A list to one number, or `None` outside the domain; it may reorder the list.
pub(crate) type OfMany = fn(&mut [f64]) -> Option<f64>;

/// A function of one number that always gives a number.
pub(crate) fn of_one(function: Function) -> Option<fn(f64) -> f64> {
    Some(match function {
        Function::Sin => circular::sin,
        Function::Cos => circular::cos,
        Function::Tan => f64::tangent,
        Function::ASin => f64::arcsine,
        Function::ACos => f64::arccosine,
        Function::ATan => f64::arctangent,
        Function::Sec => |x| 1.0 / circular::cos(x),
        Function::Csc => |x| 1.0 / circular::sin(x),
        Function::Cot => |x| circular::cos(x) / circular::sin(x),
        Function::Sinc => |x| if x == 0.0 { 1.0 } else { circular::sin(x) / x },
        Function::Sinh => f64::hyperbolic_sine,
        Function::Cosh => f64::hyperbolic_cosine,
        Function::Tanh => f64::hyperbolic_tangent,
        Function::Sqrt => f64::sqrt,
        Function::Exp => f64::exponential,
        Function::Pow10 => |x| 10f64.raised_to(x),
        Function::Ln => f64::logarithm,
        Function::Log | Function::Log10 => f64::logarithm_10,
        Function::Floor | Function::Int => f64::floor,
        Function::Ceiling => f64::ceil,
        Function::Fix | Function::Trunc => f64::trunc,
        Function::Round => f64::round_ties_even,
        Function::Deg => f64::to_degrees,
        Function::Rad => f64::to_radians,
        Function::CDbl => |x| x,
        _ => return None,
    })
}

/// A function of one number over many, where it has a faster way with the same bits.
pub(crate) fn sweeping(function: Function) -> Option<fn(&mut [f64])> {
    match function {
        Function::Sin => Some(circular::sines),
        Function::Cos => Some(circular::cosines),
        _ => None,
    }
}

/// A function of two numbers.
pub(crate) fn of_two(function: Function) -> Option<OfTwo> {
    Some(match function {
        Function::ATan2 => |y, x| Some(y.arctangent_of(x)),
        Function::Pow => |x, n| Some(power(x, n)),
        Function::LogN => |x, base| Some(x.logarithm() / base.logarithm()),
        Function::Round => round_to,
        _ => return None,
    })
}

/// A function of any number of numbers, at least one.
pub(crate) fn of_many(function: Function) -> Option<OfMany> {
    Some(match function {
        Function::Min => |v| v.iter().copied().reduce(|a, b| if b < a { b } else { a }),
        Function::Max => |v| v.iter().copied().reduce(|a, b| if b > a { b } else { a }),
        Function::Sum => |v| v.iter().copied().reduce(|a, b| a + b),
        Function::Mean => |v| Some(v.iter().copied().reduce(|a, b| a + b)? / v.len() as f64),
        Function::GMean => |v| {
            let product = v.iter().copied().reduce(|a, b| a * b)?;
            Some(product.raised_to(1.0 / v.len() as f64))
        },
        Function::HMean => |v| {
            if v.contains(&0.0) {
                return None;
            }
            Some(v.len() as f64 / v.iter().map(|x| 1.0 / x).reduce(|a, b| a + b)?)
        },
        Function::Median => |v| {
            v.sort_unstable_by(f64::total_cmp);
            let middle = v.len() / 2;
            let upper = *v.get(middle)?;
            if v.len() % 2 == 1 {
                return Some(upper);
            }
            Some((v.get(middle.checked_sub(1)?)? + upper) / 2.0)
        },
        _ => return None,
    })
}

/// The power; a square is a product, which is exact to the last bit and many times faster.
#[inline]
pub(crate) fn power(x: f64, n: f64) -> f64 {
    if n == 2.0 { x * x } else { x.raised_to(n) }
}

/// Rounded to a number of decimals as .NET's `Math.Round(x, digits)` does it: scaled by the power of ten,
/// halves to even, scaled back; from 1e16 on a number has no decimals to round. `None` outside 0..15 digits.
pub(crate) fn round_to(x: f64, digits: f64) -> Option<f64> {
    let digits = digits.round_ties_even();
    if !(0.0..=15.0).contains(&digits) {
        return None;
    }
    if x.abs() >= 1e16 {
        return Some(x);
    }
    let scale = 10f64.powi(digits as i32);
    Some((x * scale).round_ties_even() / scale)
}

/// The 32-bit integer equal to a whole number.
pub(crate) fn integer(x: f64) -> Option<i32> {
    let whole = x.fract() == 0.0 && x >= f64::from(i32::MIN) && x <= f64::from(i32::MAX);
    whole.then_some(x as i32)
}

/// The nearest integer, halves to even; `None` when it has more than 32 bits or x is not a number.
pub(crate) fn nearest_integer(x: f64) -> Option<i32> {
    integer(x.round_ties_even())
}

/// -1, 0 or 1; `None` for NaN.
pub(crate) fn sign(x: f64) -> Option<i32> {
    x.partial_cmp(&0.0).map(|order| order as i32)
}

/// n! for whole n of 0 to 170 (171! is above the largest double).
pub(crate) fn factorial(n: f64) -> Option<f64> {
    if n.fract() != 0.0 || !(0.0..=170.0).contains(&n) {
        return None;
    }
    Some((2..=n as u32).fold(1.0, |product, k| product * f64::from(k)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounding_goes_to_the_even_neighbour() {
        assert_eq!(
            [0.5, 1.5, 2.5, -0.5, -1.5].map(|x| of_one(Function::Round).unwrap()(x)),
            [0.0, 2.0, 2.0, 0.0, -2.0]
        );
        assert_eq!(round_to(1.2345, 2.0), Some(1.23));
        assert_eq!(round_to(2.5, 0.0), Some(2.0));
        assert_eq!(round_to(0.125, 2.0), Some(0.12));
        assert_eq!(round_to(1.0, 16.0), None);
        assert_eq!(round_to(1.0, f64::NAN), None);
    }

    #[test]
    fn statistics() {
        let f = |function, mut v: Vec<f64>| of_many(function).unwrap()(&mut v);
        assert_eq!(f(Function::Median, vec![3.0, 1.0, 2.0]), Some(2.0));
        assert_eq!(f(Function::Median, vec![4.0, 1.0, 2.0, 3.0]), Some(2.5));
        assert_eq!(f(Function::GMean, vec![2.0, 8.0]), Some(4.0));
        assert_eq!(f(Function::HMean, vec![1.0, 3.0]), Some(1.5));
        assert_eq!(f(Function::HMean, vec![1.0, 0.0]), None);
        assert_eq!(f(Function::Mean, vec![1.0, 2.0, 6.0]), Some(3.0));
    }

    #[test]
    fn factorials() {
        assert_eq!(factorial(0.0), Some(1.0));
        assert_eq!(factorial(10.0), Some(3_628_800.0));
        assert!(factorial(170.0).unwrap().is_finite());
        assert_eq!(
            (factorial(171.0), factorial(-1.0), factorial(2.5), factorial(f64::NAN)),
            (None, None, None, None)
        );
    }
}
