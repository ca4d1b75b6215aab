//! `object`, enums, types, the console, and what the library's own C# asks for.

use super::format::formatted;
use super::{Cx, Native, culture, number};
use crate::bound::Const;
use crate::program::Program;
use crate::sema::{Known, Prim, Sema, Ty};
use crate::vm::heap::Obj;
use crate::vm::value::Value;
use crate::vm::{Raise, State};

/// The text of a value that says it without running any code.
pub(crate) fn text_of(value: Value, st: &State, sema: &mut Sema) -> String {
    match value {
        Value::Null => String::new(),
        Value::Bool(b) => if b { "True" } else { "False" }.to_owned(),
        Value::Char(unit) => String::from_utf16_lossy(&[unit]),
        Value::Enum(ty, n) => enum_text(sema, ty, n),
        Value::Ref(handle) => match st.heap.get(handle) {
            Obj::Str(units) => String::from_utf16_lossy(units),
            Obj::Decimal(x) => super::format::plain(super::format::Number::Decimal(*x)),
            Obj::Builder(units) => String::from_utf16_lossy(units),
            Obj::Type(ty) => sema.full_name(*ty),
            _ => {
                let ty = st.type_of(value, sema);
                sema.full_name(ty)
            }
        },
        other => number::text(other).unwrap_or_default(),
    }
}

/// Members of an enum with their values, in the order of values.
fn members(sema: &mut Sema, ty: Ty) -> Vec<(String, i64)> {
    let Some(def) = sema.def_of(ty) else { return Vec::new() };
    let mut fields: Vec<_> = (0..sema.fields.len())
        .filter(|i| sema.fields[*i].owner == def && sema.fields[*i].constant)
        .map(|i| crate::sema::FieldId(i as u32))
        .collect();
    fields.sort();
    let mut all: Vec<(String, i64)> = Vec::new();
    for field in fields {
        let value = match &sema.field(field).known {
            Known::Yes(Const::Int(n)) => *n as i64,
            _ => match crate::bind::constant_of(sema, field) {
                Const::Int(n) => n as i64,
                _ => 0,
            },
        };
        all.push((sema.field(field).name.to_string(), value));
    }
    all.sort_by_key(|(_, n)| *n as u64);
    all
}

fn is_flags(sema: &Sema, ty: Ty) -> bool {
    let decl = sema.def_of(ty).and_then(|d| sema.def(d).decl.clone());
    decl.is_some_and(|d| d.attributes.iter().any(|a| &**a == "Flags" || &**a == "FlagsAttribute"))
}

fn enum_text(sema: &mut Sema, ty: Ty, n: i64) -> String {
    let all = members(sema, ty);
    if let Some((name, _)) = all.iter().find(|(_, v)| *v == n) {
        return name.clone();
    }
    if is_flags(sema, ty) && n != 0 {
        let mut left = n;
        let mut names = Vec::new();
        for (name, value) in all.iter().rev() {
            if *value != 0 && left & value == *value {
                left &= !value;
                names.push(name.clone());
            }
        }
        if left == 0 {
            names.reverse();
            return names.join(", ");
        }
    }
    n.to_string()
}

/// The hash of a value without code of its own.
pub(super) fn hash(value: Value, st: &State) -> i32 {
    match value {
        Value::Bool(b) => b.into(),
        Value::Char(c) => i32::from(c) | i32::from(c) << 16,
        Value::I32(n) => n,
        Value::F64(x) => {
            let bits = if x == 0.0 { 0 } else { x.to_bits() };
            bits as i32 ^ (bits >> 32) as i32
        }
        Value::F32(x) => x.to_bits() as i32,
        Value::I64(n) => n as i32 ^ (n >> 32) as i32,
        Value::U64(n) => n as i32 ^ (n >> 32) as i32,
        Value::Enum(_, n) => n as i32,
        Value::Ref(handle) => match st.heap.get(handle) {
            Obj::Str(units) => units.iter().fold(5381_i32, |h, u| h.wrapping_mul(33) ^ i32::from(*u)),
            Obj::Type(ty) => ty.0 as i32,
            Obj::Decimal(x) => crate::decimal::hash(*x),
            Obj::Delegate(..) => 1,
            _ => handle.0 as i32,
        },
        other => other.whole().unwrap_or(0) as i32,
    }
}

