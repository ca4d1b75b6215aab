//! Bodies of methods, constructors and fields.

use std::collections::HashSet;
use std::sync::OnceLock;

use super::local_function::LIFTED;
use super::{Binder, Entry, Function, Item, Returns, make};
use crate::bound::{self, Const, Expr, FieldRef, Kind, Label, Stmt, StmtKind};
use crate::sema::{Body, DefId, FieldId, Known, MethodId, Sema, Ty};
use crate::source::Pos;
use crate::syntax::ast::{self, FnBody, TypeKind};

/// Binds the body of a method; none where it has none of its own.
pub(crate) fn bind_method(sema: &mut Sema, id: MethodId) -> Option<bound::Body> {
    let info = sema.method(id).clone();
    let (body, chain, pos, end) = match &info.body {
        Body::Written(method) => (method.body.clone(), method.chain.clone(), method.pos, method.pos),
        Body::Accessor(property, set) => {
            let accessor = if *set { &property.setter } else { &property.getter };
            let (pos, _, body) = accessor.as_ref()?;
            (body.clone(), None, *pos, *pos)
        }
        Body::Default => (None, None, info.pos, info.pos),
        _ => return None,
    };
    let faults = sema.faults.len();
    let is_constructor = matches!(&*info.name, ".ctor" | ".cctor");
    let mut binder = Binder::new(sema, info.owner, info.is_static, &info.type_params);
    binder.constructor = is_constructor;
    let yields = if info.iterator { binder.element_of_iterator(pos, info.ret) } else { None };
    binder.functions.push(Function {
        returns: Returns::Type(info.ret),
        yields,
        by_ref: info.by_ref,
        base: 0,
    });
    if let Some(name) = info.name.strip_prefix(LIFTED) {
        binder.enter(&name.into(), Entry::Lifted(id));
    }
    let mut params = Vec::new();
    for param in &info.params {
        params.push(binder.declare(pos, &param.name, param.ty, param.passing));
    }
    let mut stmts = Vec::new();
    if &*info.name == ".ctor" {
        binder.construct(pos, chain.as_ref(), &params, &mut stmts);
    }
    let end = match &body {
        Some(FnBody::Block(block)) => block.end,
        _ => end,
    };
    let body_stmt = match body {
        Some(FnBody::Block(block)) => binder.block(&block),
        Some(FnBody::Expr(e)) => binder.arrow(&e, info.ret),
        None => Stmt { pos, kind: StmtKind::Several(Vec::new()) },
    };
    if info.ret != Ty::VOID && yields.is_none() && info.ret != Ty::ERROR && ends(&body_stmt) {
        let shown = binder.sema.show_method(id);
        let _ = end;
        binder.fault(info.pos, 161, format!("'{shown}': not all code paths return a value"));
    }
    stmts.push(body_stmt);
    let body = binder.finish_body(pos, params, stmts, yields);
    // In VB a variable begins with the default value of its type.
    if sema.faults.len() == faults && !sema.vb && !sema.def(info.owner).library {
        for fault in super::assigned::unassigned(sema, &body) {
            sema.fault(fault.pos, fault.code, fault.message);
        }
    }
    Some(body)
}

/// Binds the first values of static fields and the static constructor.
pub(crate) fn bind_static_init(sema: &mut Sema, def: DefId) -> Option<bound::Body> {
    let info = sema.def(def).clone();
    let cctor = info.members.get(".cctor").and_then(|l| l.first()).copied();
    let has_values = info.statics.iter().any(|f| sema.field(*f).value.is_some());
    if cctor.is_none() && !has_values {
        return None;
    }
    let mut binder = Binder::new(sema, def, true, &[]);
    binder.constructor = true;
    binder.functions.push(Function {
        returns: Returns::Type(Ty::VOID),
        yields: None,
        by_ref: false,
        base: 0,
    });
    let mut stmts = Vec::new();
    binder.field_values(&info.statics, None, &mut stmts);
    if let Some(crate::sema::Member::Method(id)) = cctor
        && let Body::Written(method) = binder.sema.method(id).body.clone()
        && let Some(FnBody::Block(block)) = &method.body
    {
        stmts.push(binder.block(block));
    }
    Some(binder.finish_body(info.pos, Vec::new(), stmts, None))
}

