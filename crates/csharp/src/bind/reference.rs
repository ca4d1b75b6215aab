//! References to variables: `ref` variables and methods that give one (C# specification, 9.7 and 13.6.2.4).

use super::{Binder, make};
use crate::bound::{Expr, Kind, Stmt, StmtKind};
use crate::sema::{MethodId, Ty};
use crate::source::Pos;
use crate::syntax::ast::{self, ExprKind, Passing, Variable};

impl Binder<'_> {
    /// What a call gives: the variable behind its result where that is a reference.
    pub(super) fn behind(&mut self, method: MethodId, call: Expr) -> Expr {
        if !self.sema.method(method).by_ref {
            return call;
        }
        make(call.ty, call.pos, Kind::Deref(Box::new(call)))
    }

    /// `ref T a = ref b;`
    pub(super) fn references(
        &mut self,
        ty: Option<&ast::TypeRef>,
        variables: &[Variable],
        fixed: bool,
    ) -> StmtKind {
        let written = ty.map(|ty| self.resolve(ty));
        let mut made = Vec::new();
        for variable in variables {
            let (pos, name) = (variable.pos, &variable.name);
            let place = match &variable.value {
                None => {
                    let message = "A declaration of a by-reference variable must have an initializer";
                    self.error(pos, 8174, message)
                }
                Some(ast::Expr { kind: ExprKind::Ref(inner), .. }) => self.referred(inner),
                Some(other) => {
                    let message = format!("Cannot initialize by-reference variable '{name}' with a value");
                    self.error(other.pos, 8172, message)
                }
            };
            let ty = written.unwrap_or(place.ty);
            let same = self.sema.types.erase(place.ty) == self.sema.types.erase(ty);
            if place.ty != Ty::ERROR && ty != Ty::ERROR && !same {
                let shown = self.show(ty);
                let message = format!(
                    "The expression must be of type '{shown}' because it is being assigned by reference"
                );
                self.fault(place.pos, 8173, message);
            }
            let passing = if fixed { Passing::In } else { Passing::Ref };
            let local = self.declare(pos, name, ty, passing);
            if let Some(info) = self.locals.get_mut(local.0 as usize) {
                info.is_reference = true;
            }
            if !self.outlives(&place) {
                self.short_lived.push(local);
            }
            let bind = make(ty, pos, Kind::Bind(local, Box::new(place)));
            made.push(Stmt { pos, kind: StmtKind::Expr(bind) });
        }
        StmtKind::Several(made)
    }

    /// A fault where a variable that is no reference begins with one.
    pub(super) fn value_from_reference(&mut self, e: &ast::Expr) -> Option<Expr> {
        let ExprKind::Ref(_) = e.kind else { return None };
        let message = "Cannot initialize a by-value variable with a reference";
        Some(self.error(e.pos, 8171, message))
    }

    /// The variable behind `ref`.
    fn referred(&mut self, e: &ast::Expr) -> Expr {
        let place = self.value(e);
        let is_variable = matches!(
            place.kind,
            Kind::Local(_)
                | Kind::Element(..)
                | Kind::Field(..)
                | Kind::Deref(_)
                | Kind::Prop(..)
                | Kind::Error
                | Kind::This
        );
        if !is_variable {
            let message =
                "An expression cannot be used in this context because it may not be returned by reference";
            return self.error(place.pos, 8156, message);
        }
        self.variable(Passing::Ref, place)
    }

    /// The statement of a `return` where a reference is given or wanted; none where neither is.
    pub(super) fn returned_reference(&mut self, pos: Pos, e: &ast::Expr, ty: Ty) -> Option<StmtKind> {
        let by_ref = self.functions.last().is_some_and(|function| function.by_ref);
        match &e.kind {
            ExprKind::Ref(inner) if by_ref => {
                let place = self.referred(inner);
                let same = self.sema.types.erase(place.ty) == self.sema.types.erase(ty);
                if place.ty != Ty::ERROR && !same {
                    let shown = self.show(ty);
                    let message = format!(
                        "The return expression must be of type '{shown}' because this method returns by reference"
                    );
                    self.fault(place.pos, 8151, message);
                }
                if place.ty != Ty::ERROR && !self.outlives(&place) {
                    let message = "Cannot return a variable by reference because it ends with the function it stands in";
                    self.fault(place.pos, 8168, message);
                }
                let value = make(ty, pos, Kind::Ref(Box::new(place)));
                Some(StmtKind::Return(Some(value)))
            }
            ExprKind::Ref(_) => {
                let message = "By-reference returns may only be used in methods that return by reference";
                self.fault(pos, 8149, message);
                Some(StmtKind::Return(None))
            }
            ExprKind::Throw(_) => None,
            _ if by_ref => {
                let message = "By-value returns may only be used in methods that return by value";
                self.fault(pos, 8150, message);
                Some(StmtKind::Return(None))
            }
            _ => None,
        }
    }

    /// Whether a variable is still there when the function has ended.
    fn outlives(&self, place: &Expr) -> bool {
        match &place.kind {
            Kind::Local(id) => {
                !self.short_lived.contains(id)
                    && self.locals.get(id.0 as usize).is_some_and(|l| l.passing != Passing::Value)
            }
            Kind::Field(Some(of), _) if self.sema.is_struct(of.ty) => self.outlives(of),
            Kind::This => false,
            Kind::Deref(call) => {
                let args = match &call.kind {
                    Kind::Call(_, _, args, _) | Kind::Prop(_, args, ..) | Kind::Invoke(_, args) => args,
                    _ => return false,
                };
                args.iter().all(|(passing, arg)| *passing == Passing::Value || self.outlives(arg))
            }
            _ => true,
        }
    }
}
