//! The loop over operations.

use super::arith;
use super::heap::{GenState, Obj};
use super::native::{native, resume};
use super::op::{LOW, Op};
use super::plain::plain;
use super::start::compiled;
use super::state::{Raise, State, Stop};
use super::value::Value;
use crate::bound::Op as BinOp;
use crate::program::{Program, Target};
use crate::sema::Prim;

pub(super) fn null_reference() -> Raise {
    Raise::new("NullReferenceException", "Object reference not set to an instance of an object")
}

pub(super) fn out_of_range() -> Raise {
    Raise::new("IndexOutOfRangeException", "Index was outside the bounds of the array.")
}

/// How the loop is left.
enum Leaves {
    With(Value),
    /// A function is called that is not compiled yet.
    ToCompile(u32),
}

/// Runs until the frames above `floor` are done.
pub(super) fn execute(program: &mut Program, st: &mut State, floor: usize) -> Result<Value, Raise> {
    loop {
        // The loop holds the code itself: it does not change while it runs.
        let code = std::mem::take(&mut program.code);
        let left = operations(&code, program, st, floor);
        program.code = code;
        match left? {
            Leaves::With(value) => return Ok(value),
            Leaves::ToCompile(func) => {
                compiled(program, st, func)?;
                // The operation that calls it is done once more.
                if let Some(frame) = st.frames.last_mut() {
                    frame.pc -= 1;
                }
            }
        }
    }
}

