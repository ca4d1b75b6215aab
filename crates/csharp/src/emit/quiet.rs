//! Methods that only compute: what they are given they neither change nor keep, and nothing else changes meanwhile.

use std::sync::Arc;

use super::Emitter;
use crate::bound::{Body, Conv, Expr, FieldRef, Kind, MethodRef, Stmt, StmtKind};
use crate::program::Program;
use crate::sema::{self, MethodId, Prim};
use crate::syntax::ast::{Passing, TypeKind};

/// What a method that only computes does.
#[derive(Debug, Clone)]
pub(crate) enum Quiet {
    /// It gives the value of the expression that its body is.
    Value(Arc<Body>),
    /// A constructor that sets fields of the new object, each once.
    Fields(Arc<Body>),
    /// It reads a field of its object.
    Getter(sema::FieldId),
}

/// The most nodes of an expression that is put in place of a call.
pub(super) const MOST_NODES: usize = 80;

/// The statements of a body that has no variables beyond its parameters.
pub(super) fn statements(body: &Body) -> Option<Vec<&Stmt>> {
    fn flat<'b>(stmt: &'b Stmt, params: &[crate::bound::LocalId], into: &mut Vec<&'b Stmt>) -> bool {
        match &stmt.kind {
            StmtKind::Block(locals, list) => {
                locals.iter().all(|l| params.contains(l)) && list.iter().all(|s| flat(s, params, into))
            }
            StmtKind::Several(list) => list.iter().all(|s| flat(s, params, into)),
            _ => {
                into.push(stmt);
                true
            }
        }
    }
    let mut list = Vec::new();
    flat(&body.stmt, &body.params, &mut list).then_some(list)
}

/// The field that a statement of a constructor sets, and its value.
pub(super) fn sets_field(stmt: &Stmt) -> Option<(FieldRef, &Expr)> {
    let StmtKind::Expr(Expr { kind: Kind::Assign(place, value), .. }) = &stmt.kind else { return None };
    match &place.kind {
        Kind::Field(Some(object), field) if matches!(object.kind, Kind::This) => Some((*field, value)),
        _ => None,
    }
}

impl Program {
    /// What a method does, if it only computes.
    pub(crate) fn quiet(&mut self, id: MethodId) -> Option<Quiet> {
        if let Some(known) = self.quiet.get(&id) {
            return known.clone();
        }
        // One that calls itself is none.
        self.quiet.insert(id, None);
        let found = self.find_quiet(id);
        self.quiet.insert(id, found.clone());
        found
    }

