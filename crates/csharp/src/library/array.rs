//! Arrays and iterators.

use super::list::{copied, first_value};
use super::{Cx, Native, culture};
use crate::sema::{Kind, Ty};
use crate::vm::Raise;
use crate::vm::elements::Elements;
use crate::vm::heap::{GenState, Generator, Obj};
use crate::vm::value::Value;

fn data<'c>(cx: &'c mut Cx<'_>, i: usize) -> Result<&'c mut Elements, Raise> {
    let handle = cx.handle(i)?;
    match cx.st.heap.get_mut(handle) {
        Some(Obj::Array(_, data, _)) => Ok(data),
        _ => {
            Err(Raise::new("NullReferenceException", "Object reference not set to an instance of an object"))
        }
    }
}

fn range() -> Raise {
    Raise::new("IndexOutOfRangeException", "Index was outside the bounds of the array.")
}

fn element_of(cx: &Cx<'_>, i: usize) -> Ty {
    let ty = cx.st.type_of(cx.arg(i), &cx.program.sema);
    match cx.program.sema.types.kind(ty) {
        Kind::Array(element, _) => *element,
        _ => Ty::ERROR,
    }
}

fn get(cx: &mut Cx<'_>) -> Result<Value, Raise> {
    let i = cx.int(1);
    let value = data(cx, 0)?.get(i as usize).ok_or_else(range)?;
    Ok(crate::vm::copy(cx.program, cx.st, value))
}

fn put(cx: &mut Cx<'_>, value: usize, index: usize) -> Result<Value, Raise> {
    let (i, value) = (cx.int(index), cx.arg(value));
    if data(cx, 0)?.set(i as usize, value) { Ok(Value::Null) } else { Err(range()) }
}

