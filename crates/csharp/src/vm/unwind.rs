//! Exceptions: from where they are thrown to who takes them.

use super::heap::{GenState, Obj};
use super::state::{Raise, State};
use super::value::Value;
use crate::program::{Program, Start};
use crate::sema::Ty;

/// The mark of an iterator that is left before its end: only `finally` sees it.
pub(super) const ABANDONED: Value = Value::StaticRef(u32::MAX);

impl State {
    /// A new object of a type, its fields at their first values.
    pub(crate) fn instance(&mut self, program: &mut Program, ty: Ty) -> Value {
        let layout = program.layout(ty);
        let mut fields = super::heap::Fields::with_capacity(layout.fields.len());
        for start in &layout.fields {
            let value = match start {
                Start::Value(value) => *value,
                Start::Struct(inner) => self.instance(program, *inner),
            };
            fields.push(value);
        }
        Value::Ref(self.heap.add(Obj::Inst(ty, fields)))
    }

    /// A struct whose fields are all zero; null for any other type.
    pub(crate) fn default_of(&mut self, program: &mut Program, ty: Ty) -> Value {
        match program.start(ty) {
            Start::Value(value) => value,
            Start::Struct(ty) => self.instance(program, ty),
        }
    }

    /// An exception of the library as an object; its message is its first field.
    pub(crate) fn exception(&mut self, program: &mut Program, name: &str, message: &str) -> Value {
        let found = ["System", "System.Collections.Generic"]
            .iter()
            .find_map(|space| program.sema.library(space, name, 0));
        let ty = match found {
            Some(def) => program.sema.named(def, &[]),
            None => program.sema.known.exception,
        };
        let object = self.instance(program, ty);
        let text = self.text(message);
        if let Value::Ref(handle) = object
            && let Some(Obj::Inst(_, fields)) = self.heap.get_mut(handle)
            && let Some(first) = fields.first_mut()
        {
            *first = text;
        }
        object
    }

    /// Goes to the handler of an exception; false when nobody above `floor` takes it.
    pub(super) fn unwind(&mut self, program: &Program, value: Value, floor: usize) -> bool {
        let mut first = true;
        while self.frames.len() > floor {
            let Some(frame) = self.frames.last_mut() else { return false };
            let function = &program.funcs[frame.func as usize];
            // The operation that threw stands before the counter.
            let at = frame.pc.saturating_sub(1);
            if first && value != ABANDONED {
                self.thrown_at = function.place(at);
            }
            first = false;
            let handler = function
                .handlers
                .iter()
                .find(|h| h.from <= at && at < h.to && (h.finally || value != ABANDONED));
            if let Some(handler) = handler {
                frame.pc = handler.target;
                let slot = frame.base as usize + usize::from(handler.reg);
                self.stack[slot] = value;
                return true;
            }
            if let Some(handle) = frame.gen_
                && let Some(Obj::Gen(generator)) = self.heap.get_mut(handle)
            {
                generator.state = GenState::Done;
            }
            let abandoned_here = value == ABANDONED;
            self.frames.pop();
            if abandoned_here {
                // The iterator is closed; who closed it goes on.
                return self.frames.len() > floor;
            }
        }
        false
    }

    /// An exception of a native function as an object; a stop stays one.
    pub(super) fn object_of(&mut self, program: &mut Program, raise: Raise) -> Result<Value, Raise> {
        match raise {
            Raise::Exception(name, message) => Ok(self.exception(program, name, &message)),
            Raise::Object(value) => Ok(value),
            stop => Err(stop),
        }
    }
}
