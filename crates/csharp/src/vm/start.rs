//! The beginning and the end of a run.

use super::machine::execute;
use super::state::{Raise, State, Stop};
use super::value::Value;
use crate::program::Program;

/// How an uncaught exception or a stop ends a run: what it was and where.
#[derive(Debug)]
pub(crate) struct Ended {
    pub(crate) raise: Raise,
    pub(crate) at: u32,
}

/// Runs a function with arguments to its end.
pub(crate) fn run(program: &mut Program, st: &mut State, func: u32, args: &[Value]) -> Result<Value, Ended> {
    let floor = st.frames.len();
    let base = 0_u32;
    let needed = program.funcs.get(func as usize).map_or(0, |f| f.regs).max(args.len() as u32) + 1;
    let begun = compiled(program, st, func).and_then(|()| {
        let regs = program.funcs[func as usize].regs.max(needed);
        let entry = program.funcs[func as usize].entry.unwrap_or_default();
        st.enter(func, entry, base, regs, None)
    });
    if let Err(raise) = begun {
        return Err(Ended { raise, at: st.thrown_at });
    }
    for (i, arg) in args.iter().enumerate() {
        st.stack[base as usize + i] = *arg;
    }
    loop {
        match execute(program, st, floor) {
            Ok(value) => return Ok(value),
            Err(raise) => {
                let at = st
                    .frames
                    .last()
                    .map_or(st.thrown_at, |f| program.funcs[f.func as usize].place(f.pc.saturating_sub(1)));
                let value = match st.object_of(program, raise) {
                    Ok(value) => value,
                    Err(stop) => {
                        st.frames.truncate(floor);
                        return Err(Ended { raise: stop, at });
                    }
                };
                st.thrown_at = at;
                if !st.unwind(program, value, floor) {
                    st.frames.truncate(floor);
                    return Err(Ended { raise: Raise::Object(value), at: st.thrown_at });
                }
            }
        }
    }
}

/// Compiles a function if that has not been done.
pub(super) fn compiled(program: &mut Program, st: &mut State, func: u32) -> Result<(), Raise> {
    if program.funcs.get(func as usize).is_some_and(|f| f.entry.is_none()) {
        let heap = &mut st.heap;
        let mut add = |units: &[u16]| {
            let value = heap.text(units);
            if let Value::Ref(handle) = value {
                heap.pins.push(handle);
            }
            value
        };
        crate::emit::compile(program, func, &mut add).map_err(|refused| {
            st.thrown_at = refused.0;
            Raise::Stop(Stop::Refused(refused.1))
        })?;
    }
    Ok(())
}
