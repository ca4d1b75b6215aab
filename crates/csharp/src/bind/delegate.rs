//! Delegates joined with `+` and taken away with `-`, and events (C# specification, delegate combination and removal).

use std::sync::Arc;

use super::{Binder, Function, Item, Returns, make};
use crate::bound::{Const, Expr, Kind, Lambda, LocalId, MethodRef, Op, Origin, Stmt, StmtKind};
use crate::sema::{Member, Prim, Ty};
use crate::source::Pos;
use crate::syntax::ast::{self, BinaryOp, Passing};

impl Binder<'_> {
    pub(super) fn is_delegate(&self, ty: Ty) -> bool {
        self.sema.type_kind(ty) == Some(ast::TypeKind::Delegate)
    }

    /// The right operand of `+` and `-` takes the delegate type of the left one: lambdas and methods become delegates.
    pub(super) fn delegate_operand(&mut self, op: BinaryOp, left: Ty, right: &ast::Expr) -> Option<Expr> {
        if !matches!(op, BinaryOp::Add | BinaryOp::Sub) || !self.is_delegate(left) {
            return None;
        }
        let item = self.item(right);
        if let Item::Value(value) = &item
            && value.ty == self.sema.known.string
        {
            return Some(value.clone());
        }
        Some(self.convert(item, left, right.pos))
    }

    /// `a + b` and `a - b` of delegates: no delegate, the one that is left, or one that calls all in turn and gives what
    /// the last one gives.
    pub(super) fn delegate_sum(&mut self, pos: Pos, op: BinaryOp, x: &Expr, y: &Expr) -> Option<Expr> {
        let ty = if x.ty == Ty::NULL { y.ty } else { x.ty };
        let fits = |e: &Expr| e.ty == ty || e.ty == Ty::NULL;
        if !matches!(op, BinaryOp::Add | BinaryOp::Sub) || !self.is_delegate(ty) || !fits(x) || !fits(y) {
            return None;
        }
        let method = self.delegate_method(if op == BinaryOp::Add { "__Join" } else { "__Without" }, &[ty])?;
        let (takes, gives) = self.sema.invoke_of(ty)?;
        let (array, int) = (self.sema.array(ty, 1), self.sema.known.int);
        let args = [x, y].map(|e| (Passing::Value, Expr { ty, ..e.clone() })).into();
        let parts = make(array, pos, Kind::Call(None, method, args, false));
        let result = self.new_local("", ty, Passing::Value);
        let (stmts, locals) = self.in_scope(|b| {
            let list = b.new_local("", array, Passing::Value);
            let filled = b.set_local(pos, list, parts);
            let several = b.joined(pos, list, ty, &takes, gives);
            let count = make(int, pos, Kind::Length(Box::new(b.local(list, pos))));
            let is = |n: i128| {
                let n = make(int, pos, Kind::Const(Const::Int(n)));
                let test = Kind::Binary(Op::Eq, Prim::I32, false, Box::new(count.clone()), Box::new(n));
                Box::new(make(int, pos, test))
            };
            let (none, one) = (is(0), is(1));
            let bool_ = b.sema.known.bool;
            let typed = |test: Box<Expr>| Box::new(Expr { ty: bool_, ..*test });
            let first = make(int, pos, Kind::Const(Const::Int(0)));
            let alone = make(ty, pos, Kind::Element(Box::new(b.local(list, pos)), vec![first]));
            let some = make(ty, pos, Kind::Choice(typed(one), Box::new(alone), Box::new(several)));
            let null = make(ty, pos, Kind::Const(Const::Null));
            let all = make(ty, pos, Kind::Choice(typed(none), Box::new(null), Box::new(some)));
            vec![filled, b.set_local(pos, result, all)]
        });
        let block = Stmt { pos, kind: StmtKind::Block(locals, stmts) };
        let value = self.local(result, pos);
        Some(make(ty, pos, Kind::Block(vec![block], Box::new(value))))
    }

    pub(super) fn set_local(&mut self, pos: Pos, local: LocalId, value: Expr) -> Stmt {
        let place = self.local(local, pos);
        let ty = place.ty;
        self.expression_stmt(pos, make(ty, pos, Kind::Assign(Box::new(place), Box::new(value))))
    }

    /// A delegate that calls those of an array one after another.
    fn joined(&mut self, pos: Pos, list: LocalId, ty: Ty, takes: &[(Passing, Ty)], gives: Ty) -> Expr {
        let base = self.scopes.len();
        self.functions.push(Function { returns: Returns::Type(gives), yields: None, by_ref: false, base });
        let ((params, body), locals) = self.in_scope(|b| {
            let params: Vec<_> = takes.iter().map(|(passing, ty)| b.new_local("", *ty, *passing)).collect();
            let int = b.sema.known.int;
            let i = b.new_local("", int, Passing::Value);
            let number = |n: i128| Box::new(make(int, pos, Kind::Const(Const::Int(n))));
            let index = b.local(i, pos);
            let array = b.local(list, pos);
            let args: Vec<_> =
                params.iter().zip(takes).map(|(p, (passing, _))| (*passing, b.local(*p, pos))).collect();
            let element = make(ty, pos, Kind::Element(Box::new(array.clone()), vec![index.clone()]));
            let call = make(gives, pos, Kind::Invoke(Box::new(element), args));
            let arithmetic =
                |op, a: Expr, n| make(int, pos, Kind::Binary(op, Prim::I32, false, Box::new(a), number(n)));
            let length = make(int, pos, Kind::Length(Box::new(array)));
            let last = arithmetic(Op::Sub, length, 1);
            let bool_ = b.sema.known.bool;
            let more = Kind::Binary(Op::Lt, Prim::I32, false, Box::new(index.clone()), Box::new(last));
            let step = arithmetic(Op::Add, index.clone(), 1);
            let step = make(int, pos, Kind::Assign(Box::new(index), Box::new(step)));
            let (brk, cont) = (b.label(), b.label());
            let each = Box::new(b.expression_stmt(pos, call.clone()));
            let kind = StmtKind::Loop(Some(make(bool_, pos, more)), each, vec![step], brk, cont);
            let first = b.set_local(pos, i, *number(0));
            let end = if gives == Ty::VOID { StmtKind::Expr(call) } else { StmtKind::Return(Some(call)) };
            let stmts = vec![first, Stmt { pos, kind }, Stmt { pos, kind: end }];
            (params, StmtKind::Several(stmts))
        });
        self.functions.pop();
        let body = Stmt { pos, kind: StmtKind::Block(locals, vec![Stmt { pos, kind: body }]) };
        let lambda = Lambda { params, body, iterator: None, origin: Origin::Joined };
        make(ty, pos, Kind::Lambda(Arc::new(lambda)))
    }

    /// Whether two delegates call the same.
    pub(super) fn same_delegate(&mut self, pos: Pos, equal: bool, x: Expr, y: Expr) -> Expr {
        let bool_ = self.sema.known.bool;
        let Some(method) = self.delegate_method("__Same", &[]) else { return self.wrong(pos) };
        let args = vec![(Passing::Value, x), (Passing::Value, y)];
        let same = make(bool_, pos, Kind::Call(None, method, args, false));
        if equal { same } else { make(bool_, pos, Kind::Not(Box::new(same))) }
    }

    fn delegate_method(&mut self, name: &str, args: &[Ty]) -> Option<MethodRef> {
        let owner = self.sema.known.delegate;
        let found = self.sema.members(owner, &name.into());
        found.into_iter().find_map(|(_, member)| match member {
            Member::Method(id) => Some(MethodRef { id, owner, args: args.to_vec() }),
            _ => None,
        })
    }

    /// `+=` and `-=` of an event with accessors of its own.
    pub(super) fn subscribe(&mut self, pos: Pos, op: BinaryOp, place: &Expr, right: Expr) -> Option<Expr> {
        let Kind::Prop(receiver, _, Some(add), Some(remove), is_virtual) = &place.kind else { return None };
        if !self.sema.method(add.id).name.starts_with("add_") {
            return None;
        }
        let method = if op == BinaryOp::Add { add } else { remove }.clone();
        let args = vec![(Passing::Value, right)];
        Some(make(Ty::VOID, pos, Kind::Call(receiver.clone(), method, args, *is_virtual)))
    }

    /// An event of another type is only added to and taken from.
    pub(super) fn check_event(&mut self, pos: Pos, id: crate::sema::PropId) {
        let prop = self.sema.prop(id);
        let (owner, name) = (prop.owner, prop.name.clone());
        let is_custom = prop.getter.is_some_and(|getter| self.sema.method(getter).name.starts_with("add_"));
        if !self.sema.prop(id).is_event || self.subscribing {
            return;
        }
        let mut around = Some(self.def);
        while let Some(def) = around {
            if def == owner && !is_custom {
                return;
            }
            around = self.sema.def(def).outer;
        }
        let shown = self.sema.def(owner).name.clone();
        let (code, message) = if is_custom {
            (79, format!("The event '{shown}.{name}' can only appear on the left hand side of += or -="))
        } else {
            (
                70,
                format!(
                    "The event '{shown}.{name}' can only appear on the left hand side of += or -= (except when used from within the type '{shown}')"
                ),
            )
        };
        self.fault(pos, code, message);
    }
}
