//! Syntax trees: what the text says, before anything is known of its names.

use std::sync::Arc;

pub(crate) use super::declaration::*;
pub(crate) use super::token::{IntSuffix, Name};
use crate::source::Pos;

/// A type as written.
#[derive(Debug, Clone)]
pub struct TypeRef {
    /// Its place.
    pub pos: Pos,
    /// What it is.
    pub kind: TypeRefKind,
}

/// Forms of types.
#[derive(Debug, Clone)]
pub enum TypeRefKind {
    /// A name, with its qualifiers before it.
    Named(Vec<NamePart>),
    /// An array of so many dimensions.
    Array(Box<TypeRef>, u8),
    /// `T?`
    Nullable(Box<TypeRef>),
    /// `(int a, string b)`
    Tuple(Vec<(TypeRef, Option<Name>)>),
    /// `var`
    Var,
}

/// A name with type arguments.
#[derive(Debug, Clone)]
pub struct NamePart {
    /// The place.
    pub pos: Pos,
    /// The name.
    pub name: Name,
    /// The type arguments.
    pub args: Vec<TypeRef>,
    /// For `List<>`: how many arguments are left out.
    pub open: u8,
}

/// An expression at its place.
#[derive(Debug, Clone)]
pub struct Expr {
    /// The place.
    pub pos: Pos,
    /// What it is.
    pub kind: ExprKind,
}

/// A value written out.
#[derive(Debug, Clone)]
pub enum Lit {
    /// `null`
    Null,
    /// `true`, `false`
    Bool(bool),
    /// A whole number.
    Int(u64, IntSuffix),
    /// A number.
    Double(f64),
    /// A number with `f`.
    Float(f32),
    /// A number with `m`.
    Decimal(Name),
    /// A character.
    Char(u16),
    /// A text.
    Str(Arc<[u16]>),
}

/// Operators of one operand.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum UnaryOp {
    /// `+`
    Plus,
    /// `-`
    Minus,
    /// `!`
    Not,
    /// `~`
    Complement,
}

/// Operators of two operands.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[allow(missing_docs, reason = "their names say it")]
pub enum BinaryOp {
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
    AndAlso,
    OrElse,
    Eq,
    Ne,
    Lt,
    Le,
    Gt,
    Ge,
    Coalesce,
}

impl BinaryOp {
    /// As it is written.
    pub fn symbol(self) -> &'static str {
        match self {
            Self::Add => "+",
            Self::Sub => "-",
            Self::Mul => "*",
            Self::Div => "/",
            Self::Rem => "%",
            Self::Shl => "<<",
            Self::Shr => ">>",
            Self::And => "&",
            Self::Or => "|",
            Self::Xor => "^",
            Self::AndAlso => "&&",
            Self::OrElse => "||",
            Self::Eq => "==",
            Self::Ne => "!=",
            Self::Lt => "<",
            Self::Le => "<=",
            Self::Gt => ">",
            Self::Ge => ">=",
            Self::Coalesce => "??",
        }
    }
}

/// How an argument or parameter is handed over.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Passing {
    /// By value.
    Value,
    /// `ref`
    Ref,
    /// `out`
    Out,
    /// `in`
    In,
}

/// An argument.
#[derive(Debug, Clone)]
pub struct Arg {
    /// `name:` before it.
    pub name: Option<Name>,
    /// `ref`, `out` or `in` before it.
    pub passing: Passing,
    /// The value.
    pub value: Expr,
}

/// A piece of an interpolated text.
#[derive(Debug, Clone)]
pub enum TextPiece {
    /// Characters.
    Text(Arc<[u16]>),
    /// A value, its alignment and its format.
    Hole(Box<Expr>, Option<Box<Expr>>, Option<Name>),
}

/// A parameter of a lambda.
#[derive(Debug, Clone)]
pub struct LambdaParam {
    /// The place.
    pub pos: Pos,
    /// The name.
    pub name: Name,
    /// The type, when written.
    pub ty: Option<TypeRef>,
    /// `ref`, `out` or `in`.
    pub passing: Passing,
    /// For the range variables of a query: names that stand for members of this parameter.
    pub carries: Vec<Name>,
}

/// The body of a function.
#[derive(Debug, Clone)]
pub enum FnBody {
    /// `=> value`
    Expr(Box<Expr>),
    /// `{ }`
    Block(Block),
}