/// Whether two values without code of their own are equal: structs field by field.
fn equal(a: Value, b: Value, st: &State, program: &Program, depth: u32) -> bool {
    let sema = &program.sema;
    match (a, b) {
        (Value::F64(x), Value::F64(y)) => x == y || x.is_nan() && y.is_nan(),
        (Value::Ref(x), Value::Ref(y)) => {
            if x == y {
                return true;
            }
            match (st.heap.get(x), st.heap.get(y)) {
                (Obj::Str(s), Obj::Str(t)) => s == t,
                (Obj::Type(s), Obj::Type(t)) => s == t,
                (Obj::Decimal(s), Obj::Decimal(t)) => s == t,
                (Obj::Delegate(..), Obj::Delegate(..)) => super::delegate::same(a, b, st, program),
                (Obj::Inst(s, fields), Obj::Inst(t, others)) => {
                    s == t
                        && (sema.is_struct(*s) || depth > 0 && is_anonymous(sema, *s))
                        && depth < 32
                        && fields.iter().zip(others).all(|(p, q)| equal(*p, *q, st, program, depth + 1))
                }
                _ => false,
            }
        }
        _ => a == b,
    }
}

fn is_anonymous(sema: &Sema, ty: Ty) -> bool {
    sema.def_of(ty).is_some_and(|d| &*sema.def(d).name == "<>__AnonType")
}

fn fields_hash(value: Value, st: &State, depth: u32) -> i32 {
    if let Value::Ref(handle) = value
        && let Obj::Inst(_, fields) = st.heap.get(handle)
        && depth < 8
    {
        return fields
            .iter()
            .fold(17_i32, |h, f| h.wrapping_mul(31).wrapping_add(fields_hash(*f, st, depth + 1)));
    }
    hash(value, st)
}

fn is_plain(value: Value, st: &State) -> bool {
    match value {
        Value::Null => false,
        Value::Ref(handle) => matches!(st.heap.get(handle), Obj::Str(_) | Obj::Decimal(_)),
        _ => true,
    }
}

fn type_arg(cx: &Cx<'_>, i: usize) -> Result<Ty, Raise> {
    let handle = cx.handle(i)?;
    match cx.st.heap.get(handle) {
        Obj::Type(ty) => Ok(*ty),
        _ => Ok(Ty::ERROR),
    }
}

fn parse_enum(cx: &mut Cx<'_>, ignore_case: bool) -> Result<Value, Raise> {
    let ty = type_arg(cx, 0)?;
    let text = cx.string(1);
    let all = members(cx.sema(), ty);
    let mut value = 0;
    for part in text.split(',') {
        let part = part.trim();
        let found =
            all.iter().find(|(name, _)| name == part || ignore_case && name.eq_ignore_ascii_case(part));
        value |= match (found, part.parse::<i64>()) {
            (Some((_, n)), _) => *n,
            (None, Ok(n)) => n,
            (None, Err(_)) => {
                return Err(Raise::new(
                    "ArgumentException",
                    format!("Requested value '{part}' was not found."),
                ));
            }
        };
    }
    Ok(Value::Enum(ty, value))
}

