//! Numbers, flags and text.

use katydid_data::Colour;
use serde_json::Value as Json;

use super::read::{Members, Read, kind};
use super::{Wire, no};
use crate::{Fault, Value};

/// A number as JSON has it. What JSON cannot say is text, as .NET writers have it.
pub(crate) fn number(x: f64) -> Json {
    match serde_json::Number::from_f64(x) {
        Some(number) => Json::Number(number),
        None if x.is_nan() => Json::from("NaN"),
        None if x > 0.0 => Json::from("Infinity"),
        None => Json::from("-Infinity"),
    }
}

impl Read for f64 {
    /// A finite number, or text that is one.
    fn read(json: &Json) -> Result<Self, Fault> {
        let number = match json {
            Json::Number(number) => number.as_f64(),
            Json::String(text) => text.trim().parse().ok(),
            _ => None,
        };
        match number {
            Some(x) if x.is_finite() => Ok(x),
            Some(_) => Err(Fault::bad_request("is not a finite number")),
            None => Err(Fault::bad_request(format!("is {}, not a number", kind(json)))),
        }
    }

    fn of_value(value: &Value) -> Result<Self, Fault> {
        match value {
            Value::Number(x) if x.is_finite() => Ok(*x),
            #[expect(clippy::cast_precision_loss, reason = "as .NET converts whole numbers")]
            Value::Int(whole) => Ok(*whole as Self),
            Value::Bool(_) | Value::Text(_) => {
                Err(Fault::bad_request(format!("is {}, not a number", value.noun())))
            }
            other => Self::read(&other.to_json(0)?),
        }
    }

    fn type_name() -> String {
        "Double".into()
    }
}

impl Read for i32 {
    /// A whole number, or text that is one; `2.0` counts as whole.
    fn read(json: &Json) -> Result<Self, Fault> {
        let x = f64::read(json)?;
        if x.fract() != 0.0 {
            return Err(Fault::bad_request(format!("is {x}, not a whole number")));
        }
        if x < f64::from(Self::MIN) || x > f64::from(Self::MAX) {
            return Err(Fault::bad_request(format!("is {x}, beyond 32 bits")));
        }
        #[expect(clippy::cast_possible_truncation, reason = "whole and within the range")]
        let whole = x as Self;
        Ok(whole)
    }

    fn type_name() -> String {
        "Int32".into()
    }
}

impl Read for bool {
    /// `true` or `false`, as text too, or a number that is 0 or 1.
    fn read(json: &Json) -> Result<Self, Fault> {
        let flag = match json {
            Json::Bool(flag) => Some(*flag),
            Json::String(text) if text.trim().eq_ignore_ascii_case("true") => Some(true),
            Json::String(text) if text.trim().eq_ignore_ascii_case("false") => Some(false),
            Json::Number(n) if n.as_f64() == Some(0.0) => Some(false),
            Json::Number(n) if n.as_f64() == Some(1.0) => Some(true),
            _ => None,
        };
        flag.ok_or_else(|| Fault::bad_request(format!("is {}, not true or false", kind(json))))
    }

    fn of_value(value: &Value) -> Result<Self, Fault> {
        match value {
            Value::Bool(flag) => Ok(*flag),
            other => Err(Fault::bad_request(format!("is {}, not true or false", other.noun()))),
        }
    }

    fn type_name() -> String {
        "Boolean".into()
    }
}

impl Read for String {
    fn read(json: &Json) -> Result<Self, Fault> {
        match json {
            Json::String(text) => Ok(text.clone()),
            other => Err(Fault::bad_request(format!("is {}, not text", kind(other)))),
        }
    }

    fn type_name() -> String {
        "String".into()
    }
}

impl Wire for Colour {
    const TYPE: &'static str = "System.Drawing.Color";
    const NAME: &'static str = "a colour";

    /// `"r, g, b"` or `"a, r, g, b"` as .NET writes colours, `{"R", "G", "B", "A"}`, `[r, g, b]` or `[r, g, b, a]`, or
    /// the 32 bits of alpha, red, green and blue as a number.
    fn from_json(json: &Json) -> Result<Self, Fault> {
        let channel =
            |x: i32| u8::try_from(x).map_err(|_| no::<Self>(format!("channel {x} is not 0 to 255")));
        let of = |[a, r, g, b]: [i32; 4]| Ok(Self::argb(channel(a)?, channel(r)?, channel(g)?, channel(b)?));
        match json {
            Json::Array(items) => {
                let channels =
                    items.iter().map(i32::read).collect::<Result<Vec<_>, _>>().map_err(no::<Self>)?;
                match *channels.as_slice() {
                    [r, g, b] => of([255, r, g, b]),
                    [r, g, b, a] => of([a, r, g, b]),
                    _ => Err(no::<Self>(format!("it has {} channels", items.len()))),
                }
            }
            Json::Number(number) => {
                let bits = number.as_i64().filter(|bits| (i64::from(i32::MIN)..1 << 32).contains(bits));
                let bits = bits.ok_or_else(|| no::<Self>("it is not 32 bits"))?;
                let [_, _, _, _, a, r, g, b] = bits.to_be_bytes();
                Ok(Self::argb(a, r, g, b))
            }
            Json::String(text) => {
                let parts: Vec<Option<i32>> = text.split(',').map(|part| part.trim().parse().ok()).collect();
                match *parts.as_slice() {
                    [Some(r), Some(g), Some(b)] => of([255, r, g, b]),
                    [Some(a), Some(r), Some(g), Some(b)] => of([a, r, g, b]),
                    _ => Err(no::<Self>("it is not like \"255, 0, 0\"")),
                }
            }
            other => {
                let members = Members::of(other).map_err(no::<Self>)?;
                of([members.read_or("A", 255)?, members.read("R")?, members.read("G")?, members.read("B")?])
            }
        }
    }

    fn to_json(&self, _: i32) -> Result<Json, Fault> {
        let Self { a, r, g, b } = self;
        Ok(Json::from(if *a == 255 { format!("{r}, {g}, {b}") } else { format!("{a}, {r}, {g}, {b}") }))
    }
}