#[allow(clippy::too_many_lines, reason = "one arm an operation")]
fn operations(code: &[Op], program: &mut Program, st: &mut State, floor: usize) -> Result<Leaves, Raise> {
    let Some(frame) = st.frames.last().copied() else { return Ok(Leaves::With(Value::Null)) };
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
    macro_rules! compile_first {
        ($f:expr) => {{
            save!();
            return Ok(Leaves::ToCompile($f));
        }};
    }
    macro_rules! enter {
        ($f:expr, $base:expr) => {{
            let f: u32 = $f;
            let at = base + $base as usize;
            st.fuel -= 1;
            if st.fuel == 0 {
                ok!(st.turn());
            }
            let function = &program.funcs[f as usize];
            let Some(entry) = function.entry else { compile_first!(f) };
            if let Some(ty) = function.generator {
                ok!(st.tidy(program, fi, base));
                let params = program.funcs[f as usize].params;
                let made = st.generator(f, ty, at as u32, params);
                st.stack[at] = made;
            } else {
                let regs = function.regs;
                save!();
                st.enter(f, entry, at as u32, regs, None)?;
                fi = f as usize;
                base = at;
                pc = entry as usize;
            }
        }};
    }
    macro_rules! finish {
        ($value:expr) => {{
            let value: Value = $value;
            let Some(frame) = st.frames.pop() else { return Ok(Leaves::With(value)) };
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
                return Ok(Leaves::With(value));
            }
            reload!();
        }};
    }
    // The low registers: one look at the stack's length for all of them.
    macro_rules! low {
        () => {
            match st.stack.get_mut(base..).and_then(|window| window.first_chunk_mut::<LOW>()) {
                Some(window) => window,
                None => fail!(Raise::Stop(Stop::Depth(st.frames.len()))),
            }
        };
    }
    // Two numbers of the kind that is expected; others as the slow operation has them.
    macro_rules! number {
        ($kind:ident, $op:ident, $prim:ident, $d:expr, $a:expr, $b:expr, ($x:ident, $y:ident) => $result:expr) => {{
            let w = low!();
            if let (Value::$kind($x), Value::$kind($y)) = (w[$a as usize], w[$b as usize]) {
                w[$d as usize] = Value::$kind($result);
            } else {
                r!($d) = ok!(arith::binary(BinOp::$op, Prim::$prim, false, r!($a), r!($b)));
            }
        }};
    }
    macro_rules! jump_if {
        ($kind:ident, $a:expr, $b:expr, $to:expr, ($x:ident, $y:ident) => $holds:expr) => {{
            let w = low!();
            if let (Value::$kind($x), Value::$kind($y)) = (w[$a as usize], w[$b as usize])
                && $holds
            {
                jump!($to)
            }
        }};
    }
    loop {
        let Some(op) = code.get(pc).copied() else {
            fail!(Raise::Stop(Stop::Refused("The end of a function was passed".to_owned())))
        };
        pc += 1;
        match op {
            Op::MoveLow { d, a } => {
                let w = low!();
                w[d as usize] = w[a as usize];
            }
            Op::AddI { d, a, b } => number!(I32, Add, I32, d, a, b, (x, y) => x.wrapping_add(y)),
            Op::SubI { d, a, b } => number!(I32, Sub, I32, d, a, b, (x, y) => x.wrapping_sub(y)),
            Op::MulI { d, a, b } => number!(I32, Mul, I32, d, a, b, (x, y) => x.wrapping_mul(y)),
            Op::AddL { d, a, b } => number!(I64, Add, I64, d, a, b, (x, y) => x.wrapping_add(y)),
            Op::SubL { d, a, b } => number!(I64, Sub, I64, d, a, b, (x, y) => x.wrapping_sub(y)),
            Op::MulL { d, a, b } => number!(I64, Mul, I64, d, a, b, (x, y) => x.wrapping_mul(y)),
            Op::AddF { d, a, b } => number!(F64, Add, F64, d, a, b, (x, y) => x + y),
            Op::SubF { d, a, b } => number!(F64, Sub, F64, d, a, b, (x, y) => x - y),
            Op::MulF { d, a, b } => number!(F64, Mul, F64, d, a, b, (x, y) => x * y),
            Op::DivF { d, a, b } => number!(F64, Div, F64, d, a, b, (x, y) => x / y),
            Op::AddIK { d, a, k } => {
                let w = low!();
                if let Value::I32(x) = w[a as usize] {
                    w[d as usize] = Value::I32(x.wrapping_add(k));
                } else {
                    r!(d) = ok!(arith::binary(BinOp::Add, Prim::I32, false, r!(a), Value::I32(k)));
                }
            }
            Op::ArithI { op, d, a, b } => {
                let w = low!();
                let done = match (w[a as usize], w[b as usize]) {
                    (Value::I32(x), Value::I32(y)) => arith::int(op, x, y),
                    _ => None,
                };
                match done {
                    Some(value) => w[d as usize] = value,
                    None => r!(d) = ok!(arith::binary(op, Prim::I32, false, r!(a), r!(b))),
                }
            }
            Op::Item { d, l, i } => {
                let value = ok!(st.item(r!(l), r!(i)));
                r!(d) = value;
            }
            Op::SetItem { l, i, v } => ok!(st.set_item(r!(l), r!(i), r!(v))),
            Op::AddItem { l, v } => {
                ok!(st.tidy(program, fi, base));
                ok!(st.add_item(r!(l), r!(v)));
            }
            Op::Count { d, l } => r!(d) = ok!(st.count(r!(l))),
            Op::TextLength { d, t } => r!(d) = ok!(st.text_length(r!(t))),
            Op::TextItem { d, t, i } => r!(d) = ok!(st.text_item(r!(t), r!(i))),
            Op::Real { f, d, a } => {
                let w = low!();
                w[d as usize] = Value::F64(f.of(w[a as usize].real().unwrap_or(0.0)));
            }
            Op::Build { d, first, n, ty } => {
                ok!(st.tidy(program, fi, base));
                let from = base + first as usize;
                let fields = st.stack.get(from..from + n as usize).unwrap_or(&[]).into();
                r!(d) = Value::Ref(st.heap.add(Obj::Inst(ty, fields)));
            }
            Op::IntToReal { d, a } => {
                let w = low!();
                w[d as usize] = match w[a as usize] {
                    Value::I32(x) => Value::F64(x.into()),
                    value => ok!(arith::convert(Prim::I32, Prim::F64, false, value)),
                }
            }
            Op::IntToLong { d, a } => {
                let w = low!();
                w[d as usize] = match w[a as usize] {
                    Value::I32(x) => Value::I64(x.into()),
                    value => ok!(arith::convert(Prim::I32, Prim::I64, false, value)),
                }
            }
            Op::LongToInt { d, a } => {
                let w = low!();
                w[d as usize] = match w[a as usize] {
                    Value::I64(x) => Value::I32(x as i32),
                    value => ok!(arith::convert(Prim::I64, Prim::I32, false, value)),
                }
            }
            Op::StepLtI { a, k, b, to } => {
                let w = low!();
                if let (Value::I32(x), Value::I32(y)) = (w[a as usize], w[b as usize]) {
                    let x = x.wrapping_add(k.into());
                    w[a as usize] = Value::I32(x);
                    if x < y {
                        jump!(to)
                    }
                }
            }
            Op::JumpLtI { a, b, to } => jump_if!(I32, a, b, to, (x, y) => x < y),
            Op::JumpI { cmp, a, b, to } => jump_if!(I32, a, b, to, (x, y) => cmp.holds(x, y)),
            Op::JumpL { cmp, a, b, to } => jump_if!(I64, a, b, to, (x, y) => cmp.holds(x, y)),
            Op::JumpF { cmp, a, b, to } => jump_if!(F64, a, b, to, (x, y) => cmp.holds(x, y)),
            Op::JumpIK { cmp, a, k, to } => {
                let w = low!();
                if let Value::I32(x) = w[a as usize]
                    && cmp.holds(x, k)
                {
                    jump!(to)
                }
            }
            Op::JumpCmp { cmp, prim, a, b, to } => {
                let holds = match (prim, r!(a), r!(b)) {
                    (_, Value::F64(x), Value::F64(y)) => cmp.holds(x, y),
                    (_, x, y) => x.whole().zip(y.whole()).is_some_and(|(x, y)| cmp.holds(x, y)),
                };
                if holds {
                    jump!(to)
                }
            }
            Op::LoadFieldLow { d, o, i } => {
                let w = low!();
                let Value::Ref(handle) = w[o as usize] else { fail!(null_reference()) };
                match st.heap.get(handle) {
                    Obj::Inst(_, fields) if (i as usize) < fields.len() => w[d as usize] = fields[i as usize],
                    _ => fail!(null_reference()),
                }
            }
            Op::StoreFieldLow { o, i, v } => {
                let w = low!();
                let Value::Ref(handle) = w[o as usize] else { fail!(null_reference()) };
                let value = w[v as usize];
                match st.heap.get_mut(handle) {
                    Some(Obj::Inst(_, fields)) if (i as usize) < fields.len() => fields[i as usize] = value,
                    _ => fail!(null_reference()),
                }
            }
            Op::LoadElemLow { d, a, i } => {
                let w = low!();
                let Value::Ref(handle) = w[a as usize] else { fail!(null_reference()) };
                let Value::I32(index) = w[i as usize] else { fail!(out_of_range()) };
                let value = match st.heap.get(handle) {
                    Obj::Array(_, data, _) => data.get(index as usize),
                    _ => None,
                };
                match value {
                    Some(value) => w[d as usize] = value,
                    None => fail!(out_of_range()),
                }
            }
            Op::StoreElemLow { a, i, v } => {
                let w = low!();
                let Value::Ref(handle) = w[a as usize] else { fail!(null_reference()) };
                let Value::I32(index) = w[i as usize] else { fail!(out_of_range()) };
                let value = w[v as usize];
                let stored = match st.heap.get_mut(handle) {
                    Some(Obj::Array(_, data, _)) => data.set(index as usize, value),
                    _ => false,
                };
                if !stored {
                    fail!(out_of_range())
                }
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
            Op::Init { i } => {
                if let Some((func, done)) = program.static_inits.get(i as usize)
                    && !*done
                {
                    let func = *func;
                    if program.funcs[func as usize].entry.is_none() {
                        compile_first!(func)
                    }
                    program.static_inits[i as usize].1 = true;
                    let above = program.funcs[fi].regs;
                    enter!(func, above);
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
                        ok!(st.tidy(program, fi, base));
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
                ok!(st.tidy(program, fi, base));
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
            Op::Yield { a } => {
                let value = r!(a);
                let Some(frame) = st.frames.pop() else { return Ok(Leaves::With(Value::Null)) };
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
            other => ok!(plain(other, program, st, fi, base)),
        }
    }
}
