//! Methods of structs that change them, in place of the call: a few statements without loops, on a struct in its parts.

use std::sync::Arc;

use super::inline::Operand;
use super::quiet::MOST_NODES;
use super::uses::each_operand;
use super::{Emitted, Emitter};
use crate::bound::{Arg, Body, Expr, Kind, MethodRef, Stmt, StmtKind};
use crate::program::Program;
use crate::sema::{self, MethodId};
use crate::syntax::ast::{Passing, TypeKind};

impl Program {
    /// The body of a method of a struct that may stand in place of its calls.
    pub(super) fn steps(&mut self, id: MethodId) -> Option<Arc<Body>> {
        if let Some(known) = self.steps.get(&id) {
            return known.clone();
        }
        let found = self.find_steps(id);
        self.steps.insert(id, found.clone());
        found
    }

    fn find_steps(&mut self, id: MethodId) -> Option<Arc<Body>> {
        let info = self.sema.method(id);
        if info.is_static
            || info.iterator
            || &*info.name == ".ctor"
            || info.params.iter().any(|p| p.passing != Passing::Value)
            || self.sema.def(info.owner).kind != TypeKind::Struct
            || !matches!(info.body, sema::Body::Written(_) | sema::Body::Accessor(..))
        {
            return None;
        }
        let faults = self.sema.faults.len();
        let body = self.body(id);
        if self.sema.faults.len() > faults {
            // It is said when it is called, not before.
            self.sema.faults.truncate(faults);
            self.bodies.remove(&id);
            return None;
        }
        let body = body?;
        if body.captures_this
            || body.iterator.is_some()
            || body.locals.iter().any(|l| l.captured || l.is_reference)
        {
            return None;
        }
        let mut nodes = MOST_NODES;
        is_plain(&body.stmt, &mut nodes).then_some(body)
    }
}

/// Whether a statement is one of those that may stand in place of a call.
fn is_plain(stmt: &Stmt, nodes: &mut usize) -> bool {
    match &stmt.kind {
        StmtKind::Block(_, list) | StmtKind::Several(list) => list.iter().all(|stmt| is_plain(stmt, nodes)),
        StmtKind::Expr(e) => is_plain_expr(e, nodes),
        StmtKind::Return(e) => e.as_ref().is_none_or(|e| is_plain_expr(e, nodes)),
        StmtKind::If(c, yes, no) => {
            is_plain_expr(c, nodes)
                && is_plain(yes, nodes)
                && no.as_deref().is_none_or(|no| is_plain(no, nodes))
        }
        _ => false,
    }
}

fn is_plain_expr(e: &Expr, nodes: &mut usize) -> bool {
    match nodes.checked_sub(1) {
        Some(left) => *nodes = left,
        None => return false,
    }
    let by_value = |args: &[Arg]| args.iter().all(|(passing, _)| *passing == Passing::Value);
    let here = match &e.kind {
        Kind::Ref(_)
        | Kind::Deref(_)
        | Kind::Bind(..)
        | Kind::Lambda(_)
        | Kind::Dynamic(..)
        | Kind::Block(..)
        | Kind::Error => false,
        Kind::Assign(place, _) | Kind::Update(place, ..) => is_plain_place(place),
        Kind::Prop(_, args, ..) | Kind::Call(_, _, args, _) | Kind::Invoke(_, args) | Kind::New(_, args) => {
            by_value(args)
        }
        _ => true,
    };
    let mut all = here;
    each_operand(e, &mut |operand| all = all && is_plain_expr(operand, nodes), &mut |_| {});
    all
}

/// Whether what is set is a variable, or a field of the object or of a variable.
fn is_plain_place(place: &Expr) -> bool {
    match &place.kind {
        Kind::Local(_) | Kind::This => true,
        Kind::Field(Some(of), _) => matches!(of.kind, Kind::This | Kind::Local(_)),
        _ => false,
    }
}

impl Emitter<'_> {
    /// A call on a struct in its parts by the statements of the method; false where it must be a call.
    pub(super) fn inline_steps(
        &mut self,
        d: crate::vm::op::Reg,
        receiver: Option<&Expr>,
        method: &MethodRef,
        args: &[Arg],
        e: &Expr,
    ) -> Emitted<bool> {
        let Some(this) = receiver.and_then(|receiver| self.parts_of(receiver)) else { return Ok(false) };
        if !self.takes_more(method, args) {
            return Ok(false);
        }
        let Some(body) = self.program.steps(method.id) else { return Ok(false) };
        // The method may change its parameters, and its object that they came from: it has its own.
        let mut given = Vec::new();
        for (param, (_, arg)) in body.params.iter().zip(args) {
            let ty = self.ty(arg.ty);
            let stays_whole = body.uses().whole.contains(param);
            let parts = if stays_whole { None } else { self.parts_for(ty)? };
            given.push(match parts {
                Some(parts) => {
                    self.set_parts(parts, arg, true)?;
                    Operand::Parts(parts)
                }
                None => {
                    let own = self.alloc()?;
                    self.copied(arg, Some(own))?;
                    Operand::Whole(own)
                }
            });
        }
        self.pos = e.pos;
        let end = self.mark();
        self.within(&body, method, Some(Operand::Parts(this)), &given, |emitter| {
            emitter.goes_on = Some((d, end));
            emitter.stmt(&body.stmt)
        })?;
        self.set(end);
        Ok(true)
    }
}