/// What follows `{` behind `new T()`.
#[derive(Debug, Clone)]
pub enum Init {
    /// Members or indexed elements that are set.
    Members(Vec<(InitTarget, InitValue)>),
    /// Elements that are added, each with the arguments of `Add`.
    Elements(Vec<Vec<Expr>>),
}

/// What an initialiser sets.
#[derive(Debug, Clone)]
pub enum InitTarget {
    /// A member.
    Member(Pos, Name),
    /// An element.
    Index(Pos, Vec<Arg>),
}

/// What it is set to.
#[derive(Debug, Clone)]
pub enum InitValue {
    /// A value.
    Value(Expr),
    /// Members or elements of what is there.
    Nested(Init),
}

/// Forms of expressions.
#[derive(Debug, Clone)]
pub enum ExprKind {
    /// A value.
    Lit(Lit),
    /// `$"..."`
    Interpolated(Vec<TextPiece>),
    /// A name.
    Name(NamePart),
    /// A predefined type, before a dot.
    Type(TypeRef),
    /// `a.b`
    Member(Box<Expr>, NamePart),
    /// `a?.b`: the receiver, and what is done with [`ExprKind::Receiver`].
    Conditional(Box<Expr>, Box<Expr>),
    /// The receiver of a conditional access.
    Receiver,
    /// A call.
    Call(Box<Expr>, Vec<Arg>),
    /// An element.
    Index(Box<Expr>, Vec<Arg>),
    /// `new T(...) { ... }`; without a type it is the one that is expected.
    New(Option<TypeRef>, Vec<Arg>, Option<Init>),
    /// `new T[n, m]`: element type, lengths, and an initialiser.
    NewArray(Option<TypeRef>, Vec<Expr>, u8, Option<Box<Expr>>),
    /// `{ 1, 2 }` of an array.
    ArrayInit(Vec<Expr>),
    /// `new { A = 1 }`
    Anonymous(Vec<(Name, Expr)>),
    /// An operator of one operand.
    Unary(UnaryOp, Box<Expr>),
    /// `++`, `--`: by how much, and whether the value is that from before.
    Step(i8, bool, Box<Expr>),
    /// An operator of two operands.
    Binary(BinaryOp, Box<Expr>, Box<Expr>),
    /// An assignment, compound with an operator.
    Assign(Option<BinaryOp>, Box<Expr>, Box<Expr>),
    /// `a ? b : c`
    Choice(Box<Expr>, Box<Expr>, Box<Expr>),
    /// `a is pattern`
    Is(Box<Expr>, Box<Pattern>),
    /// `a as T`
    As(Box<Expr>, TypeRef),
    /// `(T)a`
    Cast(TypeRef, Box<Expr>),
    /// `typeof(T)`
    TypeOf(TypeRef),
    /// `sizeof(T)`
    SizeOf(TypeRef),
    /// `default`, `default(T)`
    Default(Option<TypeRef>),
    /// `nameof(a.b)`
    NameOf(Name),
    /// `checked(a)`, `unchecked(a)`
    Checked(bool, Box<Expr>),
    /// A lambda or anonymous method; one without a parameter list takes any.
    Lambda(Option<Vec<LambdaParam>>, Arc<FnBody>),
    /// `(a, b)`
    Tuple(Vec<(Option<Name>, Expr)>),
    /// `int x` or `var x` as an argument or in a deconstruction; `var (x, y)`.
    Declare(TypeRef, Designation),
    /// `ref a`, where a reference to a variable is made.
    Ref(Box<Expr>),
    /// `throw a` as an expression.
    Throw(Box<Expr>),
    /// `a switch { ... }`
    Switch(Box<Expr>, Vec<Arm>),
    /// `this`
    This,
    /// `base`, before a dot or bracket.
    Base,
    /// In brackets.
    Bracketed(Box<Expr>),
}

/// The names that a declaration gives.
#[derive(Debug, Clone)]
pub enum Designation {
    /// One name.
    Name(Pos, Name),
    /// `_`
    Discard(Pos),
    /// `(a, b)`
    Several(Pos, Vec<Designation>),
}

/// A pattern.
#[derive(Debug, Clone)]
pub struct Pattern {
    /// The place.
    pub pos: Pos,
    /// What it is.
    pub kind: PatternKind,
}

