//! Tokens.

use std::sync::Arc;

use crate::source::Pos;

/// A name.
pub(crate) type Name = Arc<str>;

/// The type that a suffix gives a whole number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum IntSuffix {
    /// None: the first of int, uint, long and ulong that holds it.
    None,
    /// `u`
    U,
    /// `L`
    L,
    /// `ul`
    Ul,
}

/// What a token is.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Tok {
    /// A name, contextual keywords among them.
    Ident(Name),
    /// A reserved word.
    Kw(&'static str),
    /// An operator or separator.
    P(&'static str),
    /// A whole number.
    Int(u64, IntSuffix),
    /// A number with `d` or without a suffix.
    Double(f64),
    /// A number with `f`.
    Float(f32),
    /// A number with `m`, as written.
    Decimal(Name),
    /// A character.
    Char(u16),
    /// A text.
    Str(Arc<[u16]>),
    /// A text with holes.
    Interpolated(Vec<Piece>),
    /// The end.
    Eof,
}

/// A piece of a text with holes.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Piece {
    /// Characters.
    Text(Vec<u16>),
    /// A hole: the tokens of its value and alignment, and its format.
    Hole(Vec<Token>, Option<Name>),
}

/// A token at its place.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Token {
    /// What it is.
    pub tok: Tok,
    /// Where it begins.
    pub pos: Pos,
    /// Where it ends.
    pub end: Pos,
}

/// The reserved words.
pub(crate) const KEYWORDS: &[&str] = &[
    "abstract",
    "as",
    "base",
    "bool",
    "break",
    "byte",
    "case",
    "catch",
    "char",
    "checked",
    "class",
    "const",
    "continue",
    "decimal",
    "default",
    "delegate",
    "do",
    "double",
    "else",
    "enum",
    "event",
    "explicit",
    "extern",
    "false",
    "finally",
    "fixed",
    "float",
    "for",
    "foreach",
    "goto",
    "if",
    "implicit",
    "in",
    "int",
    "interface",
    "internal",
    "is",
    "lock",
    "long",
    "namespace",
    "new",
    "null",
    "object",
    "operator",
    "out",
    "override",
    "params",
    "private",
    "protected",
    "public",
    "readonly",
    "ref",
    "return",
    "sbyte",
    "sealed",
    "short",
    "sizeof",
    "stackalloc",
    "static",
    "string",
    "struct",
    "switch",
    "this",
    "throw",
    "true",
    "try",
    "typeof",
    "uint",
    "ulong",
    "unchecked",
    "unsafe",
    "ushort",
    "using",
    "virtual",
    "void",
    "volatile",
    "while",
];

/// Operators and separators, the longest first. `>` stays alone so that type arguments can end in `>>`.
pub(crate) const PUNCTUATION: &[&str] = &[
    "<<=", "??=", "...", "=>", "==", "!=", "<=", ">=", "&&", "||", "++", "--", "+=", "-=", "*=", "/=", "%=",
    "&=", "|=", "^=", "<<", "->", "::", "??", "?.", "..", "{", "}", "(", ")", "[", "]", ".", ",", ":", ";",
    "+", "-", "*", "/", "%", "&", "|", "^", "!", "~", "=", "<", ">", "?",
];
