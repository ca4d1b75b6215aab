//! Calls, iterators, and references to variables.

use super::array::overwrite;
use super::heap::{GenState, Generator, Obj};
use super::op::LOW;
use super::state::{FUEL, Frame, Raise, State, Stop};
use super::value::{Handle, Value};
use crate::program::Program;
use crate::sema::Ty;

impl State {
    /// A turn of a loop or a call: every so often limits are looked at.
    pub(super) fn turn(&mut self) -> Result<(), Raise> {
        self.fuel = FUEL;
        self.spend(FUEL as usize)?;
        if self.host.cancelled() {
            return Err(Raise::Stop(Stop::Cancelled));
        }
        Ok(())
    }

    /// Makes room for a function's registers.
    pub(super) fn enter(
        &mut self,
        func: u32,
        pc: u32,
        base: u32,
        regs: u32,
        gen_: Option<Handle>,
    ) -> Result<(), Raise> {
        if self.frames.len() >= self.limits.depth {
            return Err(Raise::Stop(Stop::Depth(self.limits.depth)));
        }
        // Low registers are all there, whether used or not.
        let top = base as usize + (regs as usize).max(LOW);
        if top > self.stack.len() {
            if top > 4_000_000 {
                return Err(Raise::Stop(Stop::Depth(self.frames.len())));
            }
            self.stack.resize((top * 2).min(4_000_064), Value::Null);
        }
        self.frames.push(Frame { func, pc, base, gen_ });
        Ok(())
    }

    pub(super) fn read_ref(&self, reference: Value, program: &Program) -> Value {
        match reference {
            Value::StackRef(at) => self.stack.get(at as usize).copied().unwrap_or(Value::Null),
            Value::StaticRef(at) => program.static_values.get(at as usize).copied().unwrap_or(Value::Null),
            Value::PartRef(handle, i) => match self.heap.get(handle) {
                Obj::Inst(_, fields) => fields.get(i as usize).copied().unwrap_or(Value::Null),
                Obj::Array(_, data, _) => data.get(i as usize).unwrap_or(Value::Null),
                _ => Value::Null,
            },
            // The object itself, inside a struct.
            other => other,
        }
    }

    pub(super) fn write_ref(&mut self, reference: Value, value: Value, program: &mut Program) {
        match reference {
            Value::StackRef(at) => {
                if let Some(slot) = self.stack.get_mut(at as usize) {
                    *slot = value;
                }
            }
            Value::StaticRef(at) => {
                if let Some(slot) = program.static_values.get_mut(at as usize) {
                    *slot = value;
                }
            }
            Value::PartRef(handle, i) => match self.heap.get_mut(handle) {
                Some(Obj::Inst(_, fields)) => {
                    if let Some(slot) = fields.get_mut(i as usize) {
                        *slot = value;
                    }
                }
                Some(Obj::Array(_, data, _)) => {
                    data.set(i as usize, value);
                }
                _ => {}
            },
            // `this = other` in a struct: its fields become those of the other.
            Value::Ref(_) => {
                overwrite(program, self, reference, value);
            }
            _ => {}
        }
    }

    /// An iterator over a function that has not begun.
    pub(super) fn generator(&mut self, func: u32, ty: Ty, base: u32, params: u32) -> Value {
        let from = base as usize;
        let start: Vec<_> = self.stack.get(from..from + params as usize).unwrap_or(&[]).to_vec();
        let generator = Generator {
            ty,
            func,
            start,
            regs: Vec::new(),
            pc: 0,
            state: GenState::Fresh,
            current: Value::Null,
        };
        Value::Ref(self.heap.add(Obj::Gen(Box::new(generator))))
    }
}

impl State {
    pub(crate) fn write(&mut self, reference: Value, value: Value, program: &mut Program) {
        self.write_ref(reference, value, program);
    }

    pub(crate) fn read(&self, reference: Value, program: &Program) -> Value {
        self.read_ref(reference, program)
    }
}
