//! Operations that neither jump nor call.

use super::arith;
use super::array::{copy, flat, new_array, overwrite};
use super::heap::{Fields, Obj};
use super::machine::{null_reference, out_of_range};
use super::op::Op;
use super::state::{Raise, State, Stop};
use super::value::{Handle, Value};
use crate::decimal;
use crate::library;
use crate::program::Program;
use crate::sema::{Prim, Ty};

impl State {
    /// Frees what is not reachable any more, when that is due.
    pub(super) fn tidy(&mut self, program: &Program, fi: usize, base: usize) -> Result<(), Raise> {
        if self.heap.bytes <= self.heap.due {
            return Ok(());
        }
        let top = (base + program.funcs[fi].regs as usize).min(self.stack.len());
        self.heap.collect(self.stack[..top].iter().chain(&program.static_values));
        if self.heap.bytes > self.limits.bytes {
            return Err(Raise::Stop(Stop::Bytes(self.limits.bytes)));
        }
        Ok(())
    }
}

/// Does one in the window of a function that begins at `base`.
#[allow(clippy::too_many_lines, reason = "one arm an operation")]
pub(super) fn plain(
    op: Op,
    program: &mut Program,
    st: &mut State,
    fi: usize,
    base: usize,
) -> Result<(), Raise> {
    macro_rules! r {
        ($a:expr) => {
            st.stack[base + $a as usize]
        };
    }
    match op {
        Op::Move { d, a } => r!(d) = r!(a),
        Op::Int { d, v } => r!(d) = Value::I32(v),
        Op::Const { d, k } => {
            r!(d) = program.funcs[fi].consts.get(k as usize).copied().unwrap_or(Value::Null)
        }
        Op::Arith { op, prim, checked, d, a, b } => r!(d) = arith::binary(op, prim, checked, r!(a), r!(b))?,
        Op::Neg { prim, checked, d, a } => r!(d) = arith::negate(prim, checked, r!(a))?,
        Op::Complement { prim, d, a } => {
            let n = r!(a).whole().unwrap_or(0);
            r!(d) = crate::emit::number(crate::bind::wrap(!n, prim), prim);
        }
        Op::Not { d, a } => r!(d) = Value::Bool(r!(a) != Value::Bool(true)),
        Op::Convert { from, to, checked, d, a } => {
            r!(d) = match (to, r!(a)) {
                (Prim::F64, Value::I32(x)) => Value::F64(x.into()),
                (_, value) => arith::convert(from, to, checked, value)?,
            }
        }
        Op::DecimalConst { d, k } => {
            st.tidy(program, fi, base)?;
            let consts = &program.funcs[fi].consts;
            let half = |k: u32| match consts.get(k as usize) {
                Some(Value::U64(bits)) => *bits,
                _ => 0,
            };
            let made = Obj::Decimal(decimal::of_halves(half(k), half(k + 1)));
            r!(d) = Value::Ref(st.heap.add(made));
        }
        Op::Decimals { op, d, a, b } => {
            st.tidy(program, fi, base)?;
            r!(d) = st.decimals(op, r!(a), r!(b))?;
        }
        Op::DecimalNeg { d, a } => {
            st.tidy(program, fi, base)?;
            let x = st.heap.decimal(r!(a)).unwrap_or_default();
            r!(d) = Value::Ref(st.heap.add(Obj::Decimal(decimal::negated(x))));
        }
        Op::DecimalOf { d, a } => {
            st.tidy(program, fi, base)?;
            r!(d) = st.decimal_of(r!(a))?;
        }
        Op::DecimalTo { to, d, a } => r!(d) = st.decimal_to(r!(a), to)?,
        Op::ToEnum { d, a, ty } => r!(d) = Value::Enum(ty, r!(a).whole().unwrap_or(0) as i64),
        Op::FromEnum { d, a, prim } => {
            let n = r!(a).whole().unwrap_or(0);
            r!(d) = crate::emit::number(crate::bind::wrap(n, prim), prim);
        }
        Op::IsNull { d, a } => r!(d) = Value::Bool(matches!(r!(a), Value::Null)),
        Op::Same { d, a, b } => {
            r!(d) = Value::Bool(match (r!(a), r!(b)) {
                (Value::Null, Value::Null) => true,
                (Value::Ref(x), Value::Ref(y)) => x == y,
                _ => false,
            })
        }
        Op::NullCheck { a } => {
            if matches!(r!(a), Value::Null) {
                return Err(null_reference());
            }
        }
        Op::FromNullable { d, a } => {
            if matches!(r!(a), Value::Null) {
                return Err(Raise::new("InvalidOperationException", "Nullable object must have a value."));
            }
            r!(d) = r!(a);
        }
        Op::LoadField { d, o, i } => {
            let Value::Ref(handle) = r!(o) else { return Err(null_reference()) };
            let value = match st.heap.get(handle) {
                Obj::Inst(_, fields) => fields.get(i as usize).copied(),
                _ => None,
            };
            let Some(value) = value else { return Err(null_reference()) };
            r!(d) = value;
        }
        Op::StoreField { o, i, v } => {
            let Value::Ref(handle) = r!(o) else { return Err(null_reference()) };
            let value = r!(v);
            let Some(Obj::Inst(_, fields)) = st.heap.get_mut(handle) else { return Err(null_reference()) };
            if let Some(slot) = fields.get_mut(i as usize) {
                *slot = value;
            }
        }
        Op::LoadStatic { d, s } => {
            r!(d) = program.static_values.get(s as usize).copied().unwrap_or(Value::Null)
        }
        Op::StoreStatic { s, v } => {
            let value = r!(v);
            if let Some(slot) = program.static_values.get_mut(s as usize) {
                *slot = value;
            }
        }
        Op::LoadElem { d, a, i } => {
            let Value::Ref(handle) = r!(a) else { return Err(null_reference()) };
            let Value::I32(index) = r!(i) else { return Err(out_of_range()) };
            let value = match st.heap.get(handle) {
                Obj::Array(_, data, _) => data.get(index as usize),
                _ => None,
            };
            match value {
                Some(value) if index >= 0 => r!(d) = value,
                _ => return Err(out_of_range()),
            }
        }
        Op::StoreElem { a, i, v } => {
            let Value::Ref(handle) = r!(a) else { return Err(null_reference()) };
            let Value::I32(index) = r!(i) else { return Err(out_of_range()) };
            let value = r!(v);
            let stored = match st.heap.get_mut(handle) {
                Some(Obj::Array(_, data, _)) => index >= 0 && data.set(index as usize, value),
                _ => false,
            };
            if !stored {
                return Err(out_of_range());
            }
        }
        Op::LoadElems { d, a, first } => {
            let (handle, at) = flat(st, r!(a), base + first as usize)?;
            if let Obj::Array(_, data, _) = st.heap.get(handle) {
                let value = data.get(at).unwrap_or(Value::Null);
                r!(d) = value;
            }
        }
        Op::StoreElems { a, first, v } => {
            let (handle, at) = flat(st, r!(a), base + first as usize)?;
            let value = r!(v);
            if let Some(Obj::Array(_, data, _)) = st.heap.get_mut(handle) {
                data.set(at, value);
            }
        }
        Op::Length { d, a } => {
            let Value::Ref(handle) = r!(a) else { return Err(null_reference()) };
            let length = match st.heap.get(handle) {
                Obj::Array(_, data, _) => data.len(),
                _ => 0,
            };
            r!(d) = Value::I32(length as i32);
        }
        Op::New { d, ty } => {
            st.tidy(program, fi, base)?;
            r!(d) = st.instance(program, ty);
        }
        Op::Copy { d, a } => {
            st.tidy(program, fi, base)?;
            r!(d) = copy(program, st, r!(a));
        }
        Op::NewArray { d, first, rank, ty } => {
            st.tidy(program, fi, base)?;
            let mut length = 1_usize;
            let mut dims = Vec::new();
            for i in 0..rank {
                let Value::I32(n) = r!(first + i) else { return Err(out_of_range()) };
                if n < 0 {
                    return Err(Raise::new(
                        "OverflowException",
                        "Arithmetic operation resulted in an overflow.",
                    ));
                }
                length = length.saturating_mul(n as usize);
                dims.push(n as u32);
            }
            let dims = if rank > 1 { Some(dims.into_boxed_slice()) } else { None };
            r!(d) = new_array(program, st, ty, length, dims)?;
        }
        Op::ArrayOf { d, first, n, ty } => {
            st.tidy(program, fi, base)?;
            let from = base + first as usize;
            let data = st.stack[from..from + n as usize].to_vec().into();
            r!(d) = Value::Ref(st.heap.add(Obj::Array(ty, data, None)));
        }
        Op::SetDims { a, k } => {
            if let (Value::Ref(handle), Some(Value::I64(n))) =
                (r!(a), program.funcs[fi].consts.get(k as usize).copied())
                && let Some(Obj::Array(_, _, dims)) = st.heap.get_mut(handle)
            {
                let mut list = dims.take().map(<[u32]>::into_vec).unwrap_or_default();
                list.push(n as u32);
                *dims = Some(list.into_boxed_slice());
            }
        }
        Op::NewEnv { d, n, parent } => {
            st.tidy(program, fi, base)?;
            let mut fields = Fields::from_elem(Value::Null, n as usize + 1);
            fields[0] = r!(parent);
            r!(d) = Value::Ref(st.heap.add(Obj::Inst(Ty::NONE, fields)));
        }
        Op::Lambda { d, f, env } => {
            st.tidy(program, fi, base)?;
            let env = r!(env);
            r!(d) = Value::Ref(st.heap.add(Obj::Delegate(Ty::NONE, f, env)));
        }
        Op::SetType { a, ty } => {
            if let Value::Ref(handle) = r!(a)
                && let Some(Obj::Delegate(slot, ..) | Obj::Array(slot, ..)) = st.heap.get_mut(handle)
            {
                *slot = ty;
            }
        }
        Op::Is { d, a, ty } => {
            let value = r!(a);
            let is = !matches!(value, Value::Null) && {
                let from = st.type_of(value, &program.sema);
                from == ty || program.is_subtype(from, ty)
            };
            r!(d) = Value::Bool(is);
        }
        Op::As { d, a, ty } => {
            let value = r!(a);
            let is = !matches!(value, Value::Null) && {
                let from = st.type_of(value, &program.sema);
                from == ty || program.is_subtype(from, ty)
            };
            r!(d) = if is { value } else { Value::Null };
        }
        Op::Cast { d, a, ty } => {
            let value = r!(a);
            if matches!(value, Value::Null) {
                if program.sema.is_value_type(ty) && program.sema.nullable_of(ty).is_none() {
                    return Err(null_reference());
                }
            } else {
                let from = st.type_of(value, &program.sema);
                if from != ty && !program.is_subtype(from, ty) {
                    let enum_of = program.sema.enum_prim(ty).filter(|_| program.sema.is_enum(ty));
                    let fits = enum_of.is_some() && enum_of == program.sema.prim(from);
                    if !fits {
                        return Err(Raise::new("InvalidCastException", "Specified cast is not valid."));
                    }
                    r!(d) = Value::Enum(ty, value.whole().unwrap_or(0) as i64);
                    return Ok(());
                }
            }
            r!(d) = value;
        }
        Op::Concat { d, first, n } => {
            st.tidy(program, fi, base)?;
            let from = base + first as usize;
            let mut units: Vec<u16> = Vec::new();
            for i in 0..n as usize {
                if let Some(text) = st.heap.str(st.stack[from + i]) {
                    units.extend_from_slice(text);
                }
            }
            st.reserve(units.len() * 2)?;
            st.spend(units.len() / 64)?;
            r!(d) = st.heap.text(&units);
        }
        Op::Text { d, a } => {
            let value = r!(a);
            if st.heap.str(value).is_none() {
                st.tidy(program, fi, base)?;
                let text = library::text_of(value, st, &mut program.sema);
                r!(d) = st.text(&text);
            } else {
                r!(d) = value;
            }
        }
        Op::RefLocal { d, a } => r!(d) = Value::StackRef((base + a as usize) as u32),
        Op::RefField { d, o, i } => {
            let Value::Ref(handle) = r!(o) else { return Err(null_reference()) };
            r!(d) = Value::PartRef(handle, i.into());
        }
        Op::RefElem { d, a, i } => {
            let (Value::Ref(handle), Value::I32(index)) = (r!(a), r!(i)) else {
                return Err(null_reference());
            };
            let length = if let Obj::Array(_, data, _) = st.heap.get(handle) { data.len() } else { 0 };
            if index < 0 || index as usize >= length {
                return Err(out_of_range());
            }
            r!(d) = Value::PartRef(handle, index as u32);
        }
        Op::RefElems { d, a, first } => {
            let (handle, at) = flat(st, r!(a), base + first as usize)?;
            r!(d) = Value::PartRef(handle, at as u32);
        }
        Op::RefStatic { d, s } => r!(d) = Value::StaticRef(s),
        Op::LoadRef { d, a } => r!(d) = st.read_ref(r!(a), program),
        Op::StoreRef { a, v } => st.write_ref(r!(a), r!(v), program),
        Op::PutField { o, i, v } => {
            let Value::Ref(handle) = r!(o) else { return Err(null_reference()) };
            let value = r!(v);
            let Obj::Inst(_, fields) = st.heap.get(handle) else { return Err(null_reference()) };
            let Some(there) = fields.get(i as usize).copied() else { return Err(null_reference()) };
            if !overwrite(program, st, there, value)
                && let Some(Obj::Inst(_, fields)) = st.heap.get_mut(handle)
                && let Some(slot) = fields.get_mut(i as usize)
            {
                *slot = value;
            }
        }
        Op::PutStatic { s, v } => {
            let value = r!(v);
            let there = program.static_values.get(s as usize).copied().unwrap_or(Value::Null);
            if !overwrite(program, st, there, value)
                && let Some(slot) = program.static_values.get_mut(s as usize)
            {
                *slot = value;
            }
        }
        Op::PutElem { a, i, v } => {
            let Value::Ref(handle) = r!(a) else { return Err(null_reference()) };
            let Value::I32(index) = r!(i) else { return Err(out_of_range()) };
            let at = usize::try_from(index).map_err(|_| out_of_range())?;
            put_element(program, st, handle, at, r!(v))?;
        }
        Op::PutElems { a, first, v } => {
            let (handle, at) = flat(st, r!(a), base + first as usize)?;
            put_element(program, st, handle, at, r!(v))?;
        }
        Op::PutRef { a, v } => {
            let (reference, value) = (r!(a), r!(v));
            // A variable in a register may hold what an earlier one left there.
            let is_register = matches!(reference, Value::StackRef(_));
            let there = st.read_ref(reference, program);
            if is_register || !overwrite(program, st, there, value) {
                st.write_ref(reference, value, program);
            }
        }
        Op::TypeOf { d, ty } => r!(d) = Value::Ref(st.heap.add(Obj::Type(ty))),
        Op::NotSupported { k } => {
            let what = program.funcs[fi].messages.get(k as usize).cloned().unwrap_or_default();
            return Err(Raise::Stop(Stop::NotSupported(what)));
        }
        _ => return Err(Raise::Stop(Stop::Refused("An operation is not known".to_owned()))),
    }
    Ok(())
}

/// Sets an element that is a struct.
fn put_element(
    program: &Program,
    st: &mut State,
    handle: Handle,
    at: usize,
    value: Value,
) -> Result<(), Raise> {
    let there = match st.heap.get(handle) {
        Obj::Array(_, data, _) => data.get(at),
        _ => None,
    };
    let there = there.ok_or_else(out_of_range)?;
    if !overwrite(program, st, there, value)
        && let Some(Obj::Array(_, data, _)) = st.heap.get_mut(handle)
    {
        data.set(at, value);
    }
    Ok(())
}
