//! Types and their arguments.

use super::super::ast::{Name, NamePart, TypeRef, TypeRefKind};
use super::super::token::Tok;
use super::Parser;
use crate::diagnostic::{Checked, Fault};

/// The names of predefined types, by keyword.
const PREDEFINED: &[(&str, &str)] = &[
    ("bool", "Boolean"),
    ("byte", "Byte"),
    ("char", "Char"),
    ("decimal", "Decimal"),
    ("double", "Double"),
    ("float", "Single"),
    ("int", "Int32"),
    ("long", "Int64"),
    ("object", "Object"),
    ("sbyte", "SByte"),
    ("short", "Int16"),
    ("string", "String"),
    ("uint", "UInt32"),
    ("ulong", "UInt64"),
    ("ushort", "UInt16"),
    ("void", "Void"),
];

impl Parser {
    /// The type that a keyword names.
    pub(super) fn predefined(&self) -> Option<&'static str> {
        let Tok::Kw(word) = self.tok() else { return None };
        PREDEFINED.iter().find(|(keyword, _)| keyword == word).map(|(_, name)| *name)
    }

    pub(super) fn type_ref(&mut self) -> Checked<TypeRef> {
        self.nested(|p| {
            let base = p.type_without_arrays()?;
            p.array_ranks(base)
        })
    }

    /// A type whose last array is left to the caller, as after `new`.
    pub(super) fn type_without_arrays(&mut self) -> Checked<TypeRef> {
        let pos = self.pos();
        let kind = if let Some(name) = self.predefined() {
            self.advance();
            TypeRefKind::Named(system(pos, name))
        } else if self.is("(") {
            self.tuple_type()?
        } else if self.is_word("var") && !self.is_ahead(1, ".") && !self.is_ahead(1, "<") {
            self.advance();
            TypeRefKind::Var
        } else {
            TypeRefKind::Named(self.qualified_name()?)
        };
        let ty = TypeRef { pos, kind };
        if self.is("*") && self.is_ahead(1, ")") {
            return self.unsupported("A pointer");
        }
        Ok(self.question_mark(ty))
    }

    fn question_mark(&mut self, ty: TypeRef) -> TypeRef {
        if self.is("?") && self.ends_nullable() {
            self.advance();
            return TypeRef { pos: ty.pos, kind: TypeRefKind::Nullable(Box::new(ty)) };
        }
        ty
    }

    pub(super) fn array_ranks(&mut self, base: TypeRef) -> Checked<TypeRef> {
        let mut ranks = Vec::new();
        while self.is("[") && (self.is_ahead(1, "]") || self.is_ahead(1, ",")) {
            ranks.push(self.rank()?);
            if ranks.len() > 16 {
                return Err(Fault::new(self.pos(), 8078, "A type is too complex to compile"));
            }
        }
        let pos = base.pos;
        // `int[][,]` is an array of `int[,]`.
        let mut ty = ranks
            .into_iter()
            .rev()
            .fold(base, |element, rank| TypeRef { pos, kind: TypeRefKind::Array(Box::new(element), rank) });
        if matches!(ty.kind, TypeRefKind::Array(..)) {
            ty = self.question_mark(ty);
            if let TypeRefKind::Nullable(inner) = ty.kind {
                ty = *inner;
            }
        }
        Ok(ty)
    }

    /// `[,]`
    pub(super) fn rank(&mut self) -> Checked<u8> {
        self.expect("[")?;
        let mut rank = 1;
        while self.eat(",") {
            rank += 1;
            if rank > 8 {
                return Err(Fault::new(self.pos(), 8078, "A type is too complex to compile"));
            }
        }
        self.expect("]")?;
        Ok(rank)
    }

    fn tuple_type(&mut self) -> Checked<TypeRefKind> {
        self.expect("(")?;
        let mut parts = Vec::new();
        loop {
            let ty = self.type_ref()?;
            let name = if let Tok::Ident(_) = self.tok() { Some(self.ident()?) } else { None };
            parts.push((ty, name));
            if !self.eat(",") {
                break;
            }
        }
        self.expect(")")?;
        if parts.len() < 2 {
            return Err(Fault::new(self.pos(), 8124, "Tuple must contain at least two elements."));
        }
        Ok(TypeRefKind::Tuple(parts))
    }

    pub(super) fn qualified_name(&mut self) -> Checked<Vec<NamePart>> {
        let mut parts = Vec::new();
        if self.is_word("global") && self.is_ahead(1, "::") {
            self.at += 2;
        }
        loop {
            parts.push(self.name_part()?);
            if !self.eat(".") {
                return Ok(parts);
            }
        }
    }

    fn name_part(&mut self) -> Checked<NamePart> {
        let pos = self.pos();
        let Tok::Ident(_) = self.tok() else {
            return Err(Fault::new(pos, 1031, "Type expected"));
        };
        let name = self.ident()?;
        if self.is("<") && (self.is_ahead(1, ">") || self.is_ahead(1, ",")) {
            self.advance();
            let mut open = 1;
            while self.eat(",") {
                open += 1;
            }
            self.expect(">")?;
            return Ok(NamePart { pos, name, args: Vec::new(), open });
        }
        let args = if self.is("<") { self.type_args()? } else { Vec::new() };
        Ok(NamePart { pos, name, args, open: 0 })
    }

    pub(super) fn type_args(&mut self) -> Checked<Vec<TypeRef>> {
        self.expect("<")?;
        let mut args = Vec::new();
        loop {
            args.push(self.type_ref()?);
            if !self.eat(",") {
                break;
            }
        }
        self.expect(">")?;
        Ok(args)
    }
}

/// A type of `System`.
pub(super) fn system(pos: crate::source::Pos, name: &str) -> Vec<NamePart> {
    ["System", name].map(|name| NamePart { pos, name: Name::from(name), args: Vec::new(), open: 0 }).into()
}
