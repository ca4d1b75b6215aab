//! `System.Math`.

use katydid_elementary::Elementary;

use super::{Cx, Native};
use crate::vm::Raise;
use crate::vm::value::Value;

pub(super) fn find(key: &str) -> Option<Native> {
    macro_rules! real {
        ($f:expr) => {
            |cx: &mut Cx<'_>| -> Result<Value, Raise> { Ok(Value::F64($f(cx.real(0)))) }
        };
    }
    Some(match key {
        "Math.Sin(Double)" => real!(f64::sine),
        "Math.Cos(Double)" => real!(f64::cosine),
        "Math.Tan(Double)" => real!(f64::tangent),
        "Math.Asin(Double)" => real!(f64::arcsine),
        "Math.Acos(Double)" => real!(f64::arccosine),
        "Math.Atan(Double)" => real!(f64::arctangent),
        "Math.Sinh(Double)" => real!(f64::hyperbolic_sine),
        "Math.Cosh(Double)" => real!(f64::hyperbolic_cosine),
        "Math.Tanh(Double)" => real!(f64::hyperbolic_tangent),
        "Math.Exp(Double)" => real!(f64::exponential),
        "Math.Sqrt(Double)" => real!(f64::sqrt),
        "Math.Cbrt(Double)" => real!(f64::cube_root),
        "Math.Log(Double)" => real!(f64::logarithm),
        "Math.Log10(Double)" => real!(f64::logarithm_10),
        "Math.Floor(Double)" => real!(f64::floor),
        "Math.Ceiling(Double)" => real!(f64::ceil),
        "Math.Truncate(Double)" => real!(f64::trunc),
        "Math.Abs(Double)" => real!(f64::abs),
        "Math.Round(Double)" => real!(f64::round_ties_even),
        "Math.Atan2(Double,Double)" => |cx| Ok(Value::F64(cx.real(0).arctangent_of(cx.real(1)))),
        "Math.Pow(Double,Double)" => |cx| Ok(Value::F64(power(cx.real(0), cx.real(1)))),
        "Math.IEEERemainder(Double,Double)" => |cx| {
            let (x, y) = (cx.real(0), cx.real(1));
            Ok(Value::F64(x - y * (x / y).round_ties_even()))
        },
        "Math.Round(Double,Int32)" => |cx| rounded(cx.real(0), cx.int(1), false),
        "Math.Round(Double,MidpointRounding)" => |cx| rounded(cx.real(0), 0, cx.int(1) == 1),
        "Math.Round(Double,Int32,MidpointRounding)" => |cx| rounded(cx.real(0), cx.int(1), cx.int(2) == 1),
        _ => return None,
    })
}

/// As the Framework: one to any power is one only where the power is a number.
fn power(x: f64, y: f64) -> f64 {
    if y.is_nan() || x.is_nan() {
        return if y == 0.0 { 1.0 } else { f64::NAN };
    }
    if x.abs() == 1.0 && y.is_infinite() {
        return if x == -1.0 { f64::NAN } else { 1.0 };
    }
    x.raised_to(y)
}

/// The Framework's rounding: scaled by a power of ten, rounded, scaled back.
fn rounded(x: f64, digits: i32, away: bool) -> Result<Value, Raise> {
    if !(0..=15).contains(&digits) {
        return Err(Raise::new(
            "ArgumentOutOfRangeException",
            "Rounding digits must be between 0 and 15, inclusive.",
        ));
    }
    if x.abs() >= 1e16 || !x.is_finite() {
        return Ok(Value::F64(x));
    }
    let ten = 10_f64.powi(digits);
    let scaled = x * ten;
    let whole = if away {
        let whole = scaled.trunc();
        if (scaled - whole).abs() >= 0.5 { whole + scaled.signum() } else { whole }
    } else {
        scaled.round_ties_even()
    };
    Ok(Value::F64(whole / ten))
}
