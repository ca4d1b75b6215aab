//! Arguments once the method is chosen: their order, and what stands for those that are left out.

use super::overload::Source;
use super::{Binder, Item, make};
use crate::bound::{Arg, Expr, Kind};
use crate::sema::{MethodId, Sema, Ty};
use crate::syntax::ast::{self, Passing};

impl Binder<'_> {
    /// Named arguments are worked out in the order in which they stand, not in that of the parameters.
    pub(super) fn in_written_order(&mut self, sources: &[Source], converted: &mut [Arg]) {
        let mut written: Vec<(usize, usize)> = sources
            .iter()
            .enumerate()
            .filter_map(
                |(param, source)| if let Source::Arg(arg) = source { Some((*arg, param)) } else { None },
            )
            .filter(|(_, param)| converted.get(*param).is_some_and(|(passing, _)| *passing == Passing::Value))
            .collect();
        if written.is_sorted() {
            return;
        }
        let first = written.first().map(|(_, param)| *param);
        written.sort_unstable();
        let mut stmts = Vec::new();
        for (_, param) in written {
            let Some((_, value)) = converted.get_mut(param) else { continue };
            let (ty, pos) = (value.ty, value.pos);
            let local = self.new_local("", ty, Passing::Value);
            let value = std::mem::replace(value, make(ty, pos, Kind::Local(local)));
            stmts.push(self.set_local(pos, local, value));
        }
        if let Some((_, value)) = first.and_then(|param| converted.get_mut(param)) {
            let (ty, pos) = (value.ty, value.pos);
            let local = std::mem::replace(value, make(ty, pos, Kind::Error));
            *value = make(ty, pos, Kind::Block(stmts, Box::new(local)));
        }
    }

    pub(super) fn default_value(&mut self, default: &ast::Expr, ty: Ty) -> Expr {
        if matches!(default.kind, ast::ExprKind::Default(_)) {
            // `default(T)`: the type parameter is that of the method.
            return make(ty, default.pos, Kind::Default(ty));
        }
        let item = self.item(default);
        if matches!(&item, Item::Value(v) if v.ty == Ty::NULL) && self.sema.is_param(ty) {
            return make(ty, default.pos, Kind::Default(ty));
        }
        self.convert(item, ty, default.pos)
    }
}

/// Whether the values that parameters have when they are left out are constants of their types (C# specification,
/// 15.6.2): they are looked at where they are declared.
pub(crate) fn check_defaults(sema: &mut Sema, id: MethodId) {
    let info = sema.method(id).clone();
    if sema.vb || info.params.iter().all(|p| p.default.is_none()) || info.name.starts_with("set_") {
        return;
    }
    let mut binder = Binder::new(sema, info.owner, true, &info.type_params);
    for (i, param) in info.params.iter().enumerate() {
        let Some(default) = &param.default else { continue };
        let pos = default.pos;
        match param.passing {
            _ if param.rest => {
                binder.fault(pos, 1751, "Cannot specify a default value for a parameter array");
            }
            _ if i == 0 && info.extends => {
                binder.fault(pos, 1743, "Cannot specify a default value for the 'this' parameter");
            }
            Passing::Ref | Passing::Out => {
                let word = if param.passing == Passing::Ref { "ref" } else { "out" };
                binder.fault(pos, 1741, format!("Cannot specify a default value for the '{word}' parameter"));
            }
            _ => binder.check_default(default, param.ty, &param.name),
        }
    }
}

/// Whether a value is known before anything runs.
fn is_constant(e: &Expr) -> bool {
    match &e.kind {
        Kind::Const(_) | Kind::Default(_) | Kind::Error => true,
        Kind::Convert(_, inner) => is_constant(inner),
        Kind::New(_, args) => args.is_empty(),
        _ => false,
    }
}

impl Binder<'_> {
    fn check_default(&mut self, default: &ast::Expr, ty: Ty, name: &str) {
        let pos = default.pos;
        let item = match self.item(default) {
            Item::Default(_) => return,
            Item::Value(value) if value.ty == Ty::ERROR => return,
            item => item,
        };
        let value = match &item {
            Item::Value(value) => value.clone(),
            _ => make(Ty::NONE, pos, Kind::This),
        };
        let made_struct = !matches!(value.kind, Kind::New(..)) || self.sema.is_value_type(value.ty);
        if !is_constant(&value) || !made_struct {
            let message = format!("Default parameter value for '{name}' must be a compile-time constant");
            self.fault(pos, 1736, message);
            return;
        }
        if ty == Ty::ERROR || self.sema.is_param(ty) {
            return;
        }
        if !self.converts(&item, ty) {
            let (from, to) = (self.show(value.ty), self.show(ty));
            let message = format!(
                "A value of type '{from}' cannot be used as a default parameter because there are no standard conversions to type '{to}'"
            );
            self.fault(pos, 1750, message);
            return;
        }
        let is_null = value.ty == Ty::NULL || matches!(value.kind, Kind::Default(_));
        if !is_null && ty != self.sema.known.string && (self.sema.is_reference(ty) || ty == Ty::DYNAMIC) {
            let shown = self.show(ty);
            let message = format!(
                "'{name}' is of type '{shown}'. A default parameter value of a reference type other than string can only be initialized with null"
            );
            self.fault(pos, 1763, message);
        }
    }
}
