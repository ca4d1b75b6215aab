//! Structs in their parts: a variable of a small struct has a register for each field, and no object in the heap (scalar
//! replacement of aggregates, as in S. Muchnick, Advanced Compiler Design and Implementation, 12.2). Where the whole is
//! wanted it is put together: a struct is a value, so nobody can tell the copy from it.

use super::inline::{Operand, Parts};
use super::uses::mentions;
use super::{Emitted, Emitter};
use crate::bound::{Expr, Kind, LocalId};
use crate::program::Start;
use crate::sema::Ty;
use crate::syntax::ast::{Passing, TypeKind};
use crate::vm::op::{Op, Reg};

/// The most fields of a struct in its parts: more of them cost more moves than a copy.
const MOST_FIELDS: usize = 4;
/// Registers up to which variables are split: beyond, operations on low registers would become rare.
const MOST_REGS: u32 = 128;

impl Emitter<'_> {
    /// How many fields a struct has that may stand in its parts: plain values, few of them.
    fn plain_fields(&mut self, ty: Ty) -> Option<u32> {
        if !self.program.sema.is_struct(ty)
            || self.program.sema.type_kind(ty) != Some(TypeKind::Struct)
            || self.program.sema.tuple_parts(ty).is_some()
            || self.program.is_native_type(ty)
            || self.program.too_many_types(ty)
        {
            return None;
        }
        let layout = self.program.layout(ty);
        let is_plain = layout.structs.is_empty() && (1..=MOST_FIELDS).contains(&layout.fields.len());
        is_plain.then_some(layout.fields.len() as u32)
    }

    /// Registers for a struct in its parts; none where it has to be whole.
    pub(super) fn parts_for(&mut self, ty: Ty) -> Emitted<Option<Parts>> {
        let Some(count) = self.plain_fields(ty) else { return Ok(None) };
        if self.next + count > MOST_REGS {
            return Ok(None);
        }
        let first = self.allocs(count)?;
        Ok(Some(Parts { first, count: count as u16, ty }))
    }

    /// Whether a variable may be in its parts: nothing holds a reference to it, and what is called on it is known.
    pub(super) fn may_split(&mut self, local: LocalId) -> bool {
        let body = self.body.clone();
        let Some(info) = body.locals.get(local.0 as usize) else { return false };
        let uses = body.uses();
        !info.captured
            && !info.is_reference
            && info.passing == Passing::Value
            && !uses.whole.contains(&local)
            && uses.called.iter().filter(|(of, _)| *of == local).all(|(_, method)| {
                self.program.quiet(*method).is_some() || self.program.steps(*method).is_some()
            })
    }

    /// Gives a variable registers for its fields; false where it has to be whole.
    pub(super) fn split(&mut self, local: LocalId) -> Emitted<bool> {
        if self.reserved || self.f.generator.is_some() {
            return Ok(false);
        }
        let Some(ty) = self.body.locals.get(local.0 as usize).map(|l| l.ty) else { return Ok(false) };
        let ty = self.ty(ty);
        if self.plain_fields(ty).is_none() || !self.may_split(local) {
            return Ok(false);
        }
        let Some(parts) = self.parts_for(ty)? else { return Ok(false) };
        self.parts.insert(local, parts);
        Ok(true)
    }

    /// The fields of a whole struct into the registers of one in its parts.
    pub(super) fn take_apart(&mut self, to: Parts, whole: Reg) {
        for i in 0..to.count {
            self.op(Op::LoadField { d: to.first + i, o: whole, i });
        }
    }

    /// Sets a struct in its parts.
    pub(super) fn assign_parts(&mut self, to: Parts, place: &Expr, value: &Expr) -> Emitted<()> {
        let is_apart = match place.kind {
            Kind::Local(id) => !mentions(value, id) && !self.sets_locals(value),
            _ => false,
        };
        let kept = self.next;
        self.set_parts(to, value, is_apart)?;
        self.next = kept;
        Ok(())
    }

    /// Sets a struct in its parts to a value made of the old one, which is held under a number.
    pub(super) fn update_parts(&mut self, to: Parts, number: u32, value: &Expr) -> Emitted<()> {
        self.held_parts.insert(number, to);
        let kept = self.next;
        self.set_parts(to, value, false)?;
        self.next = kept;
        Ok(())
    }

    /// `is_apart`: the value does not look at what is set.
    pub(super) fn set_parts(&mut self, to: Parts, value: &Expr, is_apart: bool) -> Emitted<()> {
        match &value.kind {
            Kind::Default(_) => {
                self.default_parts(to);
                return Ok(());
            }
            Kind::Choice(c, a, b) => {
                let (no, end) = (self.mark(), self.mark());
                self.branch(c, no, false)?;
                self.set_parts(to, a, is_apart)?;
                self.jump(end);
                self.set(no);
                self.set_parts(to, b, is_apart)?;
                self.set(end);
                return Ok(());
            }
            _ => {}
        }
        match self.parted(value, is_apart.then_some(to.first))? {
            Some(Operand::Parts(from)) => self.move_parts(to, from),
            Some(Operand::Whole(whole)) => self.take_apart(to, whole),
            None => {
                let whole = self.in_place(value)?;
                self.take_apart(to, whole);
            }
        }
        Ok(())
    }

    pub(super) fn move_parts(&mut self, to: Parts, from: Parts) {
        if to.first != from.first {
            for i in 0..to.count {
                self.op(Op::Move { d: to.first + i, a: from.first + i });
            }
        }
    }

    fn default_parts(&mut self, to: Parts) {
        let layout = self.program.layout(to.ty);
        for (d, start) in (to.first..).zip(&layout.fields) {
            match start {
                Start::Value(crate::vm::value::Value::I32(v)) => self.op(Op::Int { d, v: *v }),
                Start::Value(value) => {
                    let k = self.constant(*value);
                    self.op(Op::Const { d, k });
                }
                // Structs in structs are not in their parts.
                Start::Struct(ty) => self.op(Op::New { d, ty: *ty }),
            }
        }
    }
}
