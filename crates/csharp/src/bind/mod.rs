//! Syntax trees to bound trees: names to what they stand for, expressions to types, conversions made explicit.

mod arguments;
mod assign;
mod assigned;
mod assigned_set;
mod call;
mod constant;
mod convert;
mod create;
mod deconstruct;
mod delegate;
mod dynamic;
mod expression;
mod infer;
mod lambda;
mod local_function;
mod loops;
mod member;
mod method;
mod name;
mod operator;
mod overload;
mod pattern;
mod reference;
mod refusal;
mod scope;
mod statement;
mod switch;
mod text;
mod unary;

use std::collections::HashMap;
use std::sync::Arc;

use crate::bound::{Expr, Kind, Label, Local, LocalId};
use crate::sema::{DefId, MethodId, NameScope, ParamId, Sema, Ty};
use crate::source::Pos;
use crate::syntax::ast::{self, LambdaParam, Name};

pub(crate) use arguments::check_defaults;
pub(crate) use constant::wrap;
pub(crate) use dynamic::bind_dynamic;
pub(crate) use method::{bind_method, bind_static_init, constant_of};

/// How many expressions are bound for one method: lambdas are bound again for each overload.
const MAX_WORK: u32 = 400_000;

/// What an expression can be, before it has to be a value.
#[derive(Debug, Clone)]
enum Item {
    Value(Expr),
    Type(Ty),
    Namespace(String),
    Methods(Box<Group>),
    Lambda(Pos, Arc<LambdaSource>),
    Default(Pos),
    /// `out var x`, `out _`.
    OutVar(Pos, Option<Name>),
    /// `new(...)`
    New(Pos, Arc<(Vec<ast::Arg>, Option<ast::Init>)>),
    /// A tuple whose elements have no type yet.
    Tuple(Pos, Vec<(Option<Name>, Item)>),
    /// `throw` as a value.
    Throw(Expr),
    /// A condition or switch whose branches have no common type of their own.
    Untyped(Pos, Arc<ast::Expr>),
}

#[derive(Debug)]
struct LambdaSource {
    params: Option<Vec<LambdaParam>>,
    body: Arc<ast::FnBody>,
}

/// Methods with one name, and what they are called on.
#[derive(Debug, Clone)]
struct Group {
    pos: Pos,
    receiver: Option<Expr>,
    on: Option<Ty>,
    name: Name,
    type_args: Vec<Ty>,
    candidates: Vec<(Ty, MethodId)>,
    /// Called through `base`: not virtual.
    base: bool,
    /// The receiver was a name that may also be a type.
    color: Option<Ty>,
}

#[derive(Debug, Clone)]
enum Entry {
    Local(LocalId),
    /// A range variable inside the parameter that carries it.
    Carried(LocalId, Name),
    Constant(Expr),
    Function(Arc<LocalFunction>),
    /// A function with type parameters, as a method.
    Lifted(MethodId),
}

#[derive(Debug)]
struct LocalFunction {
    local: LocalId,
    method: MethodId,
}

#[derive(Debug, Default)]
struct Scope {
    names: Vec<(Name, Entry)>,
    locals: Vec<LocalId>,
}

/// What `return` means in the function that is being bound.
#[derive(Debug, Clone)]
enum Returns {
    /// A value of a type, or none for `void`.
    Type(Ty),
    /// Whatever comes is collected: types, and whether something without a type came.
    Infer(Vec<Ty>, bool),
}

#[derive(Debug)]
struct Function {
    returns: Returns,
    /// What an iterator gives.
    yields: Option<Ty>,
    /// Whether `return` gives a reference to a variable.
    by_ref: bool,
    /// Scopes that existed before it.
    base: usize,
}

#[derive(Debug, Clone, Copy)]
struct Jump {
    brk: Option<Label>,
    cont: Option<Label>,
    depth: u32,
}

/// A switch that `goto case` looks in.
#[derive(Debug, Default)]
struct Cases {
    constants: Vec<(crate::bound::Const, Label)>,
    default: Option<Label>,
    ty: Option<Ty>,
}