pub(super) fn find(key: &str) -> Option<Native> {
    Some(match key {
        "Array.get_Length()" | "ArrayImpl.__Length()" => |cx| Ok(Value::I32(data(cx, 0)?.len() as i32)),
        "Array.get_Rank()" => |cx| {
            let handle = cx.handle(0)?;
            let Obj::Array(_, _, dims) = cx.st.heap.get(handle) else { return Ok(Value::I32(1)) };
            Ok(Value::I32(dims.as_ref().map_or(1, |d| d.len()) as i32))
        },
        "Array.GetLength(Int32)" => |cx| {
            let handle = cx.handle(0)?;
            let i = cx.int(1);
            let Obj::Array(_, data, dims) = cx.st.heap.get(handle) else { return Err(range()) };
            let length = match dims {
                Some(dims) => dims.get(i as usize).copied(),
                None => (i == 0).then_some(data.len() as u32),
            };
            length.map(|n| Value::I32(n as i32)).ok_or_else(range)
        },
        "Array.GetFlat(Int32)" | "ArrayImpl.__Get(Int32)" => get,
        "ArrayImpl.__Set(Int32,T)" => |cx| put(cx, 2, 1),
        "Array.SetValue(Object,Int32)" => |cx| put(cx, 1, 2),
        "Array.Clone()" => |cx| {
            let handle = cx.handle(0)?;
            let Obj::Array(ty, data, dims) = cx.st.heap.get(handle) else { return Ok(Value::Null) };
            let (ty, data, dims) = (*ty, data.clone(), dims.clone());
            cx.st.reserve(data.bytes())?;
            let data = copied_elements(cx, data);
            Ok(Value::Ref(cx.st.heap.add(Obj::Array(ty, data, dims))))
        },
        "Array.Copy(Array,Int32,Array,Int32,Int32)" => |cx| {
            let (from, to, n) = (cx.int(1), cx.int(3), cx.int(4));
            let source = data(cx, 0)?;
            if from < 0 || to < 0 || n < 0 || from as usize + n as usize > source.len() {
                return Err(Raise::new(
                    "ArgumentException",
                    "Source array was not long enough. Check srcIndex and length, and the array's lower bounds.",
                ));
            }
            let part = source.part(from as usize..from as usize + n as usize).ok_or_else(range)?;
            let part = copied_elements(cx, part);
            cx.st.spend(part.len() / 16)?;
            if data(cx, 2)?.put(to as usize, &part) {
                return Ok(Value::Null);
            }
            Err(Raise::new(
                "ArgumentException",
                "Destination array was not long enough. Check destIndex and length, and the array's lower bounds.",
            ))
        },
        "Array.Clear(Array,Int32,Int32)" => |cx| {
            let (start, n) = (cx.int(1), cx.int(2));
            let element = element_of(cx, 0);
            if start < 0 || n < 0 || start as usize + n as usize > data(cx, 0)?.len() {
                return Err(range());
            }
            for i in start..start + n {
                let first = first_value(cx, element);
                data(cx, 0)?.set(i as usize, first);
            }
            Ok(Value::Null)
        },
        "Array.Resize(T[],Int32)" => |cx| {
            let old = cx.read(0);
            let n = cx.int(1);
            if n < 0 {
                return Err(Raise::new("ArgumentOutOfRangeException", "Non-negative number required."));
            }
            let element = cx.ty;
            let mut made = match old {
                Value::Ref(handle) => match cx.st.heap.get(handle) {
                    Obj::Array(_, data, _) => data.to_values(),
                    _ => Vec::new(),
                },
                _ => Vec::new(),
            };
            if made.len() == n as usize && !matches!(old, Value::Null) {
                return Ok(Value::Null);
            }
            cx.st.reserve(n as usize * 16)?;
            cx.st.spend(n as usize / 16)?;
            made.truncate(n as usize);
            // Others may hold the old array still.
            made = copied(cx, made);
            while made.len() < n as usize {
                let first = first_value(cx, element);
                made.push(first);
            }
            let array = cx.array(element, made)?;
            cx.set(0, array);
            Ok(Value::Null)
        },
        "Array.Reverse(Array,Int32,Int32)" => |cx| {
            let (start, n) = (cx.int(1), cx.int(2));
            let start = start.max(0) as usize;
            if data(cx, 0)?.reverse(start..start + n.max(0) as usize) {
                Ok(Value::Null)
            } else {
                Err(range())
            }
        },
        "Sorter.Plain(T[],Int32,Int32)" => |cx| {
            let (start, n) = (cx.int(1).max(0) as usize, cx.int(2).max(0) as usize);
            cx.st.spend(n)?;
            let Some(part) = data(cx, 0)?.part(start..start + n).map(|part| part.to_values()) else {
                return Err(range());
            };
            let sorted = sorted(cx, part);
            let Some(sorted) = sorted else { return Ok(Value::Bool(false)) };
            data(cx, 0)?.put(start, &sorted.into());
            Ok(Value::Bool(true))
        },
        "Iterator.get_Current()" => |cx| {
            let handle = cx.handle(0)?;
            match cx.st.heap.get(handle) {
                Obj::Gen(generator) => Ok(generator.current),
                _ => Ok(Value::Null),
            }
        },
        "Iterator.GetEnumerator()" => |cx| {
            let handle = cx.handle(0)?;
            let Some(Obj::Gen(generator)) = cx.st.heap.get_mut(handle) else { return Ok(Value::Null) };
            if generator.state == GenState::Fresh {
                generator.state = GenState::Taken;
                return Ok(cx.arg(0));
            }
            let again = Generator {
                ty: generator.ty,
                func: generator.func,
                start: generator.start.clone(),
                regs: Vec::new(),
                pc: 0,
                state: GenState::Taken,
                current: Value::Null,
            };
            Ok(Value::Ref(cx.st.heap.add(Obj::Gen(Box::new(again)))))
        },
        _ => return None,
    })
}

/// Structs among the elements are copied.
fn copied_elements(cx: &mut Cx<'_>, elements: Elements) -> Elements {
    match elements {
        Elements::Values(values) => Elements::Values(copied(cx, values)),
        plain => plain,
    }
}

/// Values of one predefined type in order; none where only a comparison written in C# can tell.
fn sorted(cx: &Cx<'_>, mut part: Vec<Value>) -> Option<Vec<Value>> {
    if part.iter().all(|v| matches!(v, Value::F64(_) | Value::F32(_))) {
        // What is not a number comes first.
        part.sort_by(|a, b| {
            let (a, b) = (a.real().unwrap_or(0.0), b.real().unwrap_or(0.0));
            a.partial_cmp(&b).unwrap_or_else(|| b.is_nan().cmp(&a.is_nan()))
        });
        return Some(part);
    }
    if part.iter().all(|v| v.whole().is_some()) {
        part.sort_by_key(|v| v.whole());
        return Some(part);
    }
    if part.iter().all(|v| *v == Value::Null || cx.st.heap.str(*v).is_some()) {
        part.sort_by(|a, b| match (cx.st.heap.str(*a), cx.st.heap.str(*b)) {
            (Some(a), Some(b)) => culture::compare(a, b, false),
            (a, b) => a.is_some().cmp(&b.is_some()),
        });
        return Some(part);
    }
    None
}
