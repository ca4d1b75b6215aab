//! Functions in functions. One with type parameters becomes a method of the type around it, since each use of it may be
//! of other types; any other is a delegate in a variable.

use std::sync::Arc;

use super::{Binder, Entry, LocalFunction, make};
use crate::bound::{Kind, Stmt};
use crate::sema::MethodId;
use crate::source::Pos;
use crate::syntax::ast::{self, FnBody, Modifiers, Passing};

/// How the names of methods begin that were functions with type parameters in a function.
pub(super) const LIFTED: &str = "<generic>";

impl Binder<'_> {
    /// The signature of a function in a function, and the variable that holds it.
    pub(super) fn declare_function(&mut self, written: &Arc<ast::Method>) -> Option<Arc<LocalFunction>> {
        if !written.type_params.is_empty() {
            let method = self.lift(written);
            self.enter(&written.name, Entry::Lifted(method));
            return None;
        }
        let mut hidden = (**written).clone();
        hidden.name = format!("<local>{}", written.name).into();
        let outer = std::mem::take(&mut self.params);
        let method = self.sema.declare_local(self.def, &Arc::new(hidden), &outer);
        self.params = outer;
        let object = self.sema.known.object;
        let local = self.new_local(&written.name, object, Passing::Value);
        let function = Arc::new(LocalFunction { local, method });
        self.enter(&written.name, Entry::Function(function.clone()));
        Some(function)
    }

    /// A function with type parameters as a method: it sees members, but no variables of the function around.
    fn lift(&mut self, written: &Arc<ast::Method>) -> MethodId {
        let mut hidden = (**written).clone();
        hidden.name = format!("{LIFTED}{}", written.name).into();
        hidden.modifiers = Modifiers::default();
        if self.is_static {
            hidden.modifiers = hidden.modifiers.with("static");
        }
        self.sema.declare_method(self.def, &Arc::new(hidden))
    }

    pub(super) fn local_function(
        &mut self,
        pos: Pos,
        function: &LocalFunction,
        written: &ast::Method,
    ) -> Stmt {
        let info = self.sema.method(function.method).clone();
        let source = super::LambdaSource {
            params: Some(
                written
                    .params
                    .iter()
                    .map(|p| ast::LambdaParam {
                        pos: p.pos,
                        name: p.name.clone(),
                        ty: None,
                        passing: p.passing,
                        carries: Vec::new(),
                    })
                    .collect(),
            ),
            body: Arc::new(written.body.clone().unwrap_or(FnBody::Block(ast::Block {
                pos,
                end: pos,
                stmts: Vec::new(),
            }))),
        };
        let takes: Vec<_> = info.params.iter().map(|p| (p.passing, p.ty)).collect();
        self.next_by_ref = info.by_ref;
        let lambda = self.function_value(pos, &source, &takes, info.ret, written.iterator);
        let place = self.local(function.local, pos);
        let ty = place.ty;
        let set = make(
            ty,
            pos,
            Kind::Assign(Box::new(place), Box::new(make(ty, pos, Kind::Lambda(Arc::new(lambda))))),
        );
        self.expression_stmt(pos, set)
    }
}
