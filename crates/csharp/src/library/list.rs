//! `List<T>` and `StringBuilder`.

use smallvec::SmallVec;

use super::{Cx, Native};
use crate::program::Start;
use crate::vm::Raise;
use crate::vm::elements::Elements;
use crate::vm::heap::Obj;
use crate::vm::value::Value;

/// The characters of the longest `int`, -2147483648.
const LONGEST_INT: usize = 11;

fn range() -> Raise {
    Raise::new(
        "ArgumentOutOfRangeException",
        "Index was out of range. Must be non-negative and less than the size of the collection.\nParameter name: index",
    )
}

fn items<'c>(cx: &'c mut Cx<'_>) -> Result<(&'c mut Elements, &'c mut u32), Raise> {
    let handle = cx.handle(0)?;
    match cx.st.heap.get_mut(handle) {
        Some(Obj::List(_, items, version)) => Ok((items, version)),
        _ => {
            Err(Raise::new("NullReferenceException", "Object reference not set to an instance of an object"))
        }
    }
}

fn index(cx: &mut Cx<'_>, place: usize, beyond: usize) -> Result<usize, Raise> {
    let i = cx.int(place);
    let (items, _) = items(cx)?;
    if i < 0 || i as usize >= items.len() + beyond { Err(range()) } else { Ok(i as usize) }
}

fn grow(cx: &mut Cx<'_>, next: Value) -> Result<(), Raise> {
    let (items, _) = items(cx)?;
    if items.len() == items.capacity() {
        let more = items.bytes_to_grow(next);
        cx.st.reserve(more)?;
        cx.st.heap.bytes += more;
    }
    Ok(())
}

fn span(cx: &mut Cx<'_>) -> Result<(usize, usize), Raise> {
    let (start, count) = (cx.int(1), cx.int(2));
    let (items, _) = items(cx)?;
    if start < 0 || count < 0 {
        return Err(Raise::new("ArgumentOutOfRangeException", "Non-negative number required."));
    }
    if start as usize + count as usize > items.len() {
        return Err(Raise::new(
            "ArgumentException",
            "Offset and length were out of bounds for the array or count is greater than the number of elements from index to the end of the source collection.",
        ));
    }
    Ok((start as usize, start as usize + count as usize))
}

