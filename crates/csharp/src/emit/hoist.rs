//! Constants of loops in registers of their own: they are set once before the outermost loop, not in each turn.

use super::{Emitted, Emitter, Mark};
use crate::vm::op::{Op, Reg};
use crate::vm::value::Value;

/// How many constants a loop may have in registers.
const MOST: u32 = 12;

/// The registers of an outermost loop, and what stands in those that are taken.
#[derive(Debug)]
pub(super) struct Hoisted {
    first: Reg,
    values: Vec<Value>,
}

/// Equal to the last bit: zero is not minus zero.
fn same(a: Value, b: Value) -> bool {
    match (a, b) {
        (Value::F64(x), Value::F64(y)) => x.to_bits() == y.to_bits(),
        (Value::F32(x), Value::F32(y)) => x.to_bits() == y.to_bits(),
        (a, b) => a == b,
    }
}

impl Emitter<'_> {
    /// The register of a number, where a loop is around.
    pub(super) fn hoisted(&mut self, value: Value) -> Option<Reg> {
        let own = self.hoisted.as_mut()?;
        let known = own.values.iter().position(|other| same(*other, value));
        let at = match known {
            Some(at) => at,
            None if own.values.len() < MOST as usize => {
                own.values.push(value);
                own.values.len() - 1
            }
            None => return None,
        };
        Some(own.first + at as Reg)
    }

    /// Emits a loop: what it needs is known when it is done, so it is set behind it, and the beginning jumps there.
    pub(super) fn with_hoisted(&mut self, emit: impl FnOnce(&mut Self) -> Emitted<()>) -> Emitted<()> {
        // A jump into a loop would pass by what is set before it.
        if self.hoisted.is_some() || self.reserved {
            return emit(self);
        }
        let first = self.allocs(MOST)?;
        self.hoisted = Some(Hoisted { first, values: Vec::new() });
        let (before, begin) = (self.mark(), self.mark());
        self.jump(before);
        self.set(begin);
        emit(self)?;
        let values = self.hoisted.take().map(|own| own.values).unwrap_or_default();
        self.set_before(before, begin, first, values);
        Ok(())
    }

    fn set_before(&mut self, before: Mark, begin: Mark, first: Reg, values: Vec<Value>) {
        if values.is_empty() {
            self.same_place(before, begin);
            return;
        }
        let end = self.mark();
        self.jump(end);
        self.set(before);
        for (i, value) in values.into_iter().enumerate() {
            let d = first + i as Reg;
            match value {
                Value::I32(v) => self.op(Op::Int { d, v }),
                value => {
                    let k = self.constant(value);
                    self.op(Op::Const { d, k });
                }
            }
        }
        self.jump(begin);
        self.set(end);
    }
}
