//! Calls of methods that only compute, in place of the call: without a frame, and structs are not copied for them.

use std::collections::HashMap;

use super::quiet::{Quiet, sets_field, statements};
use super::{Emitted, Emitter};
use crate::bound::{Arg, Body, Expr, Kind, MethodRef, StmtKind};
use crate::sema::{Substitution, Ty};
use crate::source::Pos;
use crate::syntax::ast::Passing;
use crate::vm::op::{Op, Reg};

/// How deep they stand in one another at most.
const DEPTH: u32 = 5;
/// From how many operations on a function takes no more of them in.
const LONG: usize = 10_000;

/// A struct whose fields stand in registers in a row.
#[derive(Debug, Clone, Copy)]
pub(super) struct Parts {
    pub(super) first: Reg,
    pub(super) count: u16,
    pub(super) ty: Ty,
}

/// What stands for a parameter.
#[derive(Debug, Clone, Copy)]
pub(super) enum Operand {
    Whole(Reg),
    Parts(Parts),
}

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
                if let Some(part) = self.part_of(receiver, method.owner, field) {
                    self.op(Op::Move { d, a: part });
                    return Ok(true);
                }
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
        let (this, regs) = self.given(receiver, method, args, e)?;
        self.within(&body, method, this, &regs, |emitter| emitter.copied(value, Some(d)).map(|_| ()))?;
        Ok(true)
    }

    /// The object and the arguments of a call in place.
    fn given(
        &mut self,
        receiver: Option<&Expr>,
        method: &MethodRef,
        args: &[Arg],
        e: &Expr,
    ) -> Emitted<(Option<Operand>, Vec<Operand>)> {
        let is_variable = receiver.is_some_and(|receiver| self.is_struct_variable(receiver));
        let (this, regs) = match receiver {
            Some(receiver) if is_variable => {
                let regs = self.operand_list(args)?;
                (Some(self.operand(receiver, std::iter::empty())?), regs)
            }
            // A struct in a field or an element is looked at where it is, after the arguments.
            Some(receiver)
                if matches!(receiver.kind, Kind::Field(..) | Kind::Element(..) | Kind::Deref(_))
                    && self.is_a_struct(receiver)
                    && !self.rest_is_quiet(args.iter().map(|(_, e)| e)) =>
            {
                let this = self.fresh(receiver)?;
                (Some(Operand::Whole(this)), self.operand_list(args)?)
            }
            Some(receiver) => {
                let this = self.operand(receiver, args.iter().map(|(_, e)| e))?;
                (Some(this), self.operand_list(args)?)
            }
            None => (None, self.operand_list(args)?),
        };
        self.pos = e.pos;
        if let Some(receiver) = receiver {
            let ty = self.ty(receiver.ty);
            if !self.program.sema.is_value_type(ty)
                && !matches!(receiver.kind, Kind::This)
                && let Some(Operand::Whole(a)) = this
            {
                self.op(Op::NullCheck { a });
            }
        } else if let Some(i) = self.program.static_init(method.owner) {
            self.op(Op::Init { i });
        }
        Ok((this, regs))
    }

    fn is_a_struct(&mut self, e: &Expr) -> bool {
        let ty = self.ty(e.ty);
        self.program.sema.is_struct(ty)
    }

    /// A new struct whose constructor sets each field, from its fields at once; false where it must be a call.
    pub(super) fn inline_new(&mut self, d: Reg, method: &MethodRef, args: &[Arg], pos: Pos) -> Emitted<bool> {
        let Some(parts) = self.new_parts(method, args, None)? else { return Ok(false) };
        self.pos = pos;
        self.build(d, parts);
        Ok(true)
    }

    pub(super) fn build(&mut self, d: Reg, parts: Parts) {
        self.op(Op::Build { d, first: parts.first, n: parts.count, ty: parts.ty });
    }

    /// The fields of a new struct; none where its constructor must be called.
    fn new_parts(&mut self, method: &MethodRef, args: &[Arg], want: Option<Reg>) -> Emitted<Option<Parts>> {
        if method.id.0 == u32::MAX {
            return Ok(None);
        }
        let Some(Quiet::Fields(body)) = self.may_inline(method, args) else { return Ok(None) };
        if self.program.static_init(method.owner).is_some() {
            return Ok(None);
        }
        let regs = self.operand_list(args)?;
        let list = statements(&body).unwrap_or_default();
        let ty = method.owner;
        self.program.layout(ty);
        let first = match want {
            Some(first) => first,
            None => self.allocs(list.len().max(1) as u32)?,
        };
        self.within(&body, method, None, &regs, |emitter| {
            for (field, value) in list.iter().filter_map(|stmt| sets_field(stmt)) {
                let owner = emitter.ty(field.owner);
                let i = emitter.program.field_index(owner, field.id);
                emitter.copied(value, Some(first + i))?;
            }
            Ok(())
        })?;
        Ok(Some(Parts { first, count: list.len() as u16, ty }))
    }

    /// The struct behind a parameter, or the object itself, where its fields stand in registers.
    pub(super) fn parts_of(&self, e: &Expr) -> Option<Parts> {
        match &e.kind {
            Kind::Local(id) => self.parts.get(id).copied(),
            Kind::Held(number) => self.held_parts.get(number).copied(),
            Kind::This => self.this_parts,
            _ => None,
        }
    }

    /// The register of a field of such a struct.
    pub(super) fn part_of(&mut self, of: &Expr, owner: Ty, field: crate::sema::FieldId) -> Option<Reg> {
        let parts = self.parts_of(of)?;
        Some(parts.first + self.program.field_index(owner, field))
    }

    /// The register that a field of a struct in its parts is.
    pub(super) fn part_there(&mut self, e: &Expr) -> Option<Reg> {
        let Kind::Field(Some(of), field) = &e.kind else { return None };
        self.parts_of(of)?;
        let owner = self.ty(field.owner);
        self.part_of(of, owner, field.id)
    }

    /// A struct that an expression makes, in its parts where it can be; none where nothing was emitted. A new one goes into
    /// the registers from `want` on, where they are given.
    pub(super) fn parted(&mut self, e: &Expr, want: Option<Reg>) -> Emitted<Option<Operand>> {
        match &e.kind {
            Kind::Local(_) | Kind::This | Kind::Held(_) => Ok(self.parts_of(e).map(Operand::Parts)),
            Kind::New(method, args) => {
                let method = self.method_ref(method);
                Ok(self.new_parts(&method, args, want)?.map(Operand::Parts))
            }
            Kind::Call(receiver, method, args, is_virtual) => {
                let (mut method, mut is_virtual) = (self.method_ref(method), *is_virtual);
                if let Some(receiver) = receiver {
                    let ty = self.ty(receiver.ty);
                    self.settle(ty, &mut method, &mut is_virtual);
                }
                if is_virtual {
                    return Ok(None);
                }
                let Some(Quiet::Value(body)) = self.may_inline(&method, args) else { return Ok(None) };
                let list = statements(&body).unwrap_or_default();
                let Some(StmtKind::Return(Some(value))) = list.first().map(|s| &s.kind) else {
                    return Ok(None);
                };
                let (this, regs) = self.given(receiver.as_deref(), &method, args, e)?;
                let made = self.within(&body, &method, this, &regs, |emitter| {
                    match emitter.parted(value, want)? {
                        Some(made) => Ok(made),
                        None => {
                            let d = emitter.alloc()?;
                            emitter.copied(value, Some(d)).map(Operand::Whole)
                        }
                    }
                })?;
                Ok(Some(made))
            }
            _ => Ok(None),
        }
    }

    fn may_inline(&mut self, method: &MethodRef, args: &[Arg]) -> Option<Quiet> {
        if self.takes_more(method, args) { self.program.quiet(method.id) } else { None }
    }

    /// Whether a method may stand in place of its call here.
    pub(super) fn takes_more(&self, method: &MethodRef, args: &[Arg]) -> bool {
        self.inlined < DEPTH
            && self.f.code.len() <= LONG
            && args.iter().all(|(passing, _)| *passing == Passing::Value)
            && !self.program.too_many_types(method.owner)
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
    fn operand<'e>(&mut self, e: &Expr, rest: impl Iterator<Item = &'e Expr>) -> Emitted<Operand> {
        let ty = self.ty(e.ty);
        let is_quiet = self.rest_is_quiet(rest);
        if self.program.sema.is_struct(ty)
            && let Some(made) = self.parted(e, None)?
        {
            // What comes after may change the variable that these are the parts of.
            return match made {
                Operand::Parts(parts) if !is_quiet => {
                    let own = Parts { first: self.allocs(parts.count.into())?, ..parts };
                    self.move_parts(own, parts);
                    Ok(Operand::Parts(own))
                }
                made => Ok(made),
            };
        }
        if is_quiet {
            return self.in_place(e).map(Operand::Whole);
        }
        let d = self.alloc()?;
        self.copied(e, Some(d)).map(Operand::Whole)
    }

    fn operand_list(&mut self, args: &[Arg]) -> Emitted<Vec<Operand>> {
        let mut regs = Vec::new();
        for (i, (_, arg)) in args.iter().enumerate() {
            regs.push(self.operand(arg, args[i + 1..].iter().map(|(_, e)| e))?);
        }
        Ok(regs)
    }

    /// Emits inside the body of another method, its object and its parameters as they were given.
    pub(super) fn within<T>(
        &mut self,
        body: &std::sync::Arc<Body>,
        method: &MethodRef,
        this: Option<Operand>,
        given: &[Operand],
        emit: impl FnOnce(&mut Self) -> Emitted<T>,
    ) -> Emitted<T> {
        let mut by = self.program.sema.substitution(method.owner);
        let params = self.program.sema.method(method.id).type_params.clone();
        by.0.extend(Substitution::of(&params, &method.args).0);
        let (mut regs, mut parts) = (HashMap::new(), HashMap::new());
        for (param, operand) in body.params.iter().zip(given) {
            match operand {
                Operand::Whole(reg) => {
                    regs.insert(*param, *reg);
                }
                Operand::Parts(own) => {
                    parts.insert(*param, *own);
                }
            }
        }
        let (whole, this_parts) = match this {
            Some(Operand::Whole(reg)) => (Some(reg), None),
            Some(Operand::Parts(own)) => (None, Some(own)),
            None => (None, None),
        };
        let outer = (
            std::mem::replace(&mut self.body, body.clone()),
            std::mem::replace(&mut self.by, by),
            std::mem::replace(&mut self.regs, regs),
            std::mem::replace(&mut self.parts, parts),
            std::mem::take(&mut self.envs),
            std::mem::replace(&mut self.this, whole),
            std::mem::replace(&mut self.this_parts, this_parts),
            self.pos,
        );
        let around = (
            std::mem::replace(&mut self.fixed, body.params.clone()),
            std::mem::take(&mut self.held),
            std::mem::take(&mut self.held_parts),
            std::mem::take(&mut self.reserved),
            self.goes_on.take(),
        );
        self.inlined += 1;
        let done = emit(self);
        self.inlined -= 1;
        (self.fixed, self.held, self.held_parts, self.reserved, self.goes_on) = around;
        (self.body, self.by, self.regs, self.parts, self.envs, self.this, self.this_parts, self.pos) = outer;
        done
    }
}