pub(super) fn find(key: &str) -> Option<Native> {
    Some(match key {
        "List.new()" | "List.new(Int32)" => |cx| {
            let ty = cx.ty;
            Ok(Value::Ref(cx.st.heap.add(Obj::List(ty, Vec::new().into(), 0))))
        },
        "List.get_Count()" => |cx| Ok(Value::I32(items(cx)?.0.len() as i32)),
        "List.get_Item(Int32)" => |cx| {
            let i = cx.int(1);
            items(cx)?.0.get(i as usize).ok_or_else(range)
        },
        "List.set_Item(Int32)" => |cx| {
            let i = index(cx, 1, 0)?;
            let value = cx.arg(2);
            let (items, version) = items(cx)?;
            items.set(i, value);
            *version += 1;
            Ok(Value::Null)
        },
        "List.Add(T)" => |cx| {
            let value = cx.arg(1);
            grow(cx, value)?;
            let (items, version) = items(cx)?;
            items.push(value);
            *version += 1;
            Ok(Value::Null)
        },
        "List.__Version()" => |cx| Ok(Value::I32(*items(cx)?.1 as i32)),
        "List.__More(Int32,Int32)" => |cx| {
            let (i, seen) = (cx.int(1), cx.int(2));
            let (items, version) = items(cx)?;
            if *version as i32 != seen {
                return Err(Raise::new(
                    "InvalidOperationException",
                    "Collection was modified; enumeration operation may not execute.",
                ));
            }
            Ok(Value::Bool((i as usize) < items.len()))
        },
        "List.Clear()" => |cx| {
            let (items, version) = items(cx)?;
            items.clear();
            *version += 1;
            Ok(Value::Null)
        },
        "List.Insert(Int32,T)" => |cx| {
            let i = index(cx, 1, 1).map_err(|_| {
                let message = "Index must be within the bounds of the List.\nParameter name: index";
                Raise::new("ArgumentOutOfRangeException", message)
            })?;
            let value = cx.arg(2);
            grow(cx, value)?;
            let (items, version) = items(cx)?;
            items.insert(i, value);
            *version += 1;
            let work = (items.len() - i) / 64;
            cx.st.spend(work)?;
            Ok(Value::Null)
        },
        "List.RemoveAt(Int32)" => |cx| {
            let i = index(cx, 1, 0)?;
            let (items, version) = items(cx)?;
            items.remove(i..i + 1);
            *version += 1;
            let work = (items.len() - i) / 64;
            cx.st.spend(work)?;
            Ok(Value::Null)
        },
        "List.RemoveRange(Int32,Int32)" => |cx| {
            let (from, to) = span(cx)?;
            let (items, version) = items(cx)?;
            items.remove(from..to);
            *version += 1;
            Ok(Value::Null)
        },
        "List.GetRange(Int32,Int32)" => |cx| {
            let (from, to) = span(cx)?;
            let made = items(cx)?.0.part(from..to).ok_or_else(range)?;
            cx.st.reserve(made.bytes())?;
            let ty = cx.ty;
            let copies = copied_elements(cx, made);
            Ok(Value::Ref(cx.st.heap.add(Obj::List(ty, copies, 0))))
        },
        "List.Reverse(Int32,Int32)" => |cx| {
            let (from, to) = span(cx)?;
            let (items, version) = items(cx)?;
            items.reverse(from..to);
            *version += 1;
            Ok(Value::Null)
        },
        "List.ToArray()" => |cx| {
            let made = items(cx)?.0.clone();
            let element = cx.program.sema.args_of(cx.ty).first().copied().unwrap_or(crate::sema::Ty::ERROR);
            let copies = copied_elements(cx, made);
            cx.array_of(element, copies)
        },
        "List.__Take(T[])" => |cx| {
            let handle = cx.handle(1)?;
            let data = match cx.st.heap.get(handle) {
                Obj::Array(_, data, _) => data.clone(),
                _ => Vec::new().into(),
            };
            let (items, version) = items(cx)?;
            *items = data;
            *version += 1;
            Ok(Value::Null)
        },
        "StringBuilder.new()" | "StringBuilder.new(Int32)" => |cx| {
            builder_type(cx);
            Ok(Value::Ref(cx.st.heap.add(Obj::Builder(Vec::new()))))
        },
        "StringBuilder.new(String)" => |cx| {
            builder_type(cx);
            let units = cx.units(1).to_vec();
            Ok(Value::Ref(cx.st.heap.add(Obj::Builder(units))))
        },
        "StringBuilder.get_Length()" => |cx| Ok(Value::I32(builder(cx)?.len() as i32)),
        "StringBuilder.set_Length()" => |cx| {
            let n = cx.int(1);
            if n < 0 {
                return Err(range());
            }
            cx.st.reserve(n as usize * 2)?;
            builder(cx)?.resize(n as usize, 0);
            Ok(Value::Null)
        },
        "StringBuilder.get_Item(Int32)" => |cx| {
            let i = cx.int(1);
            builder(cx)?.get(i as usize).map(|u| Value::Char(*u)).ok_or_else(out)
        },
        "StringBuilder.set_Item(Int32)" => |cx| {
            let (i, Value::Char(unit)) = (cx.int(1), cx.arg(2)) else { return Ok(Value::Null) };
            match builder(cx)?.get_mut(i as usize) {
                Some(slot) => *slot = unit,
                None => return Err(range()),
            }
            Ok(Value::Null)
        },
        "StringBuilder.ToString()" => |cx| {
            let units = builder(cx)?.clone();
            cx.st.reserve(units.len() * 2)?;
            cx.st.spend(units.len() / 64)?;
            Ok(cx.st.heap.text(&units))
        },
        "StringBuilder.Put(String)" | "StringBuilder.Append(String)" => |cx| {
            cx.st.reserve(cx.units(1).len() * 2)?;
            // Taken out for the while, so that the text need not be copied before it is appended.
            let mut built = std::mem::take(builder(cx)?);
            built.extend_from_slice(cx.units(1));
            cx.st.heap.bytes += cx.units(1).len() * 2;
            *builder(cx)? = built;
            Ok(cx.arg(0))
        },
        "StringBuilder.Append(Char)" => |cx| {
            let Value::Char(unit) = cx.arg(1) else { return Ok(cx.arg(0)) };
            append(cx, &[unit])
        },
        "StringBuilder.Append(Int32)" => |cx| {
            let units: SmallVec<[u16; LONGEST_INT]> = cx.int(1).to_string().encode_utf16().collect();
            append(cx, &units)
        },
        "StringBuilder.Insert(Int32,String)" => |cx| {
            let units = cx.units(2).to_vec();
            let i = cx.int(1);
            cx.st.reserve(units.len() * 2)?;
            let b = builder(cx)?;
            if i < 0 || i as usize > b.len() {
                return Err(range());
            }
            b.splice(i as usize..i as usize, units);
            Ok(cx.arg(0))
        },
        "StringBuilder.Remove(Int32,Int32)" => |cx| {
            let (i, n) = (cx.int(1), cx.int(2));
            let b = builder(cx)?;
            if i < 0 || n < 0 || i as usize + n as usize > b.len() {
                return Err(range());
            }
            b.drain(i as usize..(i + n) as usize);
            Ok(cx.arg(0))
        },
        "StringBuilder.Replace(String,String)" => |cx| {
            let (from, to) = (cx.units(1).to_vec(), cx.units(2).to_vec());
            let units = builder(cx)?.clone();
            let made = super::string::replaced(cx, &units, &from, &to)?;
            *builder(cx)? = made;
            Ok(cx.arg(0))
        },
        _ => return None,
    })
}