    fn find_quiet(&mut self, id: MethodId) -> Option<Quiet> {
        let info = self.sema.method(id);
        if info.iterator || info.params.iter().any(|p| p.passing != Passing::Value) {
            return None;
        }
        let (is_constructor, is_static, owner) = (&*info.name == ".ctor", info.is_static, info.owner);
        match info.body {
            sema::Body::Auto(field, false) if !is_static => return Some(Quiet::Getter(field)),
            sema::Body::Written(_) | sema::Body::Accessor(_, false) => {}
            _ => return None,
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
        if body.captures_this || body.iterator.is_some() || body.locals.iter().any(|l| l.captured) {
            return None;
        }
        let list = statements(&body)?;
        if is_constructor {
            let is_struct = self.sema.def(owner).kind == TypeKind::Struct;
            let mut set = Vec::new();
            for stmt in list {
                let (field, value) = sets_field(stmt)?;
                if !is_struct || set.contains(&field.id) || uses_this(value) || !self.is_quiet(value) {
                    return None;
                }
                set.push(field.id);
            }
            let all = self.sema.def(owner).fields.len();
            return (set.len() == all).then(|| Quiet::Fields(body.clone()));
        }
        match list.as_slice() {
            [Stmt { kind: StmtKind::Return(Some(value)), .. }] => {
                self.is_quiet(value).then(|| Quiet::Value(body.clone()))
            }
            _ => None,
        }
    }

    /// Whether evaluating changes nothing that anybody else sees.
    pub(super) fn is_quiet(&mut self, e: &Expr) -> bool {
        let mut nodes = MOST_NODES;
        self.quiet_within(e, &mut nodes)
    }

    fn quiet_within(&mut self, e: &Expr, nodes: &mut usize) -> bool {
        match nodes.checked_sub(1) {
            Some(left) => *nodes = left,
            None => return false,
        }
        match &e.kind {
            Kind::Const(_) | Kind::Local(_) | Kind::This | Kind::Held(_) => true,
            Kind::Field(Some(a), _)
            | Kind::Length(a)
            | Kind::Not(a)
            | Kind::IsNull(_, a)
            | Kind::Negate(_, _, a)
            | Kind::Complement(_, a) => self.quiet_within(a, nodes),
            Kind::Convert(Conv::Number(from, to, _), a) => {
                *from != Prim::Decimal && *to != Prim::Decimal && self.quiet_within(a, nodes)
            }
            Kind::Convert(Conv::ToEnum | Conv::FromEnum(_), a) => self.quiet_within(a, nodes),
            Kind::Binary(_, prim, _, a, b) => {
                *prim != Prim::Decimal && self.quiet_within(a, nodes) && self.quiet_within(b, nodes)
            }
            Kind::And(a, b) | Kind::Or(a, b) => self.quiet_within(a, nodes) && self.quiet_within(b, nodes),
            Kind::Choice(a, b, c) => [a, b, c].into_iter().all(|e| self.quiet_within(e, nodes)),
            Kind::Element(a, list) => {
                self.quiet_within(a, nodes) && list.iter().all(|e| self.quiet_within(e, nodes))
            }
            Kind::Prop(receiver, args, Some(method), _, is_virtual)
            | Kind::Call(receiver, method, args, is_virtual) => {
                receiver.as_deref().is_none_or(|r| self.quiet_within(r, nodes))
                    && args.iter().all(|(p, e)| *p == Passing::Value && self.quiet_within(e, nodes))
                    && self.is_quiet_call(method, receiver.as_deref(), *is_virtual)
            }
            Kind::New(method, args) => {
                args.iter().all(|(p, e)| *p == Passing::Value && self.quiet_within(e, nodes))
                    && method.id.0 != u32::MAX
                    && matches!(self.quiet(method.id), Some(Quiet::Fields(_)))
            }
            _ => false,
        }
    }

    fn is_quiet_call(&mut self, method: &MethodRef, receiver: Option<&Expr>, is_virtual: bool) -> bool {
        // Of a struct no other method is called than this one.
        if is_virtual && !receiver.is_some_and(|r| self.sema.is_struct(r.ty)) {
            return false;
        }
        if let sema::Body::Extern(key) = &self.sema.method(method.id).body {
            let reads =
                ["List.get_Item(Int32)", "List.get_Count()", "String.get_Length()", "String.get_Item(Int32)"];
            return !self.host_keys.contains_key(key)
                && (key.starts_with("Math.") || reads.contains(&&**key));
        }
        matches!(self.quiet(method.id), Some(Quiet::Value(_) | Quiet::Getter(_)))
    }
}

impl Emitter<'_> {
    /// Whether all but the first of some expressions are quiet: what the first gave is still the same after them.
    pub(super) fn rest_is_quiet<'e>(&mut self, rest: impl Iterator<Item = &'e Expr>) -> bool {
        let rest: Vec<_> = rest.collect();
        rest.into_iter().all(|e| self.program.is_quiet(e))
    }
}

fn uses_this(e: &Expr) -> bool {
    match &e.kind {
        Kind::This => true,
        Kind::Const(_) | Kind::Local(_) => false,
        Kind::Field(Some(a), _) | Kind::Negate(_, _, a) | Kind::Convert(_, a) => uses_this(a),
        Kind::Binary(_, _, _, a, b) => uses_this(a) || uses_this(b),
        Kind::Call(receiver, _, args, _) => {
            receiver.as_deref().is_some_and(uses_this) || args.iter().any(|(_, e)| uses_this(e))
        }
        // Others are rare in constructors.
        _ => true,
    }
}
