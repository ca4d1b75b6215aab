//! Arguments once the method is chosen: their order, and what stands for those that are left out.

use super::overload::Source;
use super::{Binder, Item, make};
use crate::bound::{Arg, Expr, Kind};
use crate::sema::Ty;
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
