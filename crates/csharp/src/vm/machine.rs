//! The loop over operations.

use super::arith;
use super::array::{copy, flat, new_array};
use super::heap::{Fields, GenState, Obj};
use super::native::{native, resume};
use super::op::{Cmp, Op};
use super::start::compiled;
use super::state::{Raise, State, Stop};
use super::value::Value;
use crate::library;
use crate::program::{Program, Target};
use crate::sema::{Prim, Ty};

pub(super) fn null_reference() -> Raise {
    Raise::new("NullReferenceException", "Object reference not set to an instance of an object")
}

pub(super) fn out_of_range() -> Raise {
    Raise::new("IndexOutOfRangeException", "Index was outside the bounds of the array.")
}

fn compare<T: PartialOrd>(cmp: Cmp, a: T, b: T) -> bool {
    match cmp {
        Cmp::Eq => a == b,
        Cmp::Ne => a != b,
        Cmp::Lt => a < b,
        Cmp::Le => a <= b,
        Cmp::Gt => a > b,
        Cmp::Ge => a >= b,
    }
}

#[allow(clippy::too_many_lines, reason = "one arm an operation")]
pub(super) fn execute(program: &mut Program, st: &mut State, floor: usize) -> Result<Value, Raise> {
    let Some(frame) = st.frames.last().copied() else { return Ok(Value::Null) };
    let mut fi = frame.func as usize;
    let mut base = frame.base as usize;
    let mut pc = frame.pc as usize;
    macro_rules! r {
        ($a:expr) => {
            st.stack[base + $a as usize]
        };
    }
    macro_rules! save {
        () => {
            if let Some(frame) = st.frames.last_mut() {
                frame.pc = pc as u32;
            }
        };
    }
    macro_rules! fail {
        ($raise:expr) => {{
            save!();
            return Err($raise);
        }};
    }
    macro_rules! ok {
        ($result:expr) => {
            match $result {
                Ok(value) => value,
                Err(raise) => fail!(raise),
            }
        };
    }
    macro_rules! reload {
        () => {
            if let Some(frame) = st.frames.last() {
                fi = frame.func as usize;
                base = frame.base as usize;
                pc = frame.pc as usize;
            }
        };
    }
    macro_rules! jump {
        ($to:expr) => {{
            let to = $to as usize;
            if to < pc {
                st.fuel -= 1;
                if st.fuel == 0 {
                    ok!(st.turn());
                }
            }
            pc = to;
        }};
    }
    macro_rules! collect {
        () => {
            if st.heap.bytes > st.heap.due {
                let top = base + program.funcs[fi].regs as usize;
                let consts = program.static_values.iter();
                st.heap.collect(st.stack[..top.min(st.stack.len())].iter().chain(consts));
                if st.heap.bytes > st.limits.bytes {
                    fail!(Raise::Stop(Stop::Bytes(st.limits.bytes)));
                }
            }
        };
    }
    macro_rules! enter {
        ($f:expr, $base:expr) => {{
            let f: u32 = $f;
            let at = base + $base as usize;
            st.fuel -= 1;
            if st.fuel == 0 {
                ok!(st.turn());
            }
            if program.funcs[f as usize].code.is_empty() {
                ok!(compiled(program, st, f));
            }
            let function = &program.funcs[f as usize];
            if let Some(ty) = function.generator {
                collect!();
                let params = program.funcs[f as usize].params;
                let made = st.generator(f, ty, at as u32, params);
                st.stack[at] = made;
            } else {
                let regs = function.regs;
                save!();
                st.enter(f, at as u32, regs, None)?;
                fi = f as usize;
                base = at;
                pc = 0;
            }
        }};
    }
    macro_rules! finish {
        ($value:expr) => {{
            let value: Value = $value;
            let Some(frame) = st.frames.pop() else { return Ok(value) };
            if let Some(handle) = frame.gen_ {
                if let Some(Obj::Gen(generator)) = st.heap.get_mut(handle) {
                    generator.state = GenState::Done;
                    generator.regs = Vec::new();
                }
                st.stack[frame.base as usize] = Value::Bool(false);
            } else {
                st.stack[frame.base as usize] = value;
            }
            if st.frames.len() <= floor {
                return Ok(value);
            }
            reload!();
        }};
    }
    loop {
        let Some(op) = program.funcs[fi].code.get(pc).copied() else {
            fail!(Raise::Stop(Stop::Refused("The end of a function was passed".to_owned())))
        };
        pc += 1;
        match op {
            Op::Move { d, a } => r!(d) = r!(a),
            Op::Int { d, v } => r!(d) = Value::I32(v),
            Op::Const { d, k } => {
                r!(d) = program.funcs[fi].consts.get(k as usize).copied().unwrap_or(Value::Null)
            }
            Op::AddI { d, a, b } => {
                if let (Value::I32(x), Value::I32(y)) = (r!(a), r!(b)) {
                    r!(d) = Value::I32(x.wrapping_add(y))
                }
            }
            Op::SubI { d, a, b } => {
                if let (Value::I32(x), Value::I32(y)) = (r!(a), r!(b)) {
                    r!(d) = Value::I32(x.wrapping_sub(y))
                }
            }
            Op::MulI { d, a, b } => {
                if let (Value::I32(x), Value::I32(y)) = (r!(a), r!(b)) {
                    r!(d) = Value::I32(x.wrapping_mul(y))
                }
            }
            Op::AddIK { d, a, k } => {
                if let Value::I32(x) = r!(a) {
                    r!(d) = Value::I32(x.wrapping_add(k))
                }
            }
            Op::AddF { d, a, b } => {
                if let (Value::F64(x), Value::F64(y)) = (r!(a), r!(b)) {
                    r!(d) = Value::F64(x + y)
                }
            }
            Op::SubF { d, a, b } => {
                if let (Value::F64(x), Value::F64(y)) = (r!(a), r!(b)) {
                    r!(d) = Value::F64(x - y)
                }
            }
            Op::MulF { d, a, b } => {
                if let (Value::F64(x), Value::F64(y)) = (r!(a), r!(b)) {
                    r!(d) = Value::F64(x * y)
                }
            }
            Op::DivF { d, a, b } => {
                if let (Value::F64(x), Value::F64(y)) = (r!(a), r!(b)) {
                    r!(d) = Value::F64(x / y)
                }
            }
            Op::Arith { op, prim, checked, d, a, b } => {
                r!(d) = ok!(arith::binary(op, prim, checked, r!(a), r!(b)))
            }
            Op::Neg { prim, checked, d, a } => r!(d) = ok!(arith::negate(prim, checked, r!(a))),
            Op::Complement { prim, d, a } => {
                let n = r!(a).whole().unwrap_or(0);
                r!(d) = crate::emit::number(crate::bind::wrap(!n, prim), prim);
            }
            Op::Not { d, a } => r!(d) = Value::Bool(r!(a) != Value::Bool(true)),
            Op::Convert { from, to, checked, d, a } => {
                r!(d) = match (to, r!(a)) {
                    (Prim::F64, Value::I32(x)) => Value::F64(x.into()),
                    (_, value) => ok!(arith::convert(from, to, checked, value)),
                }
            }
            Op::ToEnum { d, a, ty } => r!(d) = Value::Enum(ty, r!(a).whole().unwrap_or(0) as i64),
            Op::FromEnum { d, a, prim } => {
                let n = r!(a).whole().unwrap_or(0);
                r!(d) = crate::emit::number(crate::bind::wrap(n, prim), prim);
            }
            Op::Jump { to } => jump!(to),
            Op::JumpIf { a, to } => {
                if r!(a) == Value::Bool(true) {
                    jump!(to)
                }
            }
            Op::JumpNot { a, to } => {
                if r!(a) != Value::Bool(true) {
                    jump!(to)
                }
            }
            Op::JumpNull { a, to } => {
                if matches!(r!(a), Value::Null) {
                    jump!(to)
                }
            }
            Op::JumpI { cmp, a, b, to } => {
                if let (Value::I32(x), Value::I32(y)) = (r!(a), r!(b))
                    && compare(cmp, x, y)
                {
                    jump!(to)
                }
            }
            Op::JumpF { cmp, a, b, to } => {
                if let (Value::F64(x), Value::F64(y)) = (r!(a), r!(b))
                    && compare(cmp, x, y)
                {
                    jump!(to)
                }
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
                    fail!(null_reference())
                }
            }
            Op::FromNullable { d, a } => {
                if matches!(r!(a), Value::Null) {
                    fail!(Raise::new("InvalidOperationException", "Nullable object must have a value."));
                }
                r!(d) = r!(a);
            }
            Op::LoadField { d, o, i } => {
                let Value::Ref(handle) = r!(o) else { fail!(null_reference()) };
                let value = match st.heap.get(handle) {
                    Obj::Inst(_, fields) => fields.get(i as usize).copied(),
                    _ => None,
                };
                let Some(value) = value else { fail!(null_reference()) };
                r!(d) = value;
            }
            Op::StoreField { o, i, v } => {
                let Value::Ref(handle) = r!(o) else { fail!(null_reference()) };
                let value = r!(v);
                let Some(Obj::Inst(_, fields)) = st.heap.get_mut(handle) else { fail!(null_reference()) };
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
            Op::Init { i } => {
                if let Some((func, done)) = program.static_inits.get_mut(i as usize)
                    && !*done
                {
                    *done = true;
                    let func = *func;
                    let above = program.funcs[fi].regs;
                    enter!(func, above);
                }
            }
            Op::LoadElem { d, a, i } => {
                let Value::Ref(handle) = r!(a) else { fail!(null_reference()) };
                let Value::I32(index) = r!(i) else { fail!(out_of_range()) };
                let value = match st.heap.get(handle) {
                    Obj::Array(_, data, _) => data.get(index as usize).copied(),
                    _ => None,
                };
                match value {
                    Some(value) if index >= 0 => r!(d) = value,
                    _ => fail!(out_of_range()),
                }
            }
            Op::StoreElem { a, i, v } => {
                let Value::Ref(handle) = r!(a) else { fail!(null_reference()) };
                let Value::I32(index) = r!(i) else { fail!(out_of_range()) };
                let value = r!(v);
                let slot = match st.heap.get_mut(handle) {
                    Some(Obj::Array(_, data, _)) if index >= 0 => data.get_mut(index as usize),
                    _ => None,
                };
                match slot {
                    Some(slot) => *slot = value,
                    None => fail!(out_of_range()),
                }
            }
            Op::LoadElems { d, a, first } => {
                let (handle, at) = ok!(flat(st, r!(a), base + first as usize));
                if let Obj::Array(_, data, _) = st.heap.get(handle) {
                    let value = data.get(at).copied().unwrap_or(Value::Null);
                    r!(d) = value;
                }
            }
            Op::StoreElems { a, first, v } => {
                let (handle, at) = ok!(flat(st, r!(a), base + first as usize));
                let value = r!(v);
                if let Some(Obj::Array(_, data, _)) = st.heap.get_mut(handle)
                    && let Some(slot) = data.get_mut(at)
                {
                    *slot = value;
                }
            }
            Op::Length { d, a } => {
                let Value::Ref(handle) = r!(a) else { fail!(null_reference()) };
                let length = match st.heap.get(handle) {
                    Obj::Array(_, data, _) => data.len(),
                    _ => 0,
                };
                r!(d) = Value::I32(length as i32);
            }
            Op::New { d, ty } => {
                collect!();
                r!(d) = st.instance(program, ty);
            }
            Op::Copy { d, a } => {
                collect!();
                r!(d) = copy(program, st, r!(a));
            }
            Op::NewArray { d, first, rank, ty } => {
                collect!();
                let mut length = 1_usize;
                let mut dims = Vec::new();
                for i in 0..rank {
                    let Value::I32(n) = r!(first + i) else { fail!(out_of_range()) };
                    if n < 0 {
                        fail!(Raise::new(
                            "OverflowException",
                            "Arithmetic operation resulted in an overflow."
                        ));
                    }
                    length = length.saturating_mul(n as usize);
                    dims.push(n as u32);
                }
                let dims = if rank > 1 { Some(dims.into_boxed_slice()) } else { None };
                r!(d) = ok!(new_array(program, st, ty, length, dims));
            }
            Op::ArrayOf { d, first, n, ty } => {
                collect!();
                let from = base + first as usize;
                let data = st.stack[from..from + n as usize].to_vec();
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
                collect!();
                let mut fields = Fields::from_elem(Value::Null, n as usize + 1);
                fields[0] = r!(parent);
                r!(d) = Value::Ref(st.heap.add(Obj::Inst(Ty::NONE, fields)));
            }
            Op::Lambda { d, f, env } => {
                collect!();
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
            Op::Call { f, base: b } => enter!(f, b),
            Op::CallVirtual { site, base: b } => {
                let object = r!(b);
                if matches!(object, Value::Null) {
                    fail!(null_reference());
                }
                let ty = st.type_of(object, &program.sema);
                let found = &program.sites[site as usize].cache;
                let target = if found[0].0 == ty {
                    found[0].1
                } else if found[1].0 == ty {
                    found[1].1
                } else {
                    program.resolve_site(site, ty)
                };
                match target {
                    Target::Function(f) => enter!(f, b),
                    Target::Native(n, ty) => {
                        collect!();
                        ok!(native(program, st, n, base + b as usize, ty));
                    }
                    Target::GenNext => {
                        save!();
                        if ok!(resume(program, st, base + b as usize, false)) {
                            reload!()
                        }
                    }
                    Target::GenDispose => {
                        save!();
                        if ok!(resume(program, st, base + b as usize, true)) {
                            reload!()
                        }
                    }
                    Target::None => {
                        let method = program.sites[site as usize].method.id;
                        let shown = program.sema.show_method(method);
                        fail!(Raise::Stop(Stop::NotSupported(shown)));
                    }
                }
            }
            Op::Dynamic { site, base: b } => {
                let f = ok!(super::dynamic::target(program, st, site, base + b as usize));
                enter!(f, b);
            }
            Op::Native { n, base: b, ty } => {
                collect!();
                ok!(native(program, st, n, base + b as usize, ty));
            }
            Op::Invoke { base: b } => {
                let Value::Ref(handle) = r!(b) else { fail!(null_reference()) };
                let Obj::Delegate(_, f, env) = st.heap.get(handle) else { fail!(null_reference()) };
                let (f, env) = (*f, *env);
                r!(b) = env;
                enter!(f, b);
            }
            Op::GenNext { base: b } => {
                save!();
                if ok!(resume(program, st, base + b as usize, false)) {
                    reload!()
                }
            }
            Op::GenDispose { base: b } => {
                save!();
                if ok!(resume(program, st, base + b as usize, true)) {
                    reload!()
                }
            }
            Op::Return { a } => finish!(r!(a)),
            Op::ReturnVoid => finish!(Value::Null),
            Op::Throw { a } => {
                let value = r!(a);
                if matches!(value, Value::Null) {
                    fail!(null_reference());
                }
                fail!(Raise::Object(value));
            }
            Op::Rethrow { a } => {
                let value = r!(a);
                save!();
                let at = st.thrown_at;
                if !st.unwind(program, value, floor) {
                    return Err(Raise::Object(value));
                }
                st.thrown_at = at;
                reload!();
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
                        fail!(null_reference());
                    }
                } else {
                    let from = st.type_of(value, &program.sema);
                    if from != ty && !program.is_subtype(from, ty) {
                        let enum_of = program.sema.enum_prim(ty).filter(|_| program.sema.is_enum(ty));
                        let fits = enum_of.is_some() && enum_of == program.sema.prim(from);
                        if !fits {
                            fail!(Raise::new("InvalidCastException", "Specified cast is not valid."));
                        }
                        r!(d) = Value::Enum(ty, value.whole().unwrap_or(0) as i64);
                        continue;
                    }
                }
                r!(d) = value;
            }
            Op::Concat { d, first, n } => {
                collect!();
                let from = base + first as usize;
                let mut units: Vec<u16> = Vec::new();
                for i in 0..n as usize {
                    if let Some(text) = st.heap.str(st.stack[from + i]) {
                        units.extend_from_slice(text);
                    }
                }
                ok!(st.reserve(units.len() * 2));
                ok!(st.spend(units.len() / 64));
                r!(d) = st.heap.text(&units);
            }
            Op::Text { d, a } => {
                let value = r!(a);
                if st.heap.str(value).is_none() {
                    collect!();
                    let text = library::text_of(value, st, &mut program.sema);
                    r!(d) = st.text(&text);
                } else {
                    r!(d) = value;
                }
            }
            Op::RefLocal { d, a } => r!(d) = Value::StackRef((base + a as usize) as u32),
            Op::RefField { d, o, i } => {
                let Value::Ref(handle) = r!(o) else { fail!(null_reference()) };
                r!(d) = Value::PartRef(handle, i.into());
            }
            Op::RefElem { d, a, i } => {
                let (Value::Ref(handle), Value::I32(index)) = (r!(a), r!(i)) else { fail!(null_reference()) };
                let length = if let Obj::Array(_, data, _) = st.heap.get(handle) { data.len() } else { 0 };
                if index < 0 || index as usize >= length {
                    fail!(out_of_range());
                }
                r!(d) = Value::PartRef(handle, index as u32);
            }
            Op::RefElems { d, a, first } => {
                let (handle, at) = ok!(flat(st, r!(a), base + first as usize));
                r!(d) = Value::PartRef(handle, at as u32);
            }
            Op::RefStatic { d, s } => r!(d) = Value::StaticRef(s),
            Op::LoadRef { d, a } => r!(d) = st.read_ref(r!(a), program),
            Op::StoreRef { a, v } => st.write_ref(r!(a), r!(v), program),
            Op::TypeOf { d, ty } => r!(d) = Value::Ref(st.heap.add(Obj::Type(ty))),
            Op::Yield { a } => {
                let value = r!(a);
                let Some(frame) = st.frames.pop() else { return Ok(Value::Null) };
                let regs = program.funcs[fi].regs as usize;
                let kept = st.stack[base..base + regs].to_vec();
                if let Some(handle) = frame.gen_
                    && let Some(Obj::Gen(generator)) = st.heap.get_mut(handle)
                {
                    generator.regs = kept;
                    generator.pc = pc as u32;
                    generator.state = GenState::Suspended;
                    generator.current = value;
                }
                st.stack[frame.base as usize] = Value::Bool(true);
                reload!();
            }
            Op::NotSupported { k } => {
                let what = program.funcs[fi].messages.get(k as usize).cloned().unwrap_or_default();
                fail!(Raise::Stop(Stop::NotSupported(what)));
            }
        }
    }
}
