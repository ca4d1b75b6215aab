//! Calls out of the loop: functions of the library and the host, and iterators that go on.

use super::heap::{GenState, Obj};
use super::machine::null_reference;
use super::state::{Raise, State, Stop};
use super::unwind::ABANDONED;
use super::value::Value;
use crate::library::Cx;
use crate::program::{NativeKind, Program};
use crate::sema::Ty;

/// Calls what the library or the host does; the result goes into the first register of the window.
pub(super) fn native(program: &mut Program, st: &mut State, n: u32, at: usize, ty: Ty) -> Result<(), Raise> {
    let Some(found) = program.natives.get(n as usize) else { return Ok(()) };
    let (kind, count, references) = (found.kind, usize::from(found.params), found.references);
    let mut cx = Cx { st, program, at, count, references, ty };
    let value = match kind {
        NativeKind::Library(function) => function(&mut cx)?,
        NativeKind::Host(member) => {
            let mut host = std::mem::replace(&mut cx.st.host, Box::new(crate::host::Printing::default()));
            let result = host.call(member, &mut cx);
            cx.st.host = host;
            result?
        }
        NativeKind::Missing => {
            let key = program.natives[n as usize].key.to_string();
            return Err(Raise::Stop(Stop::NotSupported(key)));
        }
    };
    st.stack[at] = value;
    Ok(())
}

/// Goes on with an iterator, or closes it; true when a frame was entered.
pub(super) fn resume(program: &mut Program, st: &mut State, at: usize, close: bool) -> Result<bool, Raise> {
    let Value::Ref(handle) = st.stack[at] else { return Err(null_reference()) };
    let Some(Obj::Gen(generator)) = st.heap.get_mut(handle) else {
        st.stack[at] = Value::Null;
        return Ok(false);
    };
    let func = generator.func;
    match generator.state {
        GenState::Done | GenState::Running => {
            st.stack[at] = Value::Bool(false);
            return Ok(false);
        }
        GenState::Fresh | GenState::Taken if close => {
            generator.state = GenState::Done;
            return Ok(false);
        }
        _ => {}
    }
    let begun = generator.state == GenState::Suspended;
    let regs = if begun { std::mem::take(&mut generator.regs) } else { generator.start.clone() };
    let pc = generator.pc;
    generator.state = GenState::Running;
    let needed = program.funcs[func as usize].regs.max(regs.len() as u32) + 1;
    st.fuel -= 1;
    if st.fuel == 0 {
        st.turn()?;
    }
    let entry = program.funcs[func as usize].entry.unwrap_or_default();
    st.enter(func, if begun { pc } else { entry }, at as u32, needed, Some(handle))?;
    st.stack[at..at + regs.len()].copy_from_slice(&regs);
    if close {
        let floor = st.frames.len() - 1;
        // The operation behind the `yield` was next: its range is that of the `yield` itself.
        let entered = st.unwind(program, ABANDONED, floor);
        if !entered {
            st.stack[at] = Value::Null;
        }
        return Ok(entered);
    }
    Ok(true)
}
