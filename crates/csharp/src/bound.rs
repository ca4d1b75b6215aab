//! Bound trees: every name resolved, every conversion explicit. Nothing in them is C# alone.

use std::collections::HashSet;
use std::sync::{Arc, OnceLock};

use crate::decimal::Decimal;
use crate::sema::{FieldId, MethodId, Prim, Ty};
use crate::source::Pos;
use crate::syntax::ast::{Name, Passing};

/// A value known before anything runs; its type stands beside it.
#[derive(Debug, Clone, PartialEq)]
pub enum Const {
    /// `null`, and the default of any type.
    Null,
    /// A truth value.
    Bool(bool),
    /// Whole numbers, characters and members of enums.
    Int(i128),
    /// `float`
    Float(f32),
    /// `double`
    Double(f64),
    /// `decimal`
    Decimal(Decimal),
    /// A text.
    Str(Arc<[u16]>),
}

/// A variable of a function.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) struct LocalId(pub u32);

/// A variable.
#[derive(Debug, Clone)]
pub(crate) struct Local {
    /// The name.
    pub name: Name,
    /// The type.
    pub ty: Ty,
    /// How a parameter is handed over.
    pub passing: Passing,
    /// Whether it is a reference to a variable, declared in the function itself.
    pub is_reference: bool,
    /// How many lambdas stand around its declaration.
    pub depth: u32,
    /// Whether a lambda uses it that is not around its declaration.
    pub captured: bool,
}

/// A method of a type, both with their type arguments.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct MethodRef {
    /// The method.
    pub id: MethodId,
    /// The type.
    pub owner: Ty,
    /// Type arguments of the method.
    pub args: Vec<Ty>,
}

/// A field of a type with its type arguments.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) struct FieldRef {
    /// The field.
    pub id: FieldId,
    /// The type.
    pub owner: Ty,
}

/// An expression.
#[derive(Debug, Clone)]
pub(crate) struct Expr {
    /// Its type.
    pub ty: Ty,
    /// Its place.
    pub pos: Pos,
    /// What it is.
    pub kind: Kind,
}

/// Operations on two numbers or truth values of one type.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[allow(missing_docs, reason = "their names say it")]
pub enum Op {
    Add,
    Sub,
    Mul,
    Div,
    Rem,
    Shl,
    Shr,
    And,
    Or,
    Xor,
    Eq,
    Ne,
    Lt,
    Le,
    Gt,
    Ge,
}

/// How a value becomes one of another type.
#[derive(Debug, Clone)]
pub(crate) enum Conv {
    /// It stays as it is.
    Same,
    /// A number of one predefined type becomes one of another, with a check for overflow.
    Number(Prim, Prim, bool),
    /// A number becomes a member of an enum.
    ToEnum,
    /// A member of an enum becomes a number.
    FromEnum(Prim),
    /// A reference, or what was boxed, is checked to be of the type.
    Cast,
    /// A value is there or an exception is thrown.
    FromNullable,
}

/// An argument of a call: by value or as a reference to a variable.
pub(crate) type Arg = (Passing, Expr);

/// A lambda.
#[derive(Debug, Clone)]
pub(crate) struct Lambda {
    /// Its parameters.
    pub params: Vec<LocalId>,
    /// What it does.
    pub body: Stmt,
    /// What an iterator gives.
    pub iterator: Option<Ty>,
    /// What it was made of.
    pub origin: Origin,
}

/// What the function behind a delegate was made of: by it two delegates are compared.
#[derive(Debug, Clone, Default, PartialEq)]
pub enum Origin {
    /// A lambda, or a function in a function.
    #[default]
    Written,
    /// A method; whether the object it is called on is the first captured variable.
    Method(MethodRef, bool),
    /// Several delegates in a row: the first captured variable is the array of them.
    Joined,
}

