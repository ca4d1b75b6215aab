//! Variables and the blocks that they live in.

use super::{Binder, Entry, Scope};
use crate::bound::{Expr, Kind, Local, LocalId};
use crate::sema::Ty;
use crate::source::Pos;
use crate::syntax::ast::{Name, Passing};

impl Binder<'_> {
    fn depth(&self) -> u32 {
        (self.functions.len() as u32).saturating_sub(1)
    }

    /// A variable that has no name in the source.
    pub(super) fn new_local(&mut self, name: &str, ty: Ty, passing: Passing) -> LocalId {
        let id = LocalId(self.locals.len() as u32);
        let depth = self.depth();
        self.locals.push(Local {
            name: name.into(),
            ty,
            passing,
            depth,
            captured: false,
            is_reference: false,
        });
        if let Some(scope) = self.scopes.last_mut() {
            scope.locals.push(id);
        }
        id
    }

    /// Declares a variable in the innermost block.
    pub(super) fn declare(&mut self, pos: Pos, name: &Name, ty: Ty, passing: Passing) -> LocalId {
        self.check_fresh(pos, name);
        let id = self.new_local(name, ty, passing);
        self.enter(name, Entry::Local(id));
        id
    }

    pub(super) fn enter(&mut self, name: &Name, entry: Entry) {
        if let Some(scope) = self.scopes.last_mut() {
            scope.names.push((name.clone(), entry));
        }
    }

    fn check_fresh(&mut self, pos: Pos, name: &Name) {
        let base = self.functions.last().map_or(0, |f| f.base);
        let count = self.scopes.len();
        for (i, scope) in self.scopes.iter().enumerate().rev() {
            if scope.names.iter().any(|(n, _)| n == name) {
                let message = if i + 1 == count {
                    (
                        128,
                        format!(
                            "A local variable or function named '{name}' is already defined in this scope"
                        ),
                    )
                } else {
                    (
                        136,
                        format!(
                            "A local or parameter named '{name}' cannot be declared in this scope because that name is used in an enclosing local scope to define a local or parameter"
                        ),
                    )
                };
                let _ = base;
                self.fault(pos, message.0, message.1);
                return;
            }
        }
    }

    pub(super) fn find(&self, name: &Name) -> Option<Entry> {
        self.scopes.iter().rev().find_map(|scope| {
            scope.names.iter().rev().find(|(n, _)| n == name).map(|(_, entry)| entry.clone())
        })
    }

    /// The value of a variable; it is captured when a lambda stands between it and here.
    pub(super) fn local(&mut self, id: LocalId, pos: Pos) -> Expr {
        let depth = self.depth();
        let Some(local) = self.locals.get_mut(id.0 as usize) else { return self.wrong(pos) };
        let ty = local.ty;
        if local.depth < depth {
            local.captured = true;
            if local.is_reference {
                let name = local.name.clone();
                self.fault(pos, 8175, format!("Cannot use ref local '{name}' inside an anonymous method, lambda expression, or query expression"));
            } else if local.passing != Passing::Value {
                let name = local.name.clone();
                self.fault(pos, 1628, format!("Cannot use ref, out, or in parameter '{name}' inside an anonymous method, lambda expression, query expression, or local function"));
            }
        }
        Expr { ty, pos, kind: Kind::Local(id) }
    }

    /// Binds something in a block of its own, and gives the variables declared in it.
    pub(super) fn in_scope<T>(&mut self, run: impl FnOnce(&mut Self) -> T) -> (T, Vec<LocalId>) {
        self.scopes.push(Scope::default());
        let result = run(self);
        let locals = self.scopes.pop().map(|s| s.locals).unwrap_or_default();
        (result, locals)
    }
}