pub(super) fn find(key: &str) -> Option<Native> {
    Some(match key {
        "Object.new()" => |cx| {
            let ty = cx.program.sema.known.object;
            Ok(cx.instance(ty, &[]))
        },
        "Object.ToString()" => |cx| {
            let text = text_of(cx.arg(0), cx.st, &mut cx.program.sema);
            Ok(cx.text(&text))
        },
        "Boolean.ToString()" | "Enum.ToString()" | "Type.ToString()" | "Type.get_FullName()" => |cx| {
            let text = text_of(cx.arg(0), cx.st, &mut cx.program.sema);
            Ok(cx.text(&text))
        },
        "Object.Equals(Object)"
        | "Boolean.Equals(Object)"
        | "Boolean.Equals(Boolean)"
        | "Type.Equals(Object)" => |cx| Ok(Value::Bool(equal(cx.arg(0), cx.arg(1), cx.st, cx.program, 0))),
        "Object.GetHashCode()" => |cx| {
            let ty = cx.st.type_of(cx.arg(0), &cx.program.sema);
            Ok(Value::I32(if cx.program.sema.is_struct(ty) {
                fields_hash(cx.arg(0), cx.st, 0)
            } else {
                hash(cx.arg(0), cx.st)
            }))
        },
        "Boolean.GetHashCode()" | "Type.GetHashCode()" => |cx| Ok(Value::I32(hash(cx.arg(0), cx.st))),
        "Object.GetType()" => |cx| {
            let ty = cx.st.type_of(cx.arg(0), &cx.program.sema);
            Ok(Value::Ref(cx.st.heap.add(Obj::Type(ty))))
        },
        "Object.MemberwiseClone()" => |cx| {
            let handle = cx.handle(0)?;
            let Obj::Inst(ty, fields) = cx.st.heap.get(handle) else { return Ok(cx.arg(0)) };
            let made = Obj::Inst(*ty, fields.clone());
            Ok(Value::Ref(cx.st.heap.add(made)))
        },
        "AnonymousObject.Equals(Object)" => {
            |cx| Ok(Value::Bool(equal(cx.arg(0), cx.arg(1), cx.st, cx.program, 1)))
        }
        "AnonymousObject.GetHashCode()" | "Library.StructHash(Object)" => {
            |cx| Ok(Value::I32(fields_hash(cx.arg(0), cx.st, 0)))
        }
        "AnonymousObject.__Names()" => |cx| {
            let ty = cx.st.type_of(cx.arg(0), &cx.program.sema);
            let fields =
                cx.program.sema.def_of(ty).map(|d| cx.program.sema.def(d).fields.clone()).unwrap_or_default();
            let names: Vec<_> = fields.iter().map(|f| cx.program.sema.field(*f).name.clone()).collect();
            let values = names.iter().map(|name| cx.st.text(name)).collect();
            let string = cx.program.sema.known.string;
            cx.array(string, values)
        },
        "AnonymousObject.__Values()" => |cx| {
            let handle = cx.handle(0)?;
            let Obj::Inst(_, fields) = cx.st.heap.get(handle) else { return Ok(Value::Null) };
            let values = fields.to_vec();
            let object = cx.program.sema.known.object;
            cx.array(object, values)
        },
        "Type.get_Name()" => |cx| {
            let ty = type_arg(cx, 0)?;
            let sema = &cx.program.sema;
            let name = match sema.types.named(ty) {
                Some((def, args)) if !args.is_empty() => format!("{}`{}", sema.def(def).name, args.len()),
                Some((def, _)) => sema.def(def).name.to_string(),
                None => {
                    let full = sema.full_name(ty);
                    full.rsplit('.').next().unwrap_or(&full).to_owned()
                }
            };
            Ok(cx.text(&name))
        },
        "Enum.ToString(String)" => |cx| {
            let Value::Enum(ty, n) = cx.arg(0) else { return Ok(Value::Null) };
            let text = match &*cx.string(1) {
                "D" | "d" => n.to_string(),
                "X" | "x" => match cx.sema().enum_prim(ty) {
                    Some(Prim::I8 | Prim::U8) => format!("{:02X}", n as u8),
                    Some(Prim::I16 | Prim::U16) => format!("{:04X}", n as u16),
                    Some(Prim::I64 | Prim::U64) => format!("{n:016X}"),
                    _ => format!("{:08X}", n as u32),
                },
                _ => enum_text(cx.sema(), ty, n),
            };
            Ok(cx.text(&text))
        },
        "Enum.CompareTo(Object)" => |cx| Ok(Value::I32(cx.arg(0).whole().cmp(&cx.arg(1).whole()) as i32)),
        "Enum.HasFlag(Enum)" => |cx| {
            let (a, b) = (cx.arg(0).whole().unwrap_or(0), cx.arg(1).whole().unwrap_or(0));
            Ok(Value::Bool(a & b == b))
        },
        "Enum.Parse(Type,String)" => |cx| parse_enum(cx, false),
        "Enum.Parse(Type,String,Boolean)" => |cx| {
            let ignore = cx.truth(2);
            parse_enum(cx, ignore)
        },
        "Enum.GetValues(Type)" => |cx| {
            let ty = type_arg(cx, 0)?;
            let values = members(cx.sema(), ty).into_iter().map(|(_, n)| Value::Enum(ty, n)).collect();
            cx.array(ty, values)
        },
        "Enum.GetNames(Type)" => |cx| {
            let ty = type_arg(cx, 0)?;
            let names = members(cx.sema(), ty);
            let values = names.iter().map(|(name, _)| cx.st.text(name)).collect();
            let string = cx.program.sema.known.string;
            cx.array(string, values)
        },
        "Enum.GetName(Type,Object)" => |cx| {
            let ty = type_arg(cx, 0)?;
            let n = cx.arg(1).whole().unwrap_or(0) as i64;
            let found = members(cx.sema(), ty).into_iter().find(|(_, v)| *v == n);
            Ok(found.map_or(Value::Null, |(name, _)| cx.text(&name)))
        },
        "Enum.GetUnderlyingType(Type)" => |cx| {
            let ty = type_arg(cx, 0)?;
            let prim = cx.program.sema.enum_prim(ty).unwrap_or(Prim::I32);
            let under = cx.prim(prim);
            Ok(Value::Ref(cx.st.heap.add(Obj::Type(under))))
        },
        "Enum.IsDefined(Type,Object)" => |cx| {
            let ty = type_arg(cx, 0)?;
            let all = members(cx.sema(), ty);
            let name = cx.st.string(cx.arg(1));
            let n = cx.arg(1).whole().map(|n| n as i64);
            Ok(Value::Bool(all.iter().any(|(m, v)| Some(*v) == n || Some(m) == name.as_ref())))
        },
        "Library.IsThere(Object)" => |cx| Ok(Value::Bool(cx.arg(0) != Value::Null)),
        "Library.IsPlain(Object)" => |cx| Ok(Value::Bool(is_plain(cx.arg(0), cx.st))),
        "Library.PlainHash(Object)" => |cx| Ok(Value::I32(hash(cx.arg(0), cx.st))),
        "Library.PlainEquals(Object,Object)" => {
            |cx| Ok(Value::Bool(equal(cx.arg(0), cx.arg(1), cx.st, cx.program, 0)))
        }
        "Library.PlainCompare(Object,Object)" => |cx| {
            let (a, b) = (cx.arg(0), cx.arg(1));
            let order = match (cx.st.heap.str(a), cx.st.heap.str(b)) {
                (Some(a), Some(b)) => culture::compare(a, b, false),
                _ => match (a, b) {
                    (Value::Bool(a), Value::Bool(b)) => a.cmp(&b),
                    (Value::Ref(_), Value::Ref(_)) => cx.st.heap.decimal(a).cmp(&cx.st.heap.decimal(b)),
                    _ if a.whole().is_some() => a.whole().cmp(&b.whole()),
                    _ => {
                        let (a, b) = (a.real().unwrap_or(0.0), b.real().unwrap_or(0.0));
                        a.partial_cmp(&b).unwrap_or_else(|| b.is_nan().cmp(&a.is_nan()))
                    }
                },
            };
            Ok(Value::I32(order as i32))
        },
        "Library.Plain(Object,String)" => |cx| {
            let value = cx.arg(0);
            let format = cx.string(1);
            let text = match (number::number_of(value, cx.st), value) {
                (Some(number), _) => formatted(number, &format)?,
                (None, Value::Enum(_, n)) if matches!(&*format, "D" | "d") => n.to_string(),
                _ => text_of(value, cx.st, &mut cx.program.sema),
            };
            Ok(cx.text(&text))
        },
        "Console.Print(String)" => |cx| {
            let text = cx.string(0);
            cx.st.print(&text)?;
            Ok(Value::Null)
        },
        "Convert.ToInt32(String,Int32)" => |cx| {
            let text = cx.string(0);
            let radix = cx.int(1);
            if !matches!(radix, 2 | 8 | 10 | 16) {
                return Err(Raise::new("ArgumentException", "Invalid Base."));
            }
            let clean =
                if radix == 16 { text.trim_start_matches("0x").trim_start_matches("0X") } else { &text };
            match i64::from_str_radix(clean, radix as u32) {
                Ok(n) if n <= u32::MAX.into() && n >= i32::MIN.into() => Ok(Value::I32(n as i32)),
                Ok(_) => Err(Raise::new(
                    "OverflowException",
                    "Value was either too large or too small for a UInt32.",
                )),
                Err(_) => Err(Raise::new("FormatException", "Could not find any recognizable digits.")),
            }
        },
        "Convert.ToString(Int32,Int32)" => |cx| {
            let n = cx.int(0);
            let text = match cx.int(1) {
                2 => format!("{n:b}"),
                8 => format!("{n:o}"),
                16 => format!("{n:x}"),
                10 => n.to_string(),
                _ => return Err(Raise::new("ArgumentException", "Invalid Base.")),
            };
            Ok(cx.text(&text))
        },
        _ => return None,
    })
}
