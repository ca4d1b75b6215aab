//! `decimal`: 96 bits and a scale from 0 to 28, with .NET's arithmetic.
//!
//! Sums, products and quotients are those of the crate `rust_decimal`, whose algorithms are .NET's own. What it leaves
//! out is here: the scale of zeros, texts, rounding at any place, and conversions from and to binary numbers.

mod text;

pub(crate) use rust_decimal::Decimal;
pub(crate) use text::{Unread, read};

use crate::bound::Op;
use crate::sema::Prim;

/// The most digits behind the point.
const MOST_SCALE: u32 = 28;
/// The digits that 64 bits always hold.
const MOST_64: u32 = 19;
/// The first whole number that has no place in 96 bits.
const BEYOND: u128 = 1 << 96;

/// How many significant digits of a `double` a decimal takes.
pub(crate) const DOUBLE_DIGITS: i32 = 15;
/// How many of a `float`.
pub(crate) const FLOAT_DIGITS: i32 = 7;

/// Why an operation has no result.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Fault {
    Overflow,
    ByZero,
}

/// What an operation gives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Answer {
    Number(Decimal),
    Truth(bool),
}

/// A number from its whole digits, its scale and its sign.
fn of_parts(digits: u128, scale: u32, negative: bool) -> Decimal {
    Decimal::from_parts(
        digits as u32,
        (digits >> 32) as u32,
        (digits >> 64) as u32,
        negative,
        scale.min(MOST_SCALE),
    )
}

/// The whole digits, without the scale and the sign.
fn digits_of(x: Decimal) -> u128 {
    x.mantissa().unsigned_abs()
}

/// An operation of two numbers.
pub(crate) fn binary(op: Op, a: Decimal, b: Decimal) -> Result<Answer, Fault> {
    Ok(match op {
        Op::Add => Answer::Number(sum(a, b, false)?),
        Op::Sub => Answer::Number(sum(a, b, true)?),
        Op::Mul => Answer::Number(product(a, b)?),
        Op::Div => Answer::Number(quotient(a, b)?),
        Op::Rem => Answer::Number(rest(a, b)?),
        Op::Eq => Answer::Truth(a == b),
        Op::Ne => Answer::Truth(a != b),
        Op::Lt => Answer::Truth(a < b),
        Op::Le => Answer::Truth(a <= b),
        Op::Gt => Answer::Truth(a > b),
        Op::Ge => Answer::Truth(a >= b),
        // The compiler gives no other operation to decimals.
        Op::Shl | Op::Shr | Op::And | Op::Or | Op::Xor => return Err(Fault::Overflow),
    })
}

/// A sum or difference has the larger scale of the two as far as 96 bits go, also where one is zero.
fn sum(a: Decimal, b: Decimal, minus: bool) -> Result<Decimal, Fault> {
    let (zero_a, zero_b) = (a.is_zero(), b.is_zero());
    if zero_a || zero_b {
        let scale = a.scale().max(b.scale());
        let mut kept = if zero_b { a } else { b };
        if zero_a && !zero_b && minus {
            kept.set_sign_negative(!kept.is_sign_negative());
        }
        return Ok(widened(kept, scale));
    }
    let made = if minus { a.checked_sub(b) } else { a.checked_add(b) };
    made.ok_or(Fault::Overflow)
}

/// The same number with zeros behind it up to a scale, as many as have room.
fn widened(x: Decimal, scale: u32) -> Decimal {
    let (mut digits, mut own) = (digits_of(x), x.scale());
    while own < scale && digits * 10 < BEYOND {
        digits *= 10;
        own += 1;
    }
    of_parts(digits, own, x.is_sign_negative())
}

/// .NET keeps the scale of a zero only where both numbers have 32 bits.
fn product(a: Decimal, b: Decimal) -> Result<Decimal, Fault> {
    if a.is_zero() || b.is_zero() {
        let small = |x: Decimal| digits_of(x) <= u128::from(u32::MAX);
        let scale = a.scale() + b.scale();
        let kept = small(a) && small(b) && scale <= MOST_SCALE + MOST_64;
        let negative = a.is_sign_negative() != b.is_sign_negative();
        return Ok(of_parts(0, if kept { scale } else { 0 }, negative));
    }
    a.checked_mul(b).ok_or(Fault::Overflow)
}

fn quotient(a: Decimal, b: Decimal) -> Result<Decimal, Fault> {
    if b.is_zero() {
        return Err(Fault::ByZero);
    }
    if a.is_zero() {
        let scale = a.scale().saturating_sub(b.scale());
        return Ok(of_parts(0, scale, a.is_sign_negative() != b.is_sign_negative()));
    }
    let made = a.checked_div(b).ok_or(Fault::Overflow)?;
    // What does not come out even has as many digits as it needs, without zeros behind them.
    let even = a.scale().saturating_sub(b.scale());
    Ok(if made.scale() > even { made.normalize() } else { made })
}

