//! `System.String` and `System.Char`.

use super::{Cx, Native, culture};
use crate::sema::Prim;
use crate::vm::Raise;
use crate::vm::elements::Elements;
use crate::vm::heap::Obj;
use crate::vm::value::Value;

fn range(name: &str) -> Raise {
    Raise::new(
        "ArgumentOutOfRangeException",
        format!("Index and length must refer to a location within the string.\nParameter name: {name}"),
    )
}

fn unit(cx: &Cx<'_>, i: usize) -> u16 {
    if let Value::Char(unit) = cx.arg(i) { unit } else { 0 }
}

fn char_of(cx: &Cx<'_>) -> char {
    char::from_u32(unit(cx, 0).into()).unwrap_or('\u{fffd}')
}

fn units_of_array(cx: &Cx<'_>, i: usize) -> Vec<u16> {
    let Value::Ref(handle) = cx.arg(i) else { return Vec::new() };
    match cx.st.heap.get(handle) {
        Obj::Array(_, Elements::Char(units), _) => units.clone(),
        _ => Vec::new(),
    }
}

fn made(cx: &mut Cx<'_>, units: &[u16]) -> Result<Value, Raise> {
    cx.st.reserve(units.len() * 2)?;
    cx.st.spend(units.len() / 64)?;
    Ok(cx.st.heap.text(units))
}

/// Case by character, as .NET does: no character becomes two.
fn case(unit: u16, upper: bool) -> u16 {
    let Some(c) = char::from_u32(unit.into()) else { return unit };
    let one = |mut it: Box<dyn Iterator<Item = char>>| match (it.next(), it.next()) {
        (Some(c), None) if (c as u32) < 0x1_0000 => c as u16,
        _ => unit,
    };
    if upper { one(Box::new(c.to_uppercase())) } else { one(Box::new(c.to_lowercase())) }
}

fn is_space(unit: &u16) -> bool {
    char::from_u32((*unit).into()).is_some_and(char::is_whitespace)
}

fn trimmed(cx: &mut Cx<'_>, start: bool, end: bool) -> Result<Value, Raise> {
    cx.handle(0)?;
    let units = cx.units(0);
    let from = if start { units.iter().position(|u| !is_space(u)).unwrap_or(units.len()) } else { 0 };
    let to = if end { units.iter().rposition(|u| !is_space(u)).map_or(from, |i| i + 1) } else { units.len() };
    let part = units[from..to.max(from)].to_vec();
    made(cx, &part)
}

/// Where a part begins, from a place on.
fn position(units: &[u16], part: &[u16], from: usize) -> Option<usize> {
    if part.is_empty() {
        return (from <= units.len()).then_some(from);
    }
    units.get(from..)?.windows(part.len()).position(|w| w == part).map(|i| i + from)
}

/// A text with all parts replaced.
pub(super) fn replaced(cx: &mut Cx<'_>, units: &[u16], from: &[u16], to: &[u16]) -> Result<Vec<u16>, Raise> {
    if from.is_empty() {
        return Err(Raise::new(
            "ArgumentException",
            "String cannot be of zero length.\nParameter name: oldValue",
        ));
    }
    let mut out = Vec::new();
    let mut at = 0;
    while let Some(found) = position(units, from, at) {
        out.extend_from_slice(&units[at..found]);
        out.extend_from_slice(to);
        at = found + from.len();
        cx.st.reserve(out.len() * 2)?;
    }
    out.extend_from_slice(&units[at..]);
    cx.st.spend(units.len() / 16)?;
    Ok(out)
}

fn split(cx: &mut Cx<'_>) -> Result<Value, Raise> {
    cx.handle(0)?;
    let units = cx.units(0).to_vec();
    let separators: Option<Vec<Vec<u16>>> = match cx.arg(1) {
        Value::Ref(handle) => match cx.st.heap.get(handle) {
            Obj::Array(_, data, _) => {
                Some(data.to_values().iter().map(|v| cx.st.heap.str(*v).unwrap_or(&[]).to_vec()).collect())
            }
            _ => None,
        },
        _ => None,
    };
    let (most, no_empty) = (cx.int(2), cx.truth(3));
    let mut parts: Vec<Vec<u16>> = Vec::new();
    let (mut start, mut at) = (0, 0);
    while at < units.len() && (parts.len() as i64) < i64::from(most) - 1 {
        let length = match &separators {
            None => usize::from(is_space(&units[at])),
            Some(list) => {
                list.iter().find(|s| !s.is_empty() && units[at..].starts_with(s)).map_or(0, Vec::len)
            }
        };
        if length == 0 {
            at += 1;
            continue;
        }
        if !(no_empty && at == start) {
            parts.push(units[start..at].to_vec());
        }
        at += length;
        start = at;
    }
    if most > 0 && !(no_empty && start == units.len()) {
        parts.push(units[start..].to_vec());
    }
    cx.st.reserve(parts.len() * 64 + units.len() * 2)?;
    let values = parts.iter().map(|p| cx.st.heap.text(p)).collect();
    let string = cx.program.sema.known.string;
    cx.array(string, values)
}