/// The value of a constant or of a member of an enum.
pub(crate) fn constant_of(sema: &mut Sema, id: FieldId) -> Const {
    let field = sema.field(id).clone();
    match field.known {
        Known::Yes(value) => return value,
        Known::Busy => {
            sema.fault(
                field.pos,
                110,
                format!(
                    "The evaluation of the constant value for '{}' involves a circular definition",
                    field.name
                ),
            );
            return Const::Int(0);
        }
        Known::No => {}
    }
    sema.fields[id.0 as usize].known = Known::Busy;
    let is_enum = sema.def(field.owner).kind == TypeKind::Enum;
    let value = match (&field.value, field.previous) {
        (Some(e), _) => {
            let mut binder = Binder::new(sema, field.owner, true, &[]);
            binder.functions.push(Function {
                returns: Returns::Type(Ty::VOID),
                yields: None,
                by_ref: false,
                base: 0,
            });
            let ty = if is_enum {
                binder.sema.def(field.owner).base.unwrap_or(binder.sema.known.int)
            } else {
                field.ty
            };
            let mut item = binder.item(e);
            // Inside an enum its own members count as numbers.
            if let Item::Value(v) = &mut item
                && is_enum
                && v.ty == field.ty
            {
                v.ty = ty;
            }
            let value = binder.convert(item, ty, e.pos);
            match value.kind {
                Kind::Const(value) => value,
                Kind::Error => Const::Null,
                _ => {
                    binder.fault(
                        e.pos,
                        133,
                        format!("The expression being assigned to '{}' must be constant", field.name),
                    );
                    Const::Null
                }
            }
        }
        (None, Some(previous)) => match constant_of(sema, previous) {
            Const::Int(n) => Const::Int(n + 1),
            other => other,
        },
        (None, None) if is_enum => Const::Int(0),
        (None, None) => {
            sema.fault(field.pos, 145, "A const field requires a value to be provided");
            Const::Null
        }
    };
    sema.fields[id.0 as usize].known = Known::Yes(value.clone());
    value
}

impl Binder<'_> {
    pub(super) fn finish_body(
        mut self,
        pos: Pos,
        params: Vec<bound::LocalId>,
        stmts: Vec<Stmt>,
        iterator: Option<Ty>,
    ) -> bound::Body {
        let locals = self.scopes.pop().map(|s| s.locals).unwrap_or_default();
        let stmt = Stmt { pos, kind: StmtKind::Block(locals, stmts) };
        bound::Body {
            locals: self.locals,
            params,
            stmt,
            captures_this: self.captures_this,
            iterator,
            uses: OnceLock::new(),
        }
    }

    pub(super) fn element_of_iterator(&mut self, pos: Pos, ret: Ty) -> Option<Ty> {
        let known = self.sema.known;
        if ret == known.plain_enumerable || ret == known.plain_enumerator {
            return Some(known.object);
        }
        match self.sema.def_of(ret) {
            Some(def) if def == known.enumerable || def == known.enumerator => {
                self.sema.args_of(ret).first().copied()
            }
            _ => {
                let shown = self.show(ret);
                self.fault(pos, 1624, format!("The body cannot be an iterator block because '{shown}' is not an iterator interface type"));
                Some(Ty::ERROR)
            }
        }
    }

    /// `=> value`
    fn arrow(&mut self, e: &ast::Expr, ret: Ty) -> Stmt {
        let pos = e.pos;
        if let Some(kind) = self.returned_reference(pos, e, ret) {
            return Stmt { pos, kind };
        }
        let item = self.item(e);
        if let Item::Throw(value) = item {
            return Stmt { pos, kind: StmtKind::Expr(value) };
        }
        if ret == Ty::VOID {
            let value = self.as_value(item, pos);
            return Stmt { pos, kind: StmtKind::Expr(value) };
        }
        let value = self.convert(item, ret, pos);
        Stmt { pos, kind: StmtKind::Return(Some(value)) }
    }

    /// First values of fields, then the constructor of the base class or another of this one.
    fn construct(
        &mut self,
        pos: Pos,
        chain: Option<&(bool, Pos, Vec<ast::Arg>)>,
        params: &[bound::LocalId],
        stmts: &mut Vec<Stmt>,
    ) {
        let info = self.sema.def(self.def).clone();
        let anonymous = info.decl.is_none();
        if anonymous {
            for (param, field) in params.iter().zip(&info.fields) {
                let value = self.local(*param, pos);
                let place = self.own_field(pos, *field);
                let ty = place.ty;
                stmts.push(
                    self.expression_stmt(pos, make(ty, pos, Kind::Assign(Box::new(place), Box::new(value)))),
                );
            }
            return;
        }
        if chain.is_none_or(|(base, ..)| *base) {
            self.field_values(&info.fields, Some(()), stmts);
        }
        // Of a struct that has no such constructor of its own, `this()` gives every field its default value: so it begins.
        let begins = match chain {
            Some((false, _, args)) => args.is_empty() && self.no_empty_constructor(self.def),
            Some(_) => false,
            None => true,
        };
        if info.kind == TypeKind::Struct && begins {
            return;
        }
        let this = self.this(pos);
        let (target, at, args): (Ty, Pos, &[ast::Arg]) = match chain {
            Some((false, at, args)) => (self.this, *at, args),
            Some((true, at, args)) => (self.sema.base_of(self.this).unwrap_or(Ty::ERROR), *at, args),
            None => (self.sema.base_of(self.this).unwrap_or(Ty::ERROR), pos, &[]),
        };
        if target == self.sema.known.object || target == Ty::ERROR {
            return;
        }
        if let Some((method, args)) = self.constructor(at, target, args) {
            let receiver = self.retyped(this, target);
            stmts.push(self.expression_stmt(
                at,
                make(Ty::VOID, at, Kind::Call(Some(Box::new(receiver)), method, args, false)),
            ));
        }
    }

    fn own_field(&mut self, pos: Pos, id: FieldId) -> Expr {
        let field = self.sema.field(id);
        let (ty, is_static) = (field.ty, field.is_static);
        let owner = self.this;
        let receiver = if is_static { None } else { Some(Box::new(make(owner, pos, Kind::This))) };
        make(ty, pos, Kind::Field(receiver, FieldRef { id, owner }))
    }

    fn field_values(&mut self, fields: &[FieldId], instance: Option<()>, stmts: &mut Vec<Stmt>) {
        for id in fields {
            let field = self.sema.field(*id).clone();
            let Some(e) = &field.value else { continue };
            // The first value of a field sees no object.
            let outer = std::mem::replace(&mut self.is_static, true);
            self.in_field_value = instance.is_some();
            let scopes = std::mem::take(&mut self.scopes);
            self.scopes.push(super::Scope::default());
            let value = self.initial(e, field.ty);
            let made = self.scopes.pop().map(|s| s.locals).unwrap_or_default();
            self.scopes = scopes;
            if let Some(scope) = self.scopes.last_mut() {
                scope.locals.extend(made);
            }
            self.is_static = outer;
            self.in_field_value = false;
            let place = self.own_field(field.pos, *id);
            let ty = place.ty;
            stmts.push(self.expression_stmt(
                field.pos,
                make(ty, field.pos, Kind::Assign(Box::new(place), Box::new(value))),
            ));
        }
    }
}

