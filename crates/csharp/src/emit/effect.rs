//! Whether evaluating one expression may change a variable that another has in its register.

use crate::bound::{Expr, Kind};
use crate::syntax::ast::Passing;

/// Whether a local variable may be set inside.
pub(super) fn sets_locals(e: &Expr) -> bool {
    let any = |list: &[Expr]| list.iter().any(sets_locals);
    let args = |list: &[(Passing, Expr)]| list.iter().any(|(p, e)| *p != Passing::Value || sets_locals(e));
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
        Kind::Field(o, _) => o.as_deref().is_some_and(sets_locals),
        Kind::Element(a, list) => sets_locals(a) || any(list),
        Kind::Prop(o, list, ..) => o.as_deref().is_some_and(sets_locals) || args(list),
        Kind::Call(o, _, list, _) => o.as_deref().is_some_and(sets_locals) || args(list),
        Kind::Invoke(o, list) => sets_locals(o) || args(list),
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
        | Kind::Conditional(a, _, b) => sets_locals(a) || sets_locals(b),
        Kind::Lifted(a, b, _, c, _) | Kind::Choice(a, b, c) => {
            sets_locals(a) || sets_locals(b) || sets_locals(c)
        }
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
        | Kind::Length(a) => sets_locals(a),
    }
}
