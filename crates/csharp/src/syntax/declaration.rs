//! Syntax trees of declarations.

use std::sync::Arc;

use super::ast::{Arg, Expr, FnBody, Passing, TypeRef, Variable};
use super::token::Name;
use crate::source::Pos;

/// Words before a declaration.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Modifiers(pub u32);

impl Modifiers {
    /// All words, each with its bit.
    pub const WORDS: &'static [&'static str] = &[
        "public",
        "private",
        "protected",
        "internal",
        "static",
        "abstract",
        "sealed",
        "virtual",
        "override",
        "readonly",
        "const",
        "extern",
        "new",
        "partial",
        "async",
        "unsafe",
        "volatile",
        "ref",
        "event",
    ];

    /// These and another word.
    pub fn with(self, word: &str) -> Self {
        let bit = Self::WORDS.iter().position(|w| *w == word).map_or(0, |i| 1 << i);
        Self(self.0 | bit)
    }

    /// Whether a word is there.
    pub fn has(self, word: &str) -> bool {
        Self::WORDS.iter().position(|w| *w == word).is_some_and(|i| self.0 & (1 << i) != 0)
    }
}

/// A parameter.
#[derive(Debug, Clone)]
pub struct Param {
    /// The place.
    pub pos: Pos,
    /// The name.
    pub name: Name,
    /// The type.
    pub ty: TypeRef,
    /// `ref`, `out`, `in`.
    pub passing: Passing,
    /// `params`
    pub rest: bool,
    /// `this`
    pub extends: bool,
    /// The value when it is left out.
    pub default: Option<Expr>,
}

/// A type parameter.
#[derive(Debug, Clone)]
pub struct TypeParam {
    /// The place.
    pub pos: Pos,
    /// The name.
    pub name: Name,
    /// Types it must convert to.
    pub bounds: Vec<TypeRef>,
    /// `class`
    pub class: bool,
    /// `struct`
    pub structure: bool,
    /// `new()`
    pub creatable: bool,
}

/// A method, operator, constructor, accessor or local function.
#[derive(Debug, Clone)]
pub struct Method {
    /// The place of the name.
    pub pos: Pos,
    /// The name; operators have those of the specification (`op_Addition`), constructors `.ctor` and `.cctor`.
    pub name: Name,
    /// Words before it.
    pub modifiers: Modifiers,
    /// What it gives; `None` is `void`.
    pub ret: Option<TypeRef>,
    /// Type parameters.
    pub type_params: Vec<TypeParam>,
    /// Parameters.
    pub params: Vec<Param>,
    /// The interface of an explicit implementation.
    pub explicit: Option<TypeRef>,
    /// `: base(...)` (true) or `: this(...)` of a constructor.
    pub chain: Option<(bool, Pos, Vec<Arg>)>,
    /// The body; none where it is abstract or extern.
    pub body: Option<FnBody>,
    /// Whether `yield` stands in it.
    pub iterator: bool,
}

/// A property or indexer.
#[derive(Debug, Clone)]
pub struct Property {
    /// The place.
    pub pos: Pos,
    /// The name; `Item` for indexers.
    pub name: Name,
    /// Words before it.
    pub modifiers: Modifiers,
    /// The type.
    pub ty: TypeRef,
    /// Parameters of an indexer.
    pub params: Vec<Param>,
    /// The interface of an explicit implementation.
    pub explicit: Option<TypeRef>,
    /// `get`, with its own words and body.
    pub getter: Option<(Pos, Modifiers, Option<FnBody>)>,
    /// `set`
    pub setter: Option<(Pos, Modifiers, Option<FnBody>)>,
    /// The first value.
    pub value: Option<Expr>,
    /// Whether `yield` stands in the getter.
    pub iterator: bool,
}

/// A member of a type.
#[derive(Debug, Clone)]
pub enum Member {
    /// Fields that share a type.
    Field(Modifiers, TypeRef, Vec<Variable>),
    /// A method.
    Method(Arc<Method>),
    /// A property.
    Property(Arc<Property>),
    /// A type.
    Type(Arc<TypeDecl>),
}

/// Kinds of types.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs, reason = "their names say it")]
pub enum TypeKind {
    Class,
    Struct,
    Interface,
    Enum,
    Delegate,
}

/// The declaration of a type.
#[derive(Debug, Clone)]
pub struct TypeDecl {
    /// The place of the name.
    pub pos: Pos,
    /// The kind.
    pub kind: TypeKind,
    /// The name.
    pub name: Name,
    /// Words before it.
    pub modifiers: Modifiers,
    /// Names of attributes.
    pub attributes: Vec<Name>,
    /// Type parameters.
    pub type_params: Vec<TypeParam>,
    /// Base class and interfaces, or the type below an enum.
    pub bases: Vec<TypeRef>,
    /// Members.
    pub members: Vec<Member>,
    /// Members of an enum.
    pub values: Vec<Variable>,
    /// The method of a delegate.
    pub invoke: Option<Arc<Method>>,
}

/// A `using`.
#[derive(Debug, Clone)]
pub struct Using {
    /// The place.
    pub pos: Pos,
    /// `using A = ...`
    pub alias: Option<Name>,
    /// `using static`
    pub statics: bool,
    /// What is used.
    pub target: TypeRef,
}

/// A namespace or a whole file.
#[derive(Debug, Clone, Default)]
pub struct Namespace {
    /// The name, with dots; empty for a file.
    pub name: String,
    /// What is used in it.
    pub usings: Vec<Using>,
    /// Namespaces in it.
    pub inner: Vec<Namespace>,
    /// Types in it.
    pub types: Vec<Arc<TypeDecl>>,
}