/// Binds the bodies of one type's members.
pub(crate) struct Binder<'a> {
    sema: &'a mut Sema,
    def: DefId,
    this: Ty,
    is_static: bool,
    params: Vec<ParamId>,
    locals: Vec<Local>,
    scopes: Vec<Scope>,
    functions: Vec<Function>,
    jumps: Vec<Jump>,
    cases: Vec<Cases>,
    labels: HashMap<Name, Label>,
    next_label: u32,
    next_held: u32,
    receivers: Vec<Expr>,
    checked: bool,
    /// Inside `unchecked`, where constants may wrap.
    unchecked: bool,
    captures_this: bool,
    /// Variables of `foreach`, `using` and the like, which cannot be set.
    readonly_locals: Vec<crate::bound::LocalId>,
    /// References to variables that end with the function.
    short_lived: Vec<crate::bound::LocalId>,
    /// Whether the function that is bound next gives a reference.
    next_by_ref: bool,
    work: u32,
    nesting: u32,
    /// In the constructor, where readonly fields may be set.
    constructor: bool,
    /// In the first value of a field, which sees no object.
    in_field_value: bool,
    /// On the left of `+=` or `-=`, where events of other types may stand.
    subscribing: bool,
}

/// How deep bound expressions may be.
const MAX_NESTING: u32 = 500;

impl<'a> Binder<'a> {
    /// Whether what is bound was written in VB: the library never was.
    fn is_vb(&self) -> bool {
        self.sema.vb && !self.sema.def(self.def).library
    }

    fn new(sema: &'a mut Sema, def: DefId, is_static: bool, params: &[ParamId]) -> Self {
        let this = sema.open(def);
        Self {
            sema,
            def,
            this,
            is_static,
            params: params.to_vec(),
            locals: Vec::new(),
            scopes: vec![Scope::default()],
            functions: Vec::new(),
            jumps: Vec::new(),
            cases: Vec::new(),
            labels: HashMap::new(),
            next_label: 0,
            next_held: 0,
            receivers: Vec::new(),
            checked: false,
            unchecked: false,
            captures_this: false,
            readonly_locals: Vec::new(),
            short_lived: Vec::new(),
            next_by_ref: false,
            work: 0,
            nesting: 0,
            constructor: false,
            in_field_value: false,
            subscribing: false,
        }
    }

    fn fault(&mut self, pos: Pos, code: u16, message: impl Into<String>) {
        self.sema.fault(pos, code, message);
    }

    fn error(&mut self, pos: Pos, code: u16, message: impl Into<String>) -> Expr {
        self.fault(pos, code, message);
        self.wrong(pos)
    }

    fn wrong(&self, pos: Pos) -> Expr {
        Expr { ty: Ty::ERROR, pos, kind: Kind::Error }
    }

    fn show(&self, ty: Ty) -> String {
        self.sema.show(ty)
    }

    fn name_scope(&self) -> NameScope {
        self.sema.scope_of(self.def, &self.params)
    }

    fn resolve(&mut self, ty: &ast::TypeRef) -> Ty {
        let scope = self.name_scope();
        self.sema.resolve(ty, &scope)
    }

    fn label(&mut self) -> Label {
        self.next_label += 1;
        Label(self.next_label)
    }

    /// A value at hand under a number of its own.
    fn held(&mut self, ty: Ty, pos: Pos) -> (u32, Expr) {
        self.next_held += 1;
        (self.next_held, Expr { ty, pos, kind: Kind::Held(self.next_held) })
    }

    /// Tries something; what it says is dropped when it fails. Gives the result when it brought no faults.
    fn speculate<T>(&mut self, run: impl FnOnce(&mut Self) -> T) -> Option<T> {
        let faults = self.sema.faults.len();
        let full = faults >= 200;
        let state = (
            self.scopes.len(),
            self.functions.len(),
            self.jumps.len(),
            self.receivers.len(),
            self.cases.len(),
            self.nesting,
        );
        let names = self.scopes.last().map_or(0, |s| s.names.len());
        let result = run(self);
        self.scopes.truncate(state.0);
        self.functions.truncate(state.1);
        self.jumps.truncate(state.2);
        self.receivers.truncate(state.3);
        self.cases.truncate(state.4);
        self.nesting = state.5;
        let clean = self.sema.faults.len() == faults && !full;
        self.sema.faults.truncate(faults);
        if let Some(scope) = self.scopes.last_mut() {
            scope.names.truncate(names);
        }
        clean.then_some(result)
    }
}

fn make(ty: Ty, pos: Pos, kind: Kind) -> Expr {
    Expr { ty, pos, kind }
}