fn out() -> Raise {
    Raise::new("IndexOutOfRangeException", "Index was outside the bounds of the array.")
}

/// The type is known by name from now on.
fn builder_type(cx: &mut Cx<'_>) {
    let _ = cx.type_named("System.Text", "StringBuilder");
}

fn append(cx: &mut Cx<'_>, units: &[u16]) -> Result<Value, Raise> {
    cx.st.reserve(units.len() * 2)?;
    builder(cx)?.extend_from_slice(units);
    cx.st.heap.bytes += units.len() * 2;
    Ok(cx.arg(0))
}

fn builder<'c>(cx: &'c mut Cx<'_>) -> Result<&'c mut Vec<u16>, Raise> {
    let handle = cx.handle(0)?;
    match cx.st.heap.get_mut(handle) {
        Some(Obj::Builder(units)) => Ok(units),
        _ => {
            Err(Raise::new("NullReferenceException", "Object reference not set to an instance of an object"))
        }
    }
}

/// Structs are copied when they go into another collection.
pub(super) fn copied(cx: &mut Cx<'_>, mut values: Vec<Value>) -> Vec<Value> {
    if values.iter().any(|v| matches!(v, Value::Ref(_))) {
        for value in &mut values {
            *value = crate::vm::copy(cx.program, cx.st, *value);
        }
    }
    values
}

/// Elements for another collection.
fn copied_elements(cx: &mut Cx<'_>, elements: Elements) -> Elements {
    match elements {
        Elements::Values(values) => copied(cx, values).into(),
        plain => plain,
    }
}

/// What an element of a type begins with.
pub(super) fn first_value(cx: &mut Cx<'_>, element: crate::sema::Ty) -> Value {
    match cx.program.start(element) {
        Start::Value(value) => value,
        Start::Struct(ty) => cx.st.instance(cx.program, ty),
    }
}
