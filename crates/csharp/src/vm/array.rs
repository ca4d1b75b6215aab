//! Arrays, and copies of structs.

use super::elements::Elements;
use super::heap::{Fields, Obj};
use super::machine::{null_reference, out_of_range};
use super::state::{Raise, State};
use super::value::{Handle, Value};
use crate::program::Program;
use crate::sema::{Kind, Ty};

/// A new array, its elements at their first values.
pub(crate) fn new_array(
    program: &mut Program,
    st: &mut State,
    ty: Ty,
    length: usize,
    dims: Option<Box<[u32]>>,
) -> Result<Value, Raise> {
    st.spend(length / 16)?;
    let element = match program.sema.types.kind(ty) {
        Kind::Array(element, _) => *element,
        _ => Ty::ERROR,
    };
    let data = match program.start(element) {
        crate::program::Start::Value(value) => {
            st.reserve(length.saturating_mul(Elements::width(value)))?;
            Elements::repeated(value, length)
        }
        crate::program::Start::Struct(inner) => {
            st.reserve(length.saturating_mul(96))?;
            Elements::Values((0..length).map(|_| st.instance(program, inner)).collect())
        }
    };
    Ok(Value::Ref(st.heap.add(Obj::Array(ty, data, dims))))
}

/// A copy of a struct, with the structs in it.
pub(crate) fn copy(program: &Program, st: &mut State, value: Value) -> Value {
    let Value::Ref(handle) = value else { return value };
    let Obj::Inst(ty, fields) = st.heap.get(handle) else { return value };
    let ty = *ty;
    let Some(Some(layout)) = program.layouts.get(ty.0 as usize) else { return value };
    if !layout.is_struct {
        return value;
    }
    let mut fields: Fields = fields.clone();
    for i in &layout.structs {
        let at = usize::from(*i);
        if let Some(inner) = fields.get(at).copied() {
            fields[at] = copy(program, st, inner);
        }
    }
    Value::Ref(st.heap.add(Obj::Inst(ty, fields)))
}

/// Gives a struct in its place the fields of another, as deep as structs stand in it; false where what is there is no
/// such struct and has to be replaced.
pub(super) fn overwrite(program: &Program, st: &mut State, there: Value, new: Value) -> bool {
    let (Value::Ref(there), Value::Ref(new)) = (there, new) else { return false };
    if there == new {
        return true;
    }
    let (Obj::Inst(ty, old), Obj::Inst(new_ty, fields)) = (st.heap.get(there), st.heap.get(new)) else {
        return false;
    };
    let Some(Some(layout)) = program.layouts.get(ty.0 as usize) else { return false };
    if ty != new_ty || !layout.is_struct {
        return false;
    }
    let mut fields: Fields = fields.clone();
    if !layout.structs.is_empty() {
        let old: Fields = old.clone();
        for i in &layout.structs {
            let at = usize::from(*i);
            if let (Some(inner), Some(slot)) = (old.get(at), fields.get_mut(at))
                && overwrite(program, st, *inner, *slot)
            {
                *slot = *inner;
            }
        }
    }
    if let Some(Obj::Inst(_, slots)) = st.heap.get_mut(there) {
        *slots = fields;
    }
    true
}

/// The place of an element in an array of several dimensions.
pub(super) fn flat(st: &State, array: Value, first: usize) -> Result<(Handle, usize), Raise> {
    let Value::Ref(handle) = array else { return Err(null_reference()) };
    let Obj::Array(_, _, Some(dims)) = st.heap.get(handle) else { return Err(null_reference()) };
    let mut at = 0_usize;
    for (i, dim) in dims.iter().enumerate() {
        let Value::I32(index) = st.stack[first + i] else { return Err(out_of_range()) };
        if index < 0 || index as u32 >= *dim {
            return Err(out_of_range());
        }
        at = at * *dim as usize + index as usize;
    }
    Ok((handle, at))
}
