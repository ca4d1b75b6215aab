//! Lambdas and groups of methods as delegates.

use std::cmp::Ordering;
use std::sync::Arc;

use super::{Binder, Entry, Function, Group, Item, LambdaSource, Returns, make};
use crate::bound::{Expr, Kind, Lambda, LocalId, Origin, Stmt, StmtKind};
use crate::sema::Ty;
use crate::source::Pos;
use crate::syntax::ast::{self, FnBody, Passing};

impl Binder<'_> {
    /// A lambda as a value of a delegate type.
    pub(super) fn lambda_as(&mut self, pos: Pos, source: &LambdaSource, to: Ty) -> Expr {
        let Some((takes, gives)) = self.sema.invoke_of(to) else {
            let shown = self.show(to);
            return self.error(
                pos,
                1660,
                format!(
                    "Cannot convert lambda expression to type '{shown}' because it is not a delegate type"
                ),
            );
        };
        if let Some(params) = &source.params
            && params.len() != takes.len()
        {
            let shown = self.show(to);
            return self.error(
                pos,
                1593,
                format!("Delegate '{shown}' does not take {} arguments", params.len()),
            );
        }
        let (lambda, _) = self.lambda(pos, source, &takes, Returns::Type(gives), None);
        make(to, pos, Kind::Lambda(Arc::new(lambda)))
    }

    /// The value of a function in a function.
    pub(super) fn function_value(
        &mut self,
        pos: Pos,
        source: &LambdaSource,
        takes: &[(Passing, Ty)],
        ret: Ty,
        iterator: bool,
    ) -> Lambda {
        let yields = if iterator { self.element_of_iterator(pos, ret) } else { None };
        self.lambda(pos, source, takes, Returns::Type(ret), yields).0
    }

    /// The common type of what a lambda gives; `void` when it gives nothing.
    pub(super) fn lambda_returns(&mut self, source: &LambdaSource, takes: &[(Passing, Ty)]) -> Option<Ty> {
        if source.params.as_ref().is_some_and(|p| p.len() != takes.len()) {
            return None;
        }
        let takes = takes.to_vec();
        let returns =
            self.speculate(|b| b.lambda(0, source, &takes, Returns::Infer(Vec::new(), false), None).1)?;
        let Returns::Infer(types, untyped) = returns else { return None };
        if types.is_empty() {
            return if untyped { None } else { Some(Ty::VOID) };
        }
        let items: Vec<_> = types.iter().map(|ty| Item::Value(make(*ty, 0, Kind::Error))).collect();
        self.common_type(&items)
    }

    fn lambda(
        &mut self,
        pos: Pos,
        source: &LambdaSource,
        takes: &[(Passing, Ty)],
        returns: Returns,
        yields: Option<Ty>,
    ) -> (Lambda, Returns) {
        let base = self.scopes.len();
        let by_ref = std::mem::take(&mut self.next_by_ref);
        self.functions.push(Function { returns, yields, by_ref, base });
        let outer_jumps = std::mem::take(&mut self.jumps);
        let ((params, body), locals) = self.in_scope(|b| {
            let params = b.lambda_params(source, takes);
            let body = match &*source.body {
                FnBody::Block(block) => b.block(block),
                FnBody::Expr(e) => b.lambda_value(e),
            };
            (params, body)
        });
        self.jumps = outer_jumps;
        let returns = self.functions.pop().map_or(Returns::Type(Ty::ERROR), |f| f.returns);
        if let (FnBody::Block(block), Returns::Type(ty)) = (&*source.body, &returns)
            && *ty != Ty::VOID
            && *ty != Ty::ERROR
            && yields.is_none()
            && super::method::ends(&body)
        {
            self.fault(
                block.end,
                1643,
                "Not all code paths return a value in lambda expression of type 'delegate'",
            );
        }
        let stmt = Stmt { pos, kind: StmtKind::Block(locals, vec![body]) };
        (Lambda { params, body: stmt, iterator: yields, origin: Origin::Written }, returns)
    }

    fn lambda_params(&mut self, source: &LambdaSource, takes: &[(Passing, Ty)]) -> Vec<LocalId> {
        let Some(written) = &source.params else {
            return takes.iter().map(|(p, ty)| self.new_local("", *ty, *p)).collect();
        };
        let mut params = Vec::new();
        for (own, (passing, ty)) in written.iter().zip(takes) {
            if let Some(written) = &own.ty {
                let written_ty = self.resolve(written);
                if written_ty != *ty && written_ty != Ty::ERROR {
                    let (a, b) = (self.show(written_ty), self.show(*ty));
                    self.fault(
                        own.pos,
                        1678,
                        format!("Parameter '{}' is declared as type '{a}' but should be '{b}'", own.name),
                    );
                }
            }
            if own.carries.is_empty() {
                if &*own.name == "_" {
                    let id = self.new_local("_", *ty, *passing);
                    self.enter(&own.name, Entry::Local(id));
                    params.push(id);
                } else {
                    params.push(self.declare(own.pos, &own.name, *ty, *passing));
                }
            } else {
                let id = self.new_local(&own.name, *ty, *passing);
                for name in &own.carries {
                    self.enter(name, Entry::Carried(id, name.clone()));
                }
                params.push(id);
            }
        }
        params
    }

    /// `=> value`
    fn lambda_value(&mut self, e: &ast::Expr) -> Stmt {
        let pos = e.pos;
        let gives = match self.functions.last().map(|f| &f.returns) {
            Some(Returns::Type(ty)) => *ty,
            _ => Ty::VOID,
        };
        if let Some(kind) = self.returned_reference(pos, e, gives) {
            return Stmt { pos, kind };
        }
        let item = self.item(e);
        let kind = match self.functions.last_mut().map(|f| &mut f.returns) {
            Some(Returns::Infer(types, untyped)) => {
                match &item {
                    Item::Value(value) if value.ty == Ty::VOID => {}
                    Item::Value(value) if value.ty != Ty::NULL => types.push(value.ty),
                    Item::Tuple(..) => {
                        let value = self.as_value(item, pos);
                        if let Some(Returns::Infer(types, _)) =
                            self.functions.last_mut().map(|f| &mut f.returns)
                        {
                            types.push(value.ty);
                        }
                    }
                    _ => *untyped = true,
                }
                StmtKind::Several(Vec::new())
            }
            Some(Returns::Type(ty)) if *ty == Ty::VOID => {
                if let Item::Throw(value) = item {
                    return Stmt { pos, kind: StmtKind::Expr(value) };
                }
                let value = self.as_value(item, pos);
                let effect = matches!(
                    value.kind,
                    Kind::Call(..)
                        | Kind::Invoke(..)
                        | Kind::Assign(..)
                        | Kind::Update(..)
                        | Kind::New(..)
                        | Kind::Initialise(..)
                        | Kind::Conditional(..)
                        | Kind::Dynamic(..)
                        | Kind::Deconstruct(..)
                        | Kind::Error
                        | Kind::Throw(_)
                        | Kind::Block(..)
                );
                if !effect {
                    self.fault(pos, 201, "Only assignment, call, increment, decrement, await, and new object expressions can be used as a statement");
                }
                StmtKind::Expr(value)
            }
            Some(Returns::Type(ty)) => {
                let ty = *ty;
                if let Item::Throw(value) = item {
                    return Stmt { pos, kind: StmtKind::Expr(value) };
                }
                let value = self.convert(item, ty, pos);
                StmtKind::Return(Some(value))
            }
            None => StmtKind::Several(Vec::new()),
        };
        Stmt { pos, kind }
    }

    /// A group of methods as a delegate: a lambda that calls the one that fits.
    pub(super) fn group_as(&mut self, group: &Group, to: Ty) -> Expr {
        let pos = group.pos;
        let Some((takes, gives)) = self.sema.invoke_of(to) else {
            let shown = self.show(to);
            return self.error(pos, 428, format!("Cannot convert method group '{}' to non-delegate type '{shown}'. Did you intend to invoke the method?", group.name));
        };
        let mut group = group.clone();
        let result = self.new_local("", to, Passing::Value);
        // The object is the only captured variable of a block of its own: so delegates of one method are compared.
        let (stmts, locals) = self.in_scope(|b| {
            let mut stmts = Vec::new();
            let instance = group.candidates.iter().all(|(_, id)| !b.sema.method(*id).is_static);
            let receiver = group.receiver.take();
            let has_object = match receiver {
                Some(receiver) if instance || !matches!(receiver.kind, Kind::This) => {
                    let local = b.new_local("", receiver.ty, Passing::Value);
                    group.receiver = Some(make(receiver.ty, pos, Kind::Local(local)));
                    stmts.push(b.set_local(pos, local, receiver));
                    true
                }
                other => {
                    group.receiver = other;
                    false
                }
            };
            let base = b.scopes.len();
            b.functions.push(Function { returns: Returns::Type(gives), yields: None, by_ref: false, base });
            let ((params, body), locals) = b.in_scope(|b| b.group_call(pos, group, &takes, gives, to));
            b.functions.pop();
            let origin = match called(&body) {
                Some(Kind::Call(receiver, method, ..)) => {
                    Origin::Method(method.clone(), has_object && receiver.is_some())
                }
                _ => Origin::Written,
            };
            let body = Stmt { pos, kind: StmtKind::Block(locals, vec![body]) };
            let lambda = Lambda { params, body, iterator: None, origin };
            stmts.push(b.set_local(pos, result, make(to, pos, Kind::Lambda(Arc::new(lambda)))));
            stmts
        });
        let block = Stmt { pos, kind: StmtKind::Block(locals, stmts) };
        let value = self.local(result, pos);
        make(to, pos, Kind::Block(vec![block], Box::new(value)))
    }

    fn group_call(
        &mut self,
        pos: Pos,
        mut group: Group,
        takes: &[(Passing, Ty)],
        gives: Ty,
        to: Ty,
    ) -> (Vec<LocalId>, Stmt) {
        match group.receiver.clone() {
            Some(Expr { kind: Kind::Local(id), .. }) => group.receiver = Some(self.local(id, pos)),
            Some(Expr { kind: Kind::This, .. }) => self.captures_this = true,
            _ => {}
        }
        let mut params = Vec::new();
        let mut args = Vec::new();
        for (i, (passing, ty)) in takes.iter().enumerate() {
            let name: ast::Name = format!("<{i}>").into();
            let id = self.new_local(&name, *ty, *passing);
            self.enter(&name, Entry::Local(id));
            params.push(id);
            let part = ast::NamePart { pos, name, args: Vec::new(), open: 0 };
            args.push(ast::Arg {
                name: None,
                passing: *passing,
                value: ast::Expr { pos, kind: ast::ExprKind::Name(part) },
            });
        }
        let name = group.name.clone();
        let faults = self.sema.faults.len();
        let call = self.call_group(pos, group, &args);
        let fits = self.sema.faults.len() == faults
            && (gives == Ty::VOID
                || call.ty == gives
                || (call.ty != Ty::VOID && self.sema.implicit(call.ty, gives).is_some()));
        if !fits {
            let called = self.sema.faults.len() == faults && call.ty != Ty::ERROR;
            self.sema.faults.truncate(faults);
            let shown = self.show(to);
            if called {
                let given = self.show(call.ty);
                self.fault(pos, 407, format!("'{given} {name}' has the wrong return type"));
                return (params, Stmt { pos, kind: StmtKind::Expr(call) });
            }
            self.fault(pos, 123, format!("No overload for '{name}' matches delegate '{shown}'"));
        }
        let kind = if gives == Ty::VOID || !fits {
            StmtKind::Expr(call)
        } else {
            StmtKind::Return(Some(self.convert(Item::Value(call), gives, pos)))
        };
        (params, Stmt { pos, kind })
    }

    /// What a group of methods gives for arguments of types.
    pub(super) fn group_returns(&mut self, group: &Group, takes: &[(Passing, Ty)]) -> Option<Ty> {
        let args: Vec<_> = takes
            .iter()
            .map(|(passing, _)| ast::Arg {
                name: None,
                passing: *passing,
                value: ast::Expr { pos: group.pos, kind: ast::ExprKind::Receiver },
            })
            .collect();
        let items: Vec<_> =
            takes.iter().map(|(_, ty)| Item::Value(make(*ty, group.pos, Kind::Error))).collect();
        let (candidates, types) = (group.candidates.clone(), group.type_args.clone());
        self.speculate(|b| b.choose(0, &candidates, &types, &args, items, "").map(|c| c.ret)).flatten()
    }

    /// Which of two delegate types suits a lambda better: by what it gives.
    pub(super) fn compare_lambda(&mut self, source: &LambdaSource, x: Ty, y: Ty) -> Ordering {
        let (Some((tx, gx)), Some((ty, gy))) = (self.sema.invoke_of(x), self.sema.invoke_of(y)) else {
            return Ordering::Equal;
        };
        if tx != ty {
            return Ordering::Equal;
        }
        if gx == gy {
            return Ordering::Equal;
        }
        match self.lambda_returns(source, &tx) {
            Some(given) if given == gx => Ordering::Greater,
            Some(given) if given == gy => Ordering::Less,
            _ if gx == Ty::VOID => Ordering::Less,
            _ if gy == Ty::VOID => Ordering::Greater,
            _ => self.compare_targets(gx, gy),
        }
    }
}

/// The call that the body of a delegate of a method is, below conversions of what it gives.
fn called(body: &Stmt) -> Option<&Kind> {
    let (StmtKind::Expr(value) | StmtKind::Return(Some(value))) = &body.kind else { return None };
    let mut value = value;
    while let Kind::Convert(_, inner) = &value.kind {
        value = inner;
    }
    Some(&value.kind)
}