pub(super) fn find(key: &str) -> Option<Native> {
    Some(match key {
        "String.get_Length()" => |cx| {
            cx.handle(0)?;
            Ok(Value::I32(cx.units(0).len() as i32))
        },
        "String.get_Item(Int32)" => |cx| {
            cx.handle(0)?;
            let i = cx.int(1);
            cx.units(0).get(i as usize).map(|u| Value::Char(*u)).ok_or_else(|| {
                Raise::new("IndexOutOfRangeException", "Index was outside the bounds of the array.")
            })
        },
        "String.new(Char[])" => |cx| {
            let units = units_of_array(cx, 1);
            made(cx, &units)
        },
        "String.new(Char[],Int32,Int32)" => |cx| {
            let units = units_of_array(cx, 1);
            let (start, length) = (cx.int(2), cx.int(3));
            match (start >= 0 && length >= 0)
                .then(|| units.get(start as usize..(start + length) as usize))
                .flatten()
            {
                Some(part) => made(cx, part),
                None => Err(range("startIndex")),
            }
        },
        "String.new(Char,Int32)" => |cx| {
            let (unit, n) = (unit(cx, 1), cx.int(2));
            if n < 0 {
                return Err(Raise::new(
                    "ArgumentOutOfRangeException",
                    "'count' must be non-negative.\nParameter name: count",
                ));
            }
            cx.st.reserve(n as usize * 2)?;
            made(cx, &vec![unit; n as usize])
        },
        "String.GetHashCode()" => |cx| Ok(Value::I32(super::object::hash(cx.arg(0), cx.st))),
        "String.Same(String,String)" | "String.op_Equality(String,String)" => |cx| Ok(Value::Bool(same(cx))),
        "String.op_Inequality(String,String)" => |cx| Ok(Value::Bool(!same(cx))),
        "String.CultureOrder(String,String,Boolean)" => |cx| {
            Ok(Value::I32(match (cx.arg(0), cx.arg(1)) {
                (Value::Null, Value::Null) => 0,
                (Value::Null, _) => -1,
                (_, Value::Null) => 1,
                _ => culture::compare(cx.units(0), cx.units(1), cx.truth(2)) as i32,
            }))
        },
        "String.CompareOrdinal(String,String)" => |cx| {
            Ok(Value::I32(match (cx.arg(0), cx.arg(1)) {
                (Value::Null, Value::Null) => 0,
                (Value::Null, _) => -1,
                (_, Value::Null) => 1,
                _ => {
                    let (a, b) = (cx.units(0), cx.units(1));
                    a.iter()
                        .zip(b)
                        .find(|(x, y)| x != y)
                        .map_or(a.len() as i32 - b.len() as i32, |(x, y)| i32::from(*x) - i32::from(*y))
                }
            }))
        },
        "String.Substring(Int32)" => |cx| {
            cx.handle(0)?;
            let start = cx.int(1);
            if start < 0 {
                return Err(Raise::new(
                    "ArgumentOutOfRangeException",
                    "StartIndex cannot be less than zero.\nParameter name: startIndex",
                ));
            }
            match cx.units(0).get(start as usize..).map(<[u16]>::to_vec) {
                Some(part) => made(cx, &part),
                None => Err(Raise::new(
                    "ArgumentOutOfRangeException",
                    "startIndex cannot be larger than length of string.\nParameter name: startIndex",
                )),
            }
        },
        "String.Substring(Int32,Int32)" => |cx| {
            cx.handle(0)?;
            let (start, length) = (cx.int(1), cx.int(2));
            if start < 0 {
                return Err(Raise::new(
                    "ArgumentOutOfRangeException",
                    "StartIndex cannot be less than zero.\nParameter name: startIndex",
                ));
            }
            if length < 0 {
                return Err(Raise::new(
                    "ArgumentOutOfRangeException",
                    "Length cannot be less than zero.\nParameter name: length",
                ));
            }
            match cx.units(0).get(start as usize..start as usize + length as usize).map(<[u16]>::to_vec) {
                Some(part) => made(cx, &part),
                None if start as usize > cx.units(0).len() => Err(Raise::new(
                    "ArgumentOutOfRangeException",
                    "startIndex cannot be larger than length of string.\nParameter name: startIndex",
                )),
                None => Err(range("length")),
            }
        },
        "String.ToUpper()" => |cx| {
            cx.handle(0)?;
            let units: Vec<u16> = cx.units(0).iter().map(|u| case(*u, true)).collect();
            made(cx, &units)
        },
        "String.ToLower()" => |cx| {
            cx.handle(0)?;
            let units: Vec<u16> = cx.units(0).iter().map(|u| case(*u, false)).collect();
            made(cx, &units)
        },
        "String.Trim()" => |cx| trimmed(cx, true, true),
        "String.TrimStart()" => |cx| trimmed(cx, true, false),
        "String.TrimEnd()" => |cx| trimmed(cx, false, true),
        "String.Find(String,String,Int32,Int32,Boolean)" => |cx| {
            let (units, part, start, last) =
                (cx.units(0), cx.units(1), cx.int(2).max(0) as usize, cx.truth(4));
            let found = if last {
                if part.is_empty() {
                    Some(units.len().saturating_sub(1))
                } else {
                    units.windows(part.len()).rposition(|w| w == part)
                }
            } else {
                position(units, part, start)
            };
            let work = units.len() / 64;
            cx.st.spend(work)?;
            Ok(Value::I32(found.map_or(-1, |i| i as i32)))
        },
        "String.Replace(String,String)" => |cx| {
            cx.handle(0)?;
            if cx.arg(1) == Value::Null {
                return Err(Raise::new(
                    "ArgumentNullException",
                    "Value cannot be null.\nParameter name: oldValue",
                ));
            }
            let (units, from, to) = (cx.units(0).to_vec(), cx.units(1).to_vec(), cx.units(2).to_vec());
            let out = replaced(cx, &units, &from, &to)?;
            made(cx, &out)
        },
        "String.Replace(Char,Char)" => |cx| {
            cx.handle(0)?;
            let (a, b) = (unit(cx, 1), unit(cx, 2));
            let out: Vec<u16> = cx.units(0).iter().map(|u| if *u == a { b } else { *u }).collect();
            made(cx, &out)
        },
        "String.ToCharArray()" => |cx| {
            cx.handle(0)?;
            let units = cx.units(0).to_vec();
            let ty = cx.prim(Prim::Char);
            cx.array_of(ty, Elements::Char(units))
        },
        "String.Cut(String,String[],Int32,Boolean)" => split,
        "String.Glue(String,String[],Int32,Int32)" => |cx| {
            let separator = cx.units(0).to_vec();
            let handle = cx.handle(1)?;
            let (start, count) = (cx.int(2), cx.int(3));
            let Obj::Array(_, data, _) = cx.st.heap.get(handle) else { return Ok(Value::Null) };
            let Some(parts) = (start >= 0 && count >= 0)
                .then(|| data.part(start as usize..start as usize + count as usize))
                .flatten()
            else {
                return Err(range("startIndex"));
            };
            let mut out: Vec<u16> = Vec::new();
            for (i, part) in parts.references().iter().enumerate() {
                if i > 0 {
                    out.extend_from_slice(&separator);
                }
                out.extend_from_slice(cx.st.heap.str(*part).unwrap_or(&[]));
                if cx.st.heap.exceeds(out.len() * 2) {
                    break;
                }
            }
            made(cx, &out)
        },
        "Char.ToString()" => |cx| {
            let unit = unit(cx, 0);
            made(cx, &[unit])
        },
        "Char.Equals(Object)" => |cx| Ok(Value::Bool(cx.arg(0) == cx.arg(1))),
        "Char.GetHashCode()" => |cx| Ok(Value::I32(super::object::hash(cx.arg(0), cx.st))),
        "Char.IsDigit(Char)" => |cx| Ok(Value::Bool(char_of(cx).is_ascii_digit())),
        "Char.IsNumber(Char)" => |cx| Ok(Value::Bool(char_of(cx).is_numeric())),
        "Char.IsLetter(Char)" => |cx| Ok(Value::Bool(char_of(cx).is_alphabetic())),
        "Char.IsWhiteSpace(Char)" => |cx| Ok(Value::Bool(char_of(cx).is_whitespace())),
        "Char.IsUpper(Char)" => |cx| Ok(Value::Bool(char_of(cx).is_uppercase())),
        "Char.IsLower(Char)" => |cx| Ok(Value::Bool(char_of(cx).is_lowercase())),
        "Char.IsPunctuation(Char)" => |cx| {
            let c = char_of(cx);
            Ok(Value::Bool(
                c.is_ascii_punctuation() && !matches!(c, '$' | '+' | '<' | '=' | '>' | '^' | '`' | '|' | '~'),
            ))
        },
        "Char.ToUpper(Char)" => |cx| Ok(Value::Char(case(unit(cx, 0), true))),
        "Char.ToLower(Char)" => |cx| Ok(Value::Char(case(unit(cx, 0), false))),
        _ => return None,
    })
}

fn same(cx: &Cx<'_>) -> bool {
    match (cx.st.heap.str(cx.arg(0)), cx.st.heap.str(cx.arg(1))) {
        (Some(a), Some(b)) => a == b,
        (None, None) => true,
        _ => false,
    }
}
