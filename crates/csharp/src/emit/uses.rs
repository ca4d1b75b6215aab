//! How the variables of a body are used: which of them must stand in one place.

use std::collections::HashMap;

use crate::bound::{Arg, Body, Expr, Kind, LocalId, Stmt, StmtKind, Uses};
use crate::syntax::ast::Passing;

impl Body {
    /// How its variables are used.
    pub(super) fn uses(&self) -> &Uses {
        self.uses.get_or_init(|| {
            let mut look = Look { uses: Uses::default(), tries: 0, declared: HashMap::new() };
            look.stmt(&self.stmt);
            look.uses
        })
    }
}

/// The expressions that stand directly in one; statements that stand in it are given to `inner`.
pub(super) fn each_operand<'e>(e: &'e Expr, take: &mut dyn FnMut(&'e Expr), inner: &mut dyn FnMut(&'e Stmt)) {
    match &e.kind {
        Kind::Const(_)
        | Kind::Default(_)
        | Kind::Local(_)
        | Kind::This
        | Kind::Held(_)
        | Kind::TypeOf(_)
        | Kind::Error => {}
        Kind::Field(o, _) => o.iter().for_each(|o| take(o)),
        Kind::Element(a, list) => {
            take(a);
            list.iter().for_each(take);
        }
        Kind::Prop(o, args, ..) | Kind::Call(o, _, args, _) => {
            o.iter().for_each(|o| take(o));
            args.iter().for_each(|(_, e)| take(e));
        }
        Kind::Invoke(o, args) => {
            take(o);
            args.iter().for_each(|(_, e)| take(e));
        }
        Kind::New(_, args) => args.iter().for_each(|(_, e)| take(e)),
        Kind::NewArray(_, list)
        | Kind::ArrayOf(_, list, _)
        | Kind::Concat(list)
        | Kind::Tuple(list)
        | Kind::Dynamic(_, list) => list.iter().for_each(take),
        Kind::Binary(_, _, _, a, b)
        | Kind::SameObject(_, a, b)
        | Kind::And(a, b)
        | Kind::Or(a, b)
        | Kind::Coalesce(a, b)
        | Kind::Conditional(a, _, b)
        | Kind::Assign(a, b)
        | Kind::Update(a, _, b, _) => {
            take(a);
            take(b);
        }
        Kind::Lifted(a, b, _, c, _) | Kind::Choice(a, b, c) => {
            take(a);
            take(b);
            take(c);
        }
        Kind::Initialise(a, _, list) | Kind::Deconstruct(a, _, list) => {
            take(a);
            list.iter().for_each(take);
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
        | Kind::Bind(_, a)
        | Kind::Length(a) => take(a),
        Kind::Lambda(lambda) => inner(&lambda.body),
        Kind::Block(list, value) => {
            list.iter().for_each(inner);
            take(value);
        }
    }
}

/// The variable that a place is in, itself or a part of it.
pub(super) fn variable_of(e: &Expr) -> Option<LocalId> {
    match &e.kind {
        Kind::Local(id) => Some(*id),
        Kind::Field(Some(inner), _) | Kind::Convert(_, inner) => variable_of(inner),
        _ => None,
    }
}

/// Whether a variable stands in an expression.
pub(super) fn mentions(e: &Expr, id: LocalId) -> bool {
    let mut found = matches!(e.kind, Kind::Local(other) if other == id);
    let mut has_statements = false;
    each_operand(e, &mut |inner| found = found || mentions(inner, id), &mut |_| has_statements = true);
    found || has_statements
}

struct Look {
    uses: Uses,
    /// How many `try` stand around what is looked at.
    tries: u32,
    /// How many stand around the declaration of a variable.
    declared: HashMap<LocalId, u32>,
}

impl Look {
    fn stmts(&mut self, list: &[Stmt]) {
        list.iter().for_each(|stmt| self.stmt(stmt));
    }

    fn stmt(&mut self, stmt: &Stmt) {
        match &stmt.kind {
            StmtKind::Block(locals, list) => {
                self.declared.extend(locals.iter().map(|local| (*local, self.tries)));
                self.stmts(list);
            }
            StmtKind::Several(list) => self.stmts(list),
            StmtKind::Expr(e) => self.expr(e),
            StmtKind::If(c, yes, no) => {
                self.expr(c);
                self.stmt(yes);
                no.iter().for_each(|no| self.stmt(no));
            }
            StmtKind::Loop(c, body, steps, ..) => {
                c.iter().chain(steps).for_each(|e| self.expr(e));
                self.stmt(body);
            }
            StmtKind::DoLoop(body, c, ..) => {
                self.stmt(body);
                self.expr(c);
            }
            StmtKind::Label(_) | StmtKind::Goto(_) => {}
            StmtKind::Return(e) | StmtKind::Throw(e) | StmtKind::Yield(e) => {
                e.iter().for_each(|e| self.expr(e));
            }
            StmtKind::Try(body, catches, finally) => {
                self.tries += 1;
                self.stmt(body);
                for catch in catches {
                    catch.filter.iter().for_each(|e| self.expr(e));
                    self.stmt(&catch.body);
                }
                finally.iter().for_each(|stmt| self.stmt(stmt));
                self.tries -= 1;
            }
        }
    }

    fn keep_whole(&mut self, place: &Expr) {
        self.uses.whole.extend(variable_of(place));
    }

    /// A place that a reference is handed over to.
    fn referenced(&mut self, place: &Expr) {
        self.keep_whole(place);
        self.uses.stays.extend(variable_of(place));
    }

    /// The object of a call.
    fn object(&mut self, object: &Expr, method: Option<&crate::bound::MethodRef>) {
        match (&object.kind, method) {
            (Kind::Local(id), Some(method)) => self.uses.called.push((*id, method.id)),
            _ => self.keep_whole(object),
        }
    }

    fn arguments(&mut self, args: &[Arg]) {
        for (passing, arg) in args {
            if *passing != Passing::Value {
                self.referenced(arg);
            }
        }
    }

    /// What is set: the object behind a property must not be one that was put together for it.
    fn target(&mut self, place: &Expr) {
        match &place.kind {
            Kind::Prop(Some(object), ..) => self.keep_whole(object),
            Kind::Convert(_, inner) => self.target(inner),
            _ => {}
        }
    }

    fn expr(&mut self, e: &Expr) {
        match &e.kind {
            Kind::Local(id) if self.tries > self.declared.get(id).copied().unwrap_or(0) => {
                self.uses.whole.insert(*id);
            }
            Kind::Assign(place, _) | Kind::Update(place, ..) => self.target(place),
            Kind::Prop(Some(object), args, getter, ..) => {
                self.object(object, getter.as_ref());
                self.arguments(args);
            }
            Kind::Call(Some(object), method, args, _) => {
                self.object(object, Some(method));
                self.arguments(args);
            }
            Kind::Prop(None, args, ..)
            | Kind::Call(None, _, args, _)
            | Kind::Invoke(_, args)
            | Kind::New(_, args) => {
                self.arguments(args);
            }
            Kind::Ref(place) => self.referenced(place),
            Kind::Bind(local, place) => {
                self.uses.whole.insert(*local);
                self.referenced(place);
            }
            Kind::Dynamic(_, operands) => operands.iter().for_each(|e| self.keep_whole(e)),
            _ => {}
        }
        let (mut operands, mut statements) = (Vec::new(), Vec::new());
        each_operand(e, &mut |operand| operands.push(operand), &mut |stmt| statements.push(stmt));
        operands.into_iter().for_each(|operand| self.expr(operand));
        statements.into_iter().for_each(|stmt| self.stmt(stmt));
    }
}
