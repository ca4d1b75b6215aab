//! Whether evaluating one expression may change a variable that another has in its register.

use super::Emitter;
use crate::bound::{Expr, Kind};
use crate::sema::Sema;
use crate::syntax::ast::Passing;

impl Emitter<'_> {
    /// Whether a local variable, or a field of one, may be set inside.
    pub(super) fn sets_locals(&mut self, e: &Expr) -> bool {
        sets_locals(e, &self.program.sema) && !self.program.is_quiet(e)
    }
}

/// Whether the object that a method is called on may be a struct in a variable, which the method may change.
fn is_variable(e: &Expr, sema: &Sema) -> bool {
    matches!(e.kind, Kind::Local(_) | Kind::This | Kind::Held(_))
        && (sema.is_struct(e.ty) || sema.is_param(e.ty))
}

fn sets_locals(e: &Expr, sema: &Sema) -> bool {
    let one = |e: &Expr| sets_locals(e, sema);
    let any = |list: &[Expr]| list.iter().any(one);
    let args = |list: &[(Passing, Expr)]| list.iter().any(|(p, e)| *p != Passing::Value || one(e));
    let object = |o: Option<&Expr>| o.is_some_and(|o| is_variable(o, sema) || one(o));
    match &e.kind {
        Kind::Const(_)
        | Kind::Default(_)
        | Kind::Local(_)
        | Kind::This
        | Kind::Held(_)
        | Kind::TypeOf(_)
        | Kind::Error
        | Kind::Lambda(_) => false,
        Kind::Assign(..)
        | Kind::Update(..)
        | Kind::Deconstruct(..)
        | Kind::Bind(..)
        | Kind::Block(..)
        | Kind::Initialise(..) => true,
        Kind::Field(o, _) => o.as_deref().is_some_and(one),
        Kind::Element(a, list) => one(a) || any(list),
        Kind::Prop(o, list, ..) => object(o.as_deref()) || args(list),
        Kind::Call(o, _, list, _) => object(o.as_deref()) || args(list),
        Kind::Invoke(o, list) => one(o) || args(list),
        Kind::New(_, list) => args(list),
        Kind::NewArray(_, list)
        | Kind::ArrayOf(_, list, _)
        | Kind::Concat(list)
        | Kind::Tuple(list)
        | Kind::Dynamic(_, list) => any(list),
        Kind::Binary(_, _, _, a, b)
        | Kind::SameObject(_, a, b)
        | Kind::And(a, b)
        | Kind::Or(a, b)
        | Kind::Coalesce(a, b)
        | Kind::Conditional(a, _, b) => one(a) || one(b),
        Kind::Lifted(a, b, _, c, _) | Kind::Choice(a, b, c) => one(a) || one(b) || one(c),
        Kind::IsNull(_, a)
        | Kind::Negate(_, _, a)
        | Kind::Complement(_, a)
        | Kind::Not(a)
        | Kind::Convert(_, a)
        | Kind::Text(a)
        | Kind::Is(a, _)
        | Kind::As(a, _)
        | Kind::Throw(a)
        | Kind::Ref(a)
        | Kind::Deref(a)
        | Kind::Length(a) => one(a),
    }
}