/// Forms of expressions.
#[derive(Debug, Clone)]
pub(crate) enum Kind {
    /// A value.
    Const(Const),
    /// The default value of a type.
    Default(Ty),
    /// A variable.
    Local(LocalId),
    /// The object itself.
    This,
    /// The value that an enclosing [`Kind::Update`], [`Kind::Conditional`] or [`Kind::Initialise`] has at hand.
    Held(u32),
    /// A field.
    Field(Option<Box<Expr>>, FieldRef),
    /// An element of an array.
    Element(Box<Expr>, Vec<Expr>),
    /// The length of an array of one dimension.
    Length(Box<Expr>),
    /// A property or indexer: receiver, arguments, getter and setter, whether the call is virtual.
    Prop(Option<Box<Expr>>, Vec<Arg>, Option<MethodRef>, Option<MethodRef>, bool),
    /// A call; the last says whether it is virtual.
    Call(Option<Box<Expr>>, MethodRef, Vec<Arg>, bool),
    /// The call of a delegate.
    Invoke(Box<Expr>, Vec<Arg>),
    /// A new object.
    New(MethodRef, Vec<Arg>),
    /// A new array of so many elements along each dimension.
    NewArray(Ty, Vec<Expr>),
    /// A new array of these elements; lengths for several dimensions.
    ArrayOf(Ty, Vec<Expr>, Vec<u32>),
    /// An operation on two values of a predefined type.
    Binary(Op, Prim, bool, Box<Expr>, Box<Expr>),
    /// An operation on values that may be missing: what is done with `Held` of both numbers when neither is, and the
    /// value when one is.
    Lifted(Box<Expr>, Box<Expr>, u32, Box<Expr>, Const),
    /// Two references are the same object, or are not.
    SameObject(bool, Box<Expr>, Box<Expr>),
    /// Whether a value is missing, or is not.
    IsNull(bool, Box<Expr>),
    /// `-a` with a check for overflow.
    Negate(Prim, bool, Box<Expr>),
    /// `~a`
    Complement(Prim, Box<Expr>),
    /// `!a`
    Not(Box<Expr>),
    /// `a && b`
    And(Box<Expr>, Box<Expr>),
    /// `a || b`
    Or(Box<Expr>, Box<Expr>),
    /// A conversion.
    Convert(Conv, Box<Expr>),
    /// Texts in a row.
    Concat(Vec<Expr>),
    /// The text of a value, empty where it is missing.
    Text(Box<Expr>),
    /// An assignment.
    Assign(Box<Expr>, Box<Expr>),
    /// A variable is set to a value made of the old one, which is `Held`; whether the old value is the result.
    Update(Box<Expr>, u32, Box<Expr>, bool),
    /// `a ? b : c`
    Choice(Box<Expr>, Box<Expr>, Box<Expr>),
    /// `a ?? b`
    Coalesce(Box<Expr>, Box<Expr>),
    /// `a?.b`: the second with `Held` as `a` when it is not null.
    Conditional(Box<Expr>, u32, Box<Expr>),
    /// A reference to a variable.
    Ref(Box<Expr>),
    /// The variable behind a reference that a call gives.
    Deref(Box<Expr>),
    /// A variable becomes a reference to another one.
    Bind(LocalId, Box<Expr>),
    /// A new object as `Held`, what is done with it, and it is the result.
    Initialise(Box<Expr>, u32, Vec<Expr>),
    /// Whether a value is of a type.
    Is(Box<Expr>, Ty),
    /// The value if it is of the type, else null.
    As(Box<Expr>, Ty),
    /// A lambda as a delegate.
    Lambda(Arc<Lambda>),
    /// `typeof`
    TypeOf(Ty),
    /// An exception is thrown.
    Throw(Box<Expr>),
    /// A tuple.
    Tuple(Vec<Expr>),
    /// A tuple's elements are set to variables or dropped: the value as `Held`, and assignments.
    Deconstruct(Box<Expr>, u32, Vec<Expr>),
    /// Statements before a value.
    Block(Vec<Stmt>, Box<Expr>),
    /// An operation that is resolved when it runs.
    Dynamic(DynamicOp, Vec<Expr>),
    /// What a fault left.
    Error,
}

/// Operations resolved when they run.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum DynamicOp {
    /// A member's value.
    Get(Name),
    /// A member is set.
    Set(Name),
    /// A method of an object.
    Call(Name),
    /// An element.
    Index,
    /// An element is set.
    SetIndex,
    /// An operator.
    Binary(crate::syntax::ast::BinaryOp),
    /// An operator of one operand.
    Unary(crate::syntax::ast::UnaryOp),
    /// A delegate's call.
    Invoke,
    /// A cast.
    Convert(Ty),
}

/// A statement.
#[derive(Debug, Clone)]
pub(crate) struct Stmt {
    /// Its place.
    pub pos: Pos,
    /// What it is.
    pub kind: StmtKind,
}

/// A place that is jumped to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) struct Label(pub u32);

/// A `catch`.
#[derive(Debug, Clone)]
pub(crate) struct Catch {
    /// The type that it catches.
    pub ty: Ty,
    /// The variable that holds the exception.
    pub local: Option<LocalId>,
    /// The condition.
    pub filter: Option<Expr>,
    /// What is done.
    pub body: Stmt,
}

/// Forms of statements.
#[derive(Debug, Clone)]
pub(crate) enum StmtKind {
    /// Statements with the variables they declare.
    Block(Vec<LocalId>, Vec<Stmt>),
    /// Statements that share the variables around them.
    Several(Vec<Stmt>),
    /// An expression for its effect.
    Expr(Expr),
    /// `if`
    If(Expr, Box<Stmt>, Option<Box<Stmt>>),
    /// A loop: condition tested first, body, step; labels of `break` and `continue`.
    Loop(Option<Expr>, Box<Stmt>, Vec<Expr>, Label, Label),
    /// `do`
    DoLoop(Box<Stmt>, Expr, Label, Label),
    /// A place that is jumped to.
    Label(Label),
    /// A jump.
    Goto(Label),
    /// `return`
    Return(Option<Expr>),
    /// `throw`
    Throw(Option<Expr>),
    /// `try`
    Try(Box<Stmt>, Vec<Catch>, Option<Box<Stmt>>),
    /// `yield return`, and `yield break` without a value.
    Yield(Option<Expr>),
}

/// The body of a method.
#[derive(Debug, Clone)]
pub(crate) struct Body {
    /// All variables of it and of the lambdas in it.
    pub locals: Vec<Local>,
    /// Its parameters.
    pub params: Vec<LocalId>,
    /// What it does.
    pub stmt: Stmt,
    /// Whether a lambda in it uses the object itself.
    pub captures_this: bool,
    /// Whether it is an iterator, and of what.
    pub iterator: Option<Ty>,
    /// How its variables are used, once somebody asked.
    pub uses: OnceLock<Uses>,
}

/// How the variables of a body are used.
#[derive(Debug, Clone, Default)]
pub(crate) struct Uses {
    /// Those that must stand in one place: references to them are handed over, properties of theirs are set, or what
    /// comes after an exception may look at them.
    pub whole: HashSet<LocalId>,
    /// Those that references are handed over to, or to a part of them: the object of a struct stays when it is set.
    pub stays: HashSet<LocalId>,
    /// Methods that are called on variables.
    pub called: Vec<(LocalId, MethodId)>,
}
