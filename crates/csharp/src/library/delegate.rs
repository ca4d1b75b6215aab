//! Delegates: what is joined in one, and whether two call the same.

use super::{Cx, Native};
use crate::bound::Origin;
use crate::program::Program;
use crate::vm::State;
use crate::vm::heap::Obj;
use crate::vm::value::Value;

/// The first captured variable of a delegate's function.
fn first_captured(env: Value, st: &State) -> Value {
    match env {
        Value::Ref(handle) => match st.heap.get(handle) {
            Obj::Inst(_, fields) => fields.get(1).copied().unwrap_or(Value::Null),
            _ => Value::Null,
        },
        _ => Value::Null,
    }
}

/// The function and the captured variables of a delegate.
fn function(value: Value, st: &State) -> Option<(u32, Value)> {
    match value {
        Value::Ref(handle) => match st.heap.get(handle) {
            Obj::Delegate(_, function, env) => Some((*function, *env)),
            _ => None,
        },
        _ => None,
    }
}

fn origin(program: &Program, function: u32) -> &Origin {
    program.funcs.get(function as usize).map_or(&Origin::Written, |f| &f.origin)
}

/// The delegates that one calls in turn; none of null.
fn parts(value: Value, st: &State, program: &Program) -> Vec<Value> {
    let Some((number, env)) = function(value, st) else { return Vec::new() };
    if !matches!(origin(program, number), Origin::Joined) {
        return vec![value];
    }
    match first_captured(env, st) {
        Value::Ref(list) => match st.heap.get(list) {
            Obj::Array(_, data, _) => data.to_values(),
            _ => Vec::new(),
        },
        _ => Vec::new(),
    }
}

/// Whether two delegates, neither of them joined, call the same method of the same object.
fn same_one(a: Value, b: Value, st: &State, program: &Program) -> bool {
    let (Some((f, x)), Some((g, y))) = (function(a, st), function(b, st)) else { return false };
    match (origin(program, f), origin(program, g)) {
        (Origin::Method(m, has_object), Origin::Method(n, _)) => {
            m == n && (!has_object || first_captured(x, st) == first_captured(y, st))
        }
        _ => f == g && x == y,
    }
}

/// Whether two values are delegates that call the same in the same order, or both null.
pub(super) fn same(a: Value, b: Value, st: &State, program: &Program) -> bool {
    let (a, b) = (parts(a, st, program), parts(b, st, program));
    a.len() == b.len() && a.iter().zip(&b).all(|(a, b)| same_one(*a, *b, st, program))
}

/// The last place where all of some delegates stand in a row among others.
fn last_place(all: &[Value], some: &[Value], st: &State, program: &Program) -> Option<usize> {
    let spare = all.len().checked_sub(some.len())?;
    (0..=spare).rev().find(|at| all[*at..].iter().zip(some).all(|(a, b)| same_one(*a, *b, st, program)))
}

pub(super) fn find(key: &str) -> Option<Native> {
    Some(match key {
        "Delegate.__Join(T,T)" => |cx: &mut Cx<'_>| {
            let mut all = parts(cx.arg(0), cx.st, cx.program);
            all.extend(parts(cx.arg(1), cx.st, cx.program));
            cx.array(cx.ty, all)
        },
        "Delegate.__Without(T,T)" => |cx| {
            let mut all = parts(cx.arg(0), cx.st, cx.program);
            let some = parts(cx.arg(1), cx.st, cx.program);
            if let Some(at) = last_place(&all, &some, cx.st, cx.program) {
                all.drain(at..at + some.len());
            }
            cx.array(cx.ty, all)
        },
        "Delegate.__Same(Object,Object)" | "Delegate.Equals(Object)" => {
            |cx| Ok(Value::Bool(same(cx.arg(0), cx.arg(1), cx.st, cx.program)))
        }
        "Delegate.GetInvocationList()" => |cx| {
            let all = parts(cx.arg(0), cx.st, cx.program);
            let delegate = cx.program.sema.known.delegate;
            cx.array(delegate, all)
        },
        _ => return None,
    })
}
