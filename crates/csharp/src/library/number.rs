//! Numbers: their texts, and numbers read from texts.

use super::format::{Number, formatted, plain};
use super::{Cx, Native};
use crate::emit::number as value_of;
use crate::sema::Prim;
use crate::vm::value::Value;
use crate::vm::{Raise, State};

/// A number as formats take it.
pub(super) fn number_of(value: Value, st: &State) -> Option<Number> {
    Some(match value {
        Value::Ref(_) => Number::Decimal(st.heap.decimal(value)?),
        other => return plain_number(other),
    })
}

fn plain_number(value: Value) -> Option<Number> {
    Some(match value {
        Value::F64(x) => Number::Double(x),
        Value::F32(x) => Number::Float(x),
        Value::I8(n) => Number::Whole(n.into(), 8),
        Value::U8(n) => Number::Whole(n.into(), 8),
        Value::I16(n) => Number::Whole(n.into(), 16),
        Value::U16(n) => Number::Whole(n.into(), 16),
        Value::I32(n) => Number::Whole(n.into(), 32),
        Value::U32(n) => Number::Whole(n.into(), 32),
        Value::I64(n) => Number::Whole(n.into(), 64),
        Value::U64(n) => Number::Whole(n.into(), 64),
        _ => return None,
    })
}

/// The text of a number.
pub(super) fn text(value: Value) -> Option<String> {
    plain_number(value).map(plain)
}

const NAMES: &[(&str, Prim)] = &[
    ("SByte", Prim::I8),
    ("Byte", Prim::U8),
    ("Int16", Prim::I16),
    ("UInt16", Prim::U16),
    ("Int32", Prim::I32),
    ("UInt32", Prim::U32),
    ("Int64", Prim::I64),
    ("UInt64", Prim::U64),
    ("Single", Prim::F32),
    ("Double", Prim::F64),
];

pub(super) fn find(key: &str) -> Option<Native> {
    let (owner, member) = key.split_once('.')?;
    let prim = NAMES.iter().find(|(name, _)| *name == owner)?.1;
    let own_out = format!("TryParse(String,{owner})");
    if member == own_out {
        return Some(try_parse_for(prim));
    }
    Some(match member {
        "ToString()" => |cx| {
            let shown = number_of(cx.arg(0), cx.st).map(plain).unwrap_or_default();
            Ok(cx.text(&shown))
        },
        "ToString(String)" => |cx| {
            let Some(number) = number_of(cx.arg(0), cx.st) else { return Ok(Value::Null) };
            let shown = formatted(number, &cx.string(1))?;
            Ok(cx.text(&shown))
        },
        "Equals(Object)" => |cx| Ok(Value::Bool(cx.arg(0) == cx.arg(1))),
        "GetHashCode()" => |cx| Ok(Value::I32(super::object::hash(cx.arg(0), cx.st))),
        "Parse(String)" => parse_for(prim),
        _ => return None,
    })
}

macro_rules! by_prim {
    ($prim:expr, $f:ident) => {
        match $prim {
            Prim::I8 => |cx| $f(cx, Prim::I8),
            Prim::U8 => |cx| $f(cx, Prim::U8),
            Prim::I16 => |cx| $f(cx, Prim::I16),
            Prim::U16 => |cx| $f(cx, Prim::U16),
            Prim::U32 => |cx| $f(cx, Prim::U32),
            Prim::I64 => |cx| $f(cx, Prim::I64),
            Prim::U64 => |cx| $f(cx, Prim::U64),
            Prim::F32 => |cx| $f(cx, Prim::F32),
            Prim::F64 => |cx| $f(cx, Prim::F64),
            _ => |cx| $f(cx, Prim::I32),
        }
    };
}

fn parse_for(prim: Prim) -> Native {
    by_prim!(prim, parse)
}

fn try_parse_for(prim: Prim) -> Native {
    by_prim!(prim, try_parse)
}

fn parse(cx: &mut Cx<'_>, prim: Prim) -> Result<Value, Raise> {
    if cx.arg(0) == Value::Null {
        return Err(Raise::new("ArgumentNullException", "Value cannot be null."));
    }
    read(&cx.string(0), prim).map_err(|too_large| {
        if too_large {
            let kind = match prim {
                Prim::I8 => "Value was either too large or too small for a signed byte.",
                Prim::U8 => "Value was either too large or too small for an unsigned byte.",
                Prim::I16 => "Value was either too large or too small for an Int16.",
                Prim::U16 => "Value was either too large or too small for a UInt16.",
                Prim::U32 => "Value was either too large or too small for a UInt32.",
                Prim::I64 => "Value was either too large or too small for an Int64.",
                Prim::U64 => "Value was either too large or too small for a UInt64.",
                Prim::F64 => "Value was either too large or too small for a Double.",
                Prim::F32 => "Value was either too large or too small for a Single.",
                _ => "Value was either too large or too small for an Int32.",
            };
            Raise::new("OverflowException", kind)
        } else {
            Raise::new("FormatException", "Input string was not in a correct format.")
        }
    })
}

fn try_parse(cx: &mut Cx<'_>, prim: Prim) -> Result<Value, Raise> {
    let found = if cx.arg(0) == Value::Null { None } else { read(&cx.string(0), prim).ok() };
    cx.set(1, found.unwrap_or(value_of(0, prim)));
    Ok(Value::Bool(found.is_some()))
}

/// A number from a text; the error says whether it is only too large.
fn read(text: &str, prim: Prim) -> Result<Value, bool> {
    let clean = text.trim();
    if prim.is_integral() {
        let digits = clean.strip_prefix(['+', '-']).unwrap_or(clean);
        if digits.is_empty() || !digits.bytes().all(|b| b.is_ascii_digit()) {
            return Err(false);
        }
        let n = clean.trim_start_matches('+').parse::<i128>().map_err(|_| true)?;
        let (least, most) = prim.range();
        return if (least..=most).contains(&n) { Ok(value_of(n, prim)) } else { Err(true) };
    }
    let x = match clean {
        "NaN" => f64::NAN,
        "Infinity" => f64::INFINITY,
        "-Infinity" => f64::NEG_INFINITY,
        _ => {
            // Thousands may stand between the digits before the point.
            let plain: String = clean.chars().filter(|c| *c != ',').collect();
            let fits =
                plain.bytes().all(|b| b.is_ascii_digit() || matches!(b, b'.' | b'e' | b'E' | b'+' | b'-'));
            if !fits || plain.is_empty() {
                return Err(false);
            }
            let x = plain.parse::<f64>().map_err(|_| false)?;
            if x.is_infinite() {
                return Err(true);
            }
            x
        }
    };
    Ok(if prim == Prim::F32 { Value::F32(x as f32) } else { Value::F64(x) })
}
