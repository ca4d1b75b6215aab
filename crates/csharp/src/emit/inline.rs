//! Calls of methods that only compute, in place of the call: without a frame, and structs are not copied for them.

use std::collections::HashMap;

use super::quiet::{Quiet, sets_field, statements};
use super::{Emitted, Emitter};
use crate::bound::{Arg, Body, Expr, MethodRef, StmtKind};
use crate::sema::Substitution;
use crate::source::Pos;
use crate::syntax::ast::Passing;
use crate::vm::op::{Op, Reg};

/// How deep they stand in one another at most.
const DEPTH: u32 = 5;
/// From how many operations on a function takes no more of them in.
const LONG: usize = 10_000;

impl Emitter<'_> {
    /// A call in place; false where it must be a call.
    pub(super) fn inline_call(
        &mut self,
        d: Reg,
        receiver: Option<&Expr>,
        method: &MethodRef,
        args: &[Arg],
        e: &Expr,
    ) -> Emitted<bool> {
        let Some(quiet) = self.may_inline(method, args) else { return Ok(false) };
        let body = match quiet {
            Quiet::Getter(field) => {
                let Some(receiver) = receiver else { return Ok(false) };
                let o = self.in_place(receiver)?;
                self.pos = e.pos;
                self.getter(d, o, method, field);
                return Ok(true);
            }
            Quiet::Value(body) => body,
            Quiet::Fields(_) => return Ok(false),
        };
        let list = statements(&body).unwrap_or_default();
        let Some(StmtKind::Return(Some(value))) = list.first().map(|s| &s.kind) else { return Ok(false) };
        let this = match receiver {
            Some(receiver) => Some(self.operand(receiver, args.iter().map(|(_, e)| e))?),
            None => None,
        };
        let regs = self.operand_list(args)?;
        self.pos = e.pos;
        if let Some(receiver) = receiver {
            let ty = self.ty(receiver.ty);
            if !self.program.sema.is_value_type(ty)
                && !matches!(receiver.kind, crate::bound::Kind::This)
                && let Some(a) = this
            {
                self.op(Op::NullCheck { a });
            }
        } else if let Some(i) = self.program.static_init(method.owner) {
            self.op(Op::Init { i });
        }
        self.within(&body, method, this, &regs, |emitter| emitter.copied(value, Some(d)).map(|_| ()))?;
        Ok(true)
    }

    /// A new struct whose constructor sets each field, from its fields at once; false where it must be a call.
    pub(super) fn inline_new(&mut self, d: Reg, method: &MethodRef, args: &[Arg], pos: Pos) -> Emitted<bool> {
        if method.id.0 == u32::MAX {
            return Ok(false);
        }
        let Some(Quiet::Fields(body)) = self.may_inline(method, args) else { return Ok(false) };
        if self.program.static_init(method.owner).is_some() {
            return Ok(false);
        }
        let regs = self.operand_list(args)?;
        let list = statements(&body).unwrap_or_default();
        let ty = method.owner;
        self.program.layout(ty);
        let first = self.allocs(list.len().max(1) as u32)?;
        self.within(&body, method, None, &regs, |emitter| {
            for (field, value) in list.iter().filter_map(|stmt| sets_field(stmt)) {
                let owner = emitter.ty(field.owner);
                let i = emitter.program.field_index(owner, field.id);
                emitter.copied(value, Some(first + i))?;
            }
            Ok(())
        })?;
        self.pos = pos;
        self.op(Op::Build { d, first, n: list.len() as u16, ty });
        Ok(true)
    }

    fn may_inline(&mut self, method: &MethodRef, args: &[Arg]) -> Option<Quiet> {
        if self.inlined >= DEPTH
            || self.f.code.len() > LONG
            || args.iter().any(|(passing, _)| *passing != Passing::Value)
        {
            return None;
        }
        if self.program.too_many_types(method.owner) {
            return None;
        }
        self.program.quiet(method.id)
    }

    fn getter(&mut self, d: Reg, o: Reg, method: &MethodRef, field: crate::sema::FieldId) {
        let i = self.program.field_index(method.owner, field);
        self.op(Op::LoadField { d, o, i });
        let ty = self.program.field_type(method.owner, field);
        if self.program.sema.is_struct(ty) {
            self.program.layout(ty);
            self.op(Op::Copy { d, a: d });
        }
    }

    /// A value for a look at it that does not keep it: structs are not copied out of lists.
    pub(super) fn in_place(&mut self, e: &Expr) -> Emitted<Reg> {
        if self.has_low(0)
            && let Some(item) = self.item_in_place(e)?
        {
            return Ok(item);
        }
        self.expr(e, None)
    }

    /// An operand that others are evaluated after.
    fn operand<'e>(&mut self, e: &Expr, rest: impl Iterator<Item = &'e Expr>) -> Emitted<Reg> {
        if self.rest_is_quiet(rest) {
            return self.in_place(e);
        }
        let d = self.alloc()?;
        self.copied(e, Some(d))
    }

    fn operand_list(&mut self, args: &[Arg]) -> Emitted<Vec<Reg>> {
        let mut regs = Vec::new();
        for (i, (_, arg)) in args.iter().enumerate() {
            regs.push(self.operand(arg, args[i + 1..].iter().map(|(_, e)| e))?);
        }
        Ok(regs)
    }

    /// Emits inside the body of another method, its parameters in these registers.
    fn within(
        &mut self,
        body: &std::sync::Arc<Body>,
        method: &MethodRef,
        this: Option<Reg>,
        regs: &[Reg],
        emit: impl FnOnce(&mut Self) -> Emitted<()>,
    ) -> Emitted<()> {
        let mut by = self.program.sema.substitution(method.owner);
        let params = self.program.sema.method(method.id).type_params.clone();
        by.0.extend(Substitution::of(&params, &method.args).0);
        let own: HashMap<_, _> = body.params.iter().copied().zip(regs.iter().copied()).collect();
        let outer = (
            std::mem::replace(&mut self.body, body.clone()),
            std::mem::replace(&mut self.by, by),
            std::mem::replace(&mut self.regs, own),
            std::mem::take(&mut self.envs),
            std::mem::replace(&mut self.this, this),
            self.pos,
        );
        self.inlined += 1;
        let done = emit(self);
        self.inlined -= 1;
        (self.body, self.by, self.regs, self.envs, self.this, self.pos) = outer;
        done
    }
}