fn rest(a: Decimal, b: Decimal) -> Result<Decimal, Fault> {
    if b.is_zero() {
        return Err(Fault::ByZero);
    }
    if a.is_zero() {
        return Ok(a);
    }
    if a.abs() == b.abs() {
        return Ok(of_parts(0, a.scale().max(b.scale()), a.is_sign_negative()));
    }
    a.checked_rem(b).ok_or(Fault::Overflow)
}

/// The number with the other sign.
pub(crate) fn negated(x: Decimal) -> Decimal {
    of_parts(digits_of(x), x.scale(), !x.is_sign_negative())
}

/// How a number is rounded.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Rounding {
    /// Halves to the even digit.
    Even,
    /// Halves away from zero.
    Away,
    /// Toward zero.
    Truncate,
    /// Down.
    Floor,
    /// Up.
    Ceiling,
}

/// The number with at most so many digits behind the point.
pub(crate) fn rounded(x: Decimal, places: u32, how: Rounding) -> Decimal {
    if x.scale() <= places {
        return x;
    }
    let by = 10_u128.pow(x.scale() - places);
    let (whole, left) = (digits_of(x) / by, digits_of(x) % by);
    let negative = x.is_sign_negative();
    let up = match how {
        Rounding::Even => left > by / 2 || left == by / 2 && whole % 2 == 1,
        Rounding::Away => left >= by / 2,
        Rounding::Truncate => false,
        Rounding::Floor => negative && left > 0,
        Rounding::Ceiling => !negative && left > 0,
    };
    of_parts(whole + u128::from(up), places, negative)
}

/// The number nearest to a binary one that has so many significant digits at most, as .NET has it (15 for `double`, 7 for
/// `float`): the digits are found by one multiplication in binary.
pub(crate) fn of_real(x: f64, digits: i32) -> Result<Decimal, Fault> {
    let size = x.abs();
    let exponent = ((x.to_bits() >> 52) & 0x7ff) as i32 - 1022;
    if size == 0.0 || exponent < -94 {
        return Ok(Decimal::ZERO);
    }
    if exponent > 96 {
        return Err(Fault::Overflow);
    }
    let (most, ten) = (MOST_SCALE as i32, |n: i32| 10_f64.powi(n));
    let (top, below) = (ten(digits), ten(digits - 1));
    let mut power = digits - 1 - ((exponent * 19_728) >> 16);
    let mut scaled = size;
    if power >= 0 {
        power = power.min(most);
        scaled *= exact_ten(power);
    } else if power != -1 || scaled >= top {
        scaled /= exact_ten(-power);
    } else {
        power = 0;
    }
    if scaled < below && power < most {
        scaled *= 10.0;
        power += 1;
    }
    let mut whole = scaled as u64;
    let left = scaled - whole as f64;
    if left > 0.5 || left == 0.5 && whole % 2 == 1 {
        whole += 1;
    }
    if whole == 0 {
        return Ok(Decimal::ZERO);
    }
    let mut made = u128::from(whole);
    if power < 0 {
        made *= 10_u128.pow(power.unsigned_abs());
        power = 0;
        if made >= BEYOND {
            return Err(Fault::Overflow);
        }
    }
    for _ in 0..power.min(digits - 1) {
        if made % 10 != 0 {
            break;
        }
        made /= 10;
        power -= 1;
    }
    Ok(of_parts(made, power as u32, x < 0.0))
}

/// A power of ten as the nearest double: `powi` would round at each step.
fn exact_ten(n: i32) -> f64 {
    const TENS: [f64; 29] = [
        1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17,
        1e18, 1e19, 1e20, 1e21, 1e22, 1e23, 1e24, 1e25, 1e26, 1e27, 1e28,
    ];
    usize::try_from(n).ok().and_then(|n| TENS.get(n)).copied().unwrap_or(1.0)
}

/// The binary number, by one division as .NET has it.
pub(crate) fn to_real(x: Decimal) -> f64 {
    /// 2^64
    const HIGH: f64 = 18_446_744_073_709_551_616.0;
    let digits = digits_of(x);
    let (low, high) = (digits as u64, (digits >> 64) as u32);
    let size = (low as f64 + f64::from(high) * HIGH) / exact_ten(x.scale() as i32);
    if x.is_sign_negative() { -size } else { size }
}

/// A whole number of any predefined type.
pub(crate) fn of_whole(n: i128) -> Decimal {
    of_parts(n.unsigned_abs(), 0, n < 0)
}

/// The whole part, where it fits a type.
pub(crate) fn to_whole(x: Decimal, prim: Prim) -> Option<i128> {
    let n = rounded(x, 0, Rounding::Truncate).mantissa();
    let (least, most) = prim.range();
    (least..=most).contains(&n).then_some(n)
}

/// Equal numbers have equal hashes, whatever their scale.
pub(crate) fn hash(x: Decimal) -> i32 {
    words(x.normalize()).into_iter().fold(0, |hash, word| hash ^ word)
}

/// All bits in two numbers: the lower digits; the upper digits, the scale and the sign.
pub(crate) fn halves(x: Decimal) -> [u64; 2] {
    let [low, mid, high, flags] = words(x).map(|word| u64::from(word as u32));
    [low | mid << 32, high | flags << 32]
}

