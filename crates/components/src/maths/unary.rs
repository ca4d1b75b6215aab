//! Functions of one number, real or complex, as components.

use katydid_component::{Call, Message, Outcome, whole};
use katydid_data::{Complex, Value, cast};

/// The value of a function at `x`: a complex number stays complex, everything else that is a number is real.
///
/// # Errors
/// When `x` is no number, and when the function has no finite value there.
pub(super) fn apply(
    x: &Value,
    name: &str,
    real: fn(f64) -> f64,
    complex: fn(Complex) -> Complex,
) -> Result<Value, Message> {
    let number = match x {
        Value::Number(x) => *x,
        Value::Integer(i) => f64::from(*i),
        Value::Boolean(b) => f64::from(u8::from(*b)),
        Value::Complex(z) => {
            let result = complex(*z);
            return match result.re.is_finite() && result.im.is_finite() {
                true => Ok(Value::Complex(result)),
                false => Err(Message::error(format!("{name} has no value at {} + {}i", z.re, z.im))),
            };
        }
        Value::Text(text) => cast::parse_number(text)
            .ok_or_else(|| Message::error(format!("The text {text:.40} is not a number")))?,
        other => return Err(Message::error(format!("{name} takes a number, not a {}", other.kind()))),
    };
    let result = real(number);
    match result.is_finite() {
        true => Ok(Value::Number(result)),
        false => Err(Message::error(format!("{name} has no value at {number}"))),
    }
}

/// The values of a function at all numbers of a plain column, which `all` may give at once; `None` when one is not finite.
pub(super) fn numbers(call: &Call<'_>, real: fn(f64) -> f64, all: Option<fn(&mut [f64])>) -> Option<Outcome> {
    let Some(all) = all else {
        return whole::map(call, |&x: &f64| Some(real(x)).filter(|y| y.is_finite()));
    };
    whole::numbers(call, |columns, _| {
        let mut values = columns.first()?.to_vec();
        all(&mut values);
        values.iter().all(|y| y.is_finite()).then_some(values)
    })
}

/// Declares components `y = f(x)`, some with a way to do many at once that gives the same bits.
macro_rules! functions {
    ($at:tt; $($(#[doc = $help:tt])+ $function:ident, $guid:tt, $name:tt, $nick:tt, [$($also:tt),*], $real:expr, $complex:expr $(, $all:expr)?;)*) => {$(
        $(#[doc = $help])+
        #[component($guid, name = $name, nick = $nick, at = $at, also($($also),*), columns = columns::$function)]
        #[output("Result", "y", "The value of the function.")]
        fn $function(
            #[doc = "A number, real or complex."]
            #[port("Value", "x")]
            x: Value,
        ) -> Result<Value, Message> {
            unary::apply(&x, $name, $real, $complex)
        }
    )*
        /// The functions over whole columns of numbers.
        mod columns {
            use super::*;
            $(pub(super) fn $function(call: &katydid_component::Call<'_>) -> Option<katydid_component::Outcome> {
                let all: &[fn(&mut [f64])] = &[$($all)?];
                unary::numbers(call, $real, all.first().copied())
            })*
        }
    };
}

pub(super) use functions;