/// Forms of patterns.
#[derive(Debug, Clone)]
pub enum PatternKind {
    /// `_`
    Discard,
    /// `var x`
    Var(Designation),
    /// `T x`, and `T` where only a type can stand.
    Type(TypeRef, Option<Designation>),
    /// A value, or a type by its name.
    Value(Expr),
    /// `< 3`
    Relation(BinaryOp, Expr),
    /// `T (a, b) { M: c } x`
    Recursive(Option<TypeRef>, Option<Vec<Pattern>>, Vec<(Pos, Name, Pattern)>, Option<Designation>),
    /// `not p`
    Not(Box<Pattern>),
    /// `p and q`
    And(Box<Pattern>, Box<Pattern>),
    /// `p or q`
    Or(Box<Pattern>, Box<Pattern>),
}

/// An arm of a switch expression.
#[derive(Debug, Clone)]
pub struct Arm {
    /// The pattern.
    pub pattern: Pattern,
    /// `when`
    pub guard: Option<Expr>,
    /// The value.
    pub value: Expr,
}

/// A block.
#[derive(Debug, Clone)]
pub struct Block {
    /// The place of `{`.
    pub pos: Pos,
    /// The place of `}`.
    pub end: Pos,
    /// What is in it.
    pub stmts: Vec<Stmt>,
}

/// A statement at its place.
#[derive(Debug, Clone)]
pub struct Stmt {
    /// The place.
    pub pos: Pos,
    /// What it is.
    pub kind: StmtKind,
}

/// A variable with its first value.
#[derive(Debug, Clone)]
pub struct Variable {
    /// The place.
    pub pos: Pos,
    /// The name.
    pub name: Name,
    /// The value.
    pub value: Option<Expr>,
}

/// Forms of statements.
#[derive(Debug, Clone)]
pub enum StmtKind {
    /// `;`
    Empty,
    /// `{ }`
    Block(Block),
    /// Variables: whether constant, and whether disposed of at the end of the block.
    Local { ty: TypeRef, variables: Vec<Variable>, constant: bool, using: bool },
    /// `ref T a = ref b`; whether nothing is set through it. No type where `var` is written.
    Reference(Option<TypeRef>, Vec<Variable>, bool),
    /// A function in a function.
    Function(Arc<Method>),
    /// An expression.
    Expr(Expr),
    /// `if`
    If(Expr, Box<Stmt>, Option<Box<Stmt>>),
    /// `while`
    While(Expr, Box<Stmt>),
    /// `do`
    Do(Box<Stmt>, Expr),
    /// `for`
    For(Vec<Stmt>, Option<Expr>, Vec<Expr>, Box<Stmt>),
    /// `foreach`: the type when written, the names, what is gone through, the body.
    Foreach(TypeRef, Designation, Expr, Box<Stmt>),
    /// `switch`
    Switch(Expr, Vec<Section>),
    /// `break`
    Break,
    /// `continue`
    Continue,
    /// `return`
    Return(Option<Expr>),
    /// `throw`
    Throw(Option<Expr>),
    /// `try`
    Try(Block, Vec<Catch>, Option<Block>),
    /// `lock`
    Lock(Expr, Box<Stmt>),
    /// `using (...)`: variables or an expression.
    Using(Box<Stmt>, Box<Stmt>),
    /// `checked { }`, `unchecked { }`
    Checked(bool, Block),
    /// `yield return`, and `yield break` without a value.
    Yield(Option<Expr>),
    /// `goto label`
    Goto(Name),
    /// `goto case`, `goto default`
    GotoCase(Option<Expr>),
    /// `label:`
    Label(Name, Box<Stmt>),
}

/// A part of a switch statement.
#[derive(Debug, Clone)]
pub struct Section {
    /// Its labels.
    pub labels: Vec<CaseLabel>,
    /// What is done.
    pub stmts: Vec<Stmt>,
}

/// A label of a switch statement.
#[derive(Debug, Clone)]
pub enum CaseLabel {
    /// `case p when g:`
    Case(Box<Pattern>, Option<Expr>),
    /// `default:`
    Default(Pos),
}

/// A `catch`.
#[derive(Debug, Clone)]
pub struct Catch {
    /// The place.
    pub pos: Pos,
    /// The type.
    pub ty: Option<TypeRef>,
    /// The name.
    pub name: Option<Name>,
    /// `when`
    pub filter: Option<Expr>,
    /// What is done.
    pub body: Block,
}