/// The number of its two halves.
pub(crate) fn of_halves(low: u64, high: u64) -> Decimal {
    let digits = u128::from(low) | u128::from(high as u32) << 64;
    of_parts(digits, (high >> 48) as u32 & 0xff, high >> 63 == 1)
}

/// The four words of `decimal.GetBits`: the digits, and the scale with the sign.
pub(crate) fn words(x: Decimal) -> [i32; 4] {
    let digits = digits_of(x);
    let flags = x.scale() << 16 | u32::from(x.is_sign_negative()) << 31;
    [digits as i32, (digits >> 32) as i32, (digits >> 64) as i32, flags as i32]
}

/// A number from its three words, sign and scale; none where the scale is too large.
pub(crate) fn of_words(low: i32, mid: i32, high: i32, negative: bool, scale: u32) -> Option<Decimal> {
    let digits = u128::from(low as u32) | u128::from(mid as u32) << 32 | u128::from(high as u32) << 64;
    (scale <= MOST_SCALE).then(|| of_parts(digits, scale, negative))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn d(text: &str) -> Decimal {
        read(text, true).unwrap_or(Decimal::MAX)
    }

    /// The laws of the scale (ECMA-334, the type `decimal`): the larger one of a sum, both of a product.
    #[test]
    fn scales_are_kept() {
        for (op, a, b, expected) in [
            (Op::Add, "1.20", "0.3", "1.50"),
            (Op::Add, "0.00", "1", "1.00"),
            (Op::Sub, "0", "1.50", "-1.50"),
            (Op::Mul, "1.20", "2.0", "2.400"),
            (Op::Mul, "0.00", "2.0", "0.000"),
            (Op::Div, "1", "3", "0.3333333333333333333333333333"),
            (Op::Div, "2", "3", "0.6666666666666666666666666667"),
            (Op::Div, "11.0", "4", "2.75"),
            (Op::Div, "10.00", "4", "2.50"),
            (Op::Rem, "-5.5", "2", "-1.5"),
        ] {
            let Ok(Answer::Number(made)) = binary(op, d(a), d(b)) else { panic!("{a} {op:?} {b}") };
            assert_eq!(made.to_string(), expected, "{a} {op:?} {b}");
        }
        assert_eq!(binary(Op::Div, d("1"), d("0.0")), Err(Fault::ByZero));
        assert_eq!(binary(Op::Add, Decimal::MAX, d("1")), Err(Fault::Overflow));
    }

    #[test]
    fn texts_are_read_and_rounded() {
        assert_eq!(d(" 1,234.50 ").to_string(), "1234.50");
        assert_eq!(d("1.5e3").to_string(), "1500");
        assert_eq!(d("5-").to_string(), "-5");
        assert_eq!(d("79228162514264337593543950335"), Decimal::MAX);
        assert_eq!(read("79228162514264337593543950336", false), Err(Unread::TooLarge));
        // The last place behind the point: a half goes to the even digit.
        assert_eq!(d("0.00000000000000000000000000005").to_string(), "0.0000000000000000000000000000");
        assert_eq!(d("0.00000000000000000000000000015").to_string(), "0.0000000000000000000000000002");
        for bad in ["", ".", "1e3", "1..2", "--1", "a", ",1"] {
            assert_eq!(read(bad, false), Err(Unread::Form), "{bad}");
        }
    }

    #[test]
    fn binary_numbers_have_fifteen_digits() {
        assert_eq!(of_real(0.1, 15).map(|x| x.to_string()), Ok("0.1".to_owned()));
        assert_eq!(of_real(1.0 / 3.0, 15).map(|x| x.to_string()), Ok("0.333333333333333".to_owned()));
        assert_eq!(of_real(f64::from(1.0_f32 / 3.0), 7).map(|x| x.to_string()), Ok("0.3333333".to_owned()));
        assert_eq!(of_real(1e28, 15), Ok(d("10000000000000000000000000000")));
        assert_eq!(of_real(1e29, 15), Err(Fault::Overflow));
        assert_eq!(of_real(f64::NAN, 15), Err(Fault::Overflow));
        assert_eq!(to_real(d("-2.50")), -2.5);
    }

    #[test]
    fn halves_are_rounded_as_is_said() {
        for (text, even, away, floor) in [
            ("2.5", "2", "3", "2"),
            ("-2.5", "-2", "-3", "-3"),
            ("3.5", "4", "4", "3"),
            ("-0.1", "0", "0", "-1"),
        ] {
            assert_eq!(rounded(d(text), 0, Rounding::Even), d(even));
            assert_eq!(rounded(d(text), 0, Rounding::Away), d(away));
            assert_eq!(rounded(d(text), 0, Rounding::Floor), d(floor));
        }
        assert_eq!(hash(d("1.0")), hash(d("1.000")));
        assert_eq!(to_whole(d("-1.9"), Prim::I32), Some(-1));
        assert_eq!(to_whole(d("256"), Prim::U8), None);
    }
}