/// Whether the end of a statement can be reached (C# specification, end points and reachability).
pub(super) fn ends(stmt: &Stmt) -> bool {
    reaches(stmt, &mut HashSet::new())
}

fn always(e: &Expr) -> Option<bool> {
    match e.kind {
        Kind::Const(Const::Bool(b)) => Some(b),
        _ => None,
    }
}

fn reaches(stmt: &Stmt, jumped: &mut HashSet<Label>) -> bool {
    match &stmt.kind {
        StmtKind::Block(_, list) | StmtKind::Several(list) => {
            let mut reachable = true;
            for inner in list {
                if let StmtKind::Label(label) = &inner.kind {
                    reachable |= jumped.contains(label);
                } else if reachable || has_label(inner) {
                    reachable = reaches(inner, jumped);
                }
            }
            reachable
        }
        StmtKind::Expr(e) => !matches!(e.kind, Kind::Throw(_)),
        StmtKind::If(c, yes, no) => {
            let constant = always(c);
            let yes = reaches(yes, jumped) && constant != Some(false);
            let no = no.as_ref().is_none_or(|no| reaches(no, jumped)) && constant != Some(true);
            yes || no
        }
        StmtKind::Loop(c, body, _, brk, _) => {
            reaches(body, jumped);
            jumped.contains(brk) || c.as_ref().is_some_and(|c| always(c) != Some(true))
        }
        StmtKind::DoLoop(body, c, brk, cont) => {
            let end = reaches(body, jumped) || jumped.contains(cont);
            jumped.contains(brk) || end && always(c) != Some(true)
        }
        StmtKind::Label(_) | StmtKind::Yield(Some(_)) => true,
        StmtKind::Goto(label) => {
            jumped.insert(*label);
            false
        }
        StmtKind::Return(_) | StmtKind::Throw(_) | StmtKind::Yield(None) => false,
        StmtKind::Try(body, catches, finally) => {
            let mut end = reaches(body, jumped);
            for catch in catches {
                end |= reaches(&catch.body, jumped);
            }
            end && finally.as_ref().is_none_or(|f| reaches(f, jumped))
        }
    }
}

/// A label may be jumped to from anywhere.
fn has_label(stmt: &Stmt) -> bool {
    match &stmt.kind {
        StmtKind::Several(list) => list.iter().any(|s| matches!(s.kind, StmtKind::Label(_))),
        _ => false,
    }
}
