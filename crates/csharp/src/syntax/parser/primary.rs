//! Primary expressions and what follows them.

use super::super::ast::{
    Arg, Designation, Expr, ExprKind, Init, InitTarget, InitValue, Lit, NamePart, Passing, TextPiece,
    TypeRef, TypeRefKind,
};
use super::super::token::{Name, Piece, Tok, Token};
use super::Parser;
use super::expression::expr;
use super::types::system;
use crate::diagnostic::{Checked, Fault};
use crate::source::Pos;

impl Parser {
    pub(super) fn postfix(&mut self) -> Checked<Expr> {
        let first = self.primary()?;
        self.followed(first)
    }

    fn followed(&mut self, mut left: Expr) -> Checked<Expr> {
        loop {
            let pos = self.pos();
            match self.tok() {
                Tok::P(".") => {
                    self.deeper(1)?;
                    self.advance();
                    let pos = self.pos();
                    let part = self.member_name()?;
                    left = expr(pos, ExprKind::Member(Box::new(left), part));
                }
                Tok::P("(") => {
                    self.deeper(1)?;
                    let at = left.pos;
                    let args = self.arguments()?;
                    left = expr(at, ExprKind::Call(Box::new(left), args));
                }
                Tok::P("[") => {
                    self.deeper(1)?;
                    let args = self.index_arguments()?;
                    left = expr(pos, ExprKind::Index(Box::new(left), args));
                }
                Tok::P("?") if self.is_ahead(1, "[") && self.is_conditional_index() => {
                    self.advance();
                    left = self.conditional(pos, left)?;
                }
                Tok::P("?.") => {
                    left = self.conditional(pos, left)?;
                }
                Tok::P("++" | "--") => {
                    self.deeper(1)?;
                    let by = if self.is("++") { 1 } else { -1 };
                    self.advance();
                    left = expr(pos, ExprKind::Step(by, true, Box::new(left)));
                }
                Tok::Kw("switch") if self.is_ahead(1, "{") => {
                    self.deeper(1)?;
                    left = self.switch_expression(left)?;
                }
                Tok::P("->") => return self.unsupported("A pointer"),
                _ => return Ok(left),
            }
        }
    }

    /// `a?[i]` and not `a ? [..`, which is no C# of this version.
    fn is_conditional_index(&self) -> bool {
        self.tokens.get(self.at).zip(self.tokens.get(self.at + 1)).is_some_and(|(a, b)| a.end == b.pos)
    }

    /// What stands behind `?` up to the end of the chain is done only when the receiver is there.
    fn conditional(&mut self, pos: Pos, receiver: Expr) -> Checked<Expr> {
        let chain = self.nested(|p| {
            let placeholder = expr(pos, ExprKind::Receiver);
            if p.eat("?.") {
                let at = p.pos();
                let part = p.member_name()?;
                let member = expr(at, ExprKind::Member(Box::new(placeholder), part));
                p.followed(member)
            } else {
                let args = p.index_arguments()?;
                p.followed(expr(pos, ExprKind::Index(Box::new(placeholder), args)))
            }
        })?;
        Ok(expr(pos, ExprKind::Conditional(Box::new(receiver), Box::new(chain))))
    }

    /// A name in an expression: `<` begins type arguments only when they end as such.
    fn member_name(&mut self) -> Checked<NamePart> {
        let pos = self.pos();
        let name = self.ident()?;
        let mut args = Vec::new();
        if self.is("<") {
            let read = self.attempt(|p| {
                let args = p.type_args()?;
                if p.after_type_args() { Ok(args) } else { p.unsupported("a comparison") }
            });
            args = read.unwrap_or_default();
        }
        Ok(NamePart { pos, name, args, open: 0 })
    }

    pub(super) fn arguments(&mut self) -> Checked<Vec<Arg>> {
        self.expect("(")?;
        let args = self.argument_list(")")?;
        self.expect(")")?;
        Ok(args)
    }

    fn index_arguments(&mut self) -> Checked<Vec<Arg>> {
        self.expect("[")?;
        let args = self.argument_list("]")?;
        if args.is_empty() {
            return Err(Fault::new(self.pos(), 443, "Syntax error; value expected"));
        }
        self.expect("]")?;
        Ok(args)
    }

    fn argument_list(&mut self, close: &str) -> Checked<Vec<Arg>> {
        let mut args = Vec::new();
        while !self.is(close) {
            args.push(self.argument()?);
            if !self.eat(",") {
                break;
            }
            if self.is(close) {
                return Err(self.no_expression());
            }
        }
        Ok(args)
    }

    fn argument(&mut self) -> Checked<Arg> {
        let mut name = None;
        if matches!(self.tok(), Tok::Ident(_)) && self.is_ahead(1, ":") {
            name = Some(self.ident()?);
            self.advance();
        }
        let passing = self.passing();
        if passing == Passing::Out
            && let Some(declared) = self.declared_variable()
        {
            return Ok(Arg { name, passing, value: declared });
        }
        Ok(Arg { name, passing, value: self.expression()? })
    }

    /// `int x` or `var x`, where a variable can be declared inside an expression.
    fn declared_variable(&mut self) -> Option<Expr> {
        self.attempt(|p| {
            let pos = p.pos();
            let ty = p.type_ref()?;
            let at = p.pos();
            let name = p.ident()?;
            if !(p.is(",") || p.is(")")) {
                return p.unsupported("no declaration");
            }
            let names = if &*name == "_" { Designation::Discard(at) } else { Designation::Name(at, name) };
            Ok(expr(pos, ExprKind::Declare(ty, names)))
        })
    }

    pub(super) fn no_expression(&self) -> Fault {
        match self.tok() {
            Tok::P(p) => Fault::new(self.pos(), 1525, format!("Invalid expression term '{p}'")),
            Tok::Kw(word) => Fault::new(self.pos(), 1525, format!("Invalid expression term '{word}'")),
            _ => Fault::new(self.pos(), 1733, "Expected expression"),
        }
    }

    fn primary(&mut self) -> Checked<Expr> {
        let pos = self.pos();
        let literal = match self.tok() {
            Tok::Int(value, suffix) => Lit::Int(*value, *suffix),
            Tok::Double(value) => Lit::Double(*value),
            Tok::Float(value) => Lit::Float(*value),
            Tok::Decimal(text) => Lit::Decimal(text.clone()),
            Tok::Char(unit) => Lit::Char(*unit),
            Tok::Str(units) => Lit::Str(units.clone()),
            Tok::Kw("true") => Lit::Bool(true),
            Tok::Kw("false") => Lit::Bool(false),
            Tok::Kw("null") => Lit::Null,
            Tok::Interpolated(pieces) => {
                let pieces = pieces.clone();
                self.advance();
                return self.interpolated(pos, pieces);
            }
            Tok::Ident(name) if &**name == "nameof" && self.is_ahead(1, "(") => return self.name_of(),
            Tok::Ident(name) if &**name == "var" && self.is_ahead(1, "(") => return self.deconstruction(),
            Tok::Ident(_) => {
                if self.is_word("global") && self.is_ahead(1, "::") {
                    self.at += 2;
                }
                let part = self.member_name()?;
                return Ok(expr(pos, ExprKind::Name(part)));
            }
            Tok::P("(") => return self.bracketed(),
            Tok::Kw(word) => {
                let word = *word;
                return self.by_keyword(pos, word);
            }
            _ => return Err(self.no_expression()),
        };
        self.advance();
        Ok(expr(pos, ExprKind::Lit(literal)))
    }

    fn by_keyword(&mut self, pos: Pos, word: &str) -> Checked<Expr> {
        if let Some(name) = self.predefined() {
            self.advance();
            let ty = TypeRef { pos, kind: TypeRefKind::Named(system(pos, name)) };
            if !self.is(".") {
                return Err(self.no_expression_at(pos, word));
            }
            return Ok(expr(pos, ExprKind::Type(ty)));
        }
        match word {
            "this" => self.one(pos, ExprKind::This),
            "base" => self.one(pos, ExprKind::Base),
            "new" => self.creation(),
            "delegate" => self.anonymous_method(),
            "typeof" | "sizeof" => {
                self.advance();
                self.expect("(")?;
                let ty = self.type_ref()?;
                self.expect(")")?;
                Ok(expr(pos, if word == "typeof" { ExprKind::TypeOf(ty) } else { ExprKind::SizeOf(ty) }))
            }
            "default" => {
                self.advance();
                let mut ty = None;
                if self.eat("(") {
                    ty = Some(self.type_ref()?);
                    self.expect(")")?;
                }
                Ok(expr(pos, ExprKind::Default(ty)))
            }
            "checked" | "unchecked" => {
                self.advance();
                self.expect("(")?;
                let value = self.expression()?;
                self.expect(")")?;
                Ok(expr(pos, ExprKind::Checked(word == "checked", Box::new(value))))
            }
            "stackalloc" => self.unsupported("stackalloc"),
            "ref" => self.unsupported("A reference to a variable"),
            _ => Err(self.no_expression()),
        }
    }

    fn no_expression_at(&self, pos: Pos, word: &str) -> Fault {
        Fault::new(pos, 1525, format!("Invalid expression term '{word}'"))
    }

    fn one(&mut self, pos: Pos, kind: ExprKind) -> Checked<Expr> {
        self.advance();
        Ok(expr(pos, kind))
    }

    fn name_of(&mut self) -> Checked<Expr> {
        let pos = self.pos();
        self.at += 2;
        let value = self.expression()?;
        self.expect(")")?;
        let name: Name = match &value.kind {
            ExprKind::Name(part) | ExprKind::Member(_, part) => part.name.clone(),
            _ => return Err(Fault::new(pos, 8081, "Expression does not have a name.")),
        };
        Ok(expr(pos, ExprKind::NameOf(name)))
    }

    /// `var (a, b)`
    fn deconstruction(&mut self) -> Checked<Expr> {
        let pos = self.pos();
        let declared = self.attempt(|p| {
            p.advance();
            let names = p.designation()?;
            if p.is("=") || p.is_kw("in") { Ok(names) } else { p.unsupported("a call") }
        });
        if let Some(names) = declared {
            return Ok(expr(pos, ExprKind::Declare(TypeRef { pos, kind: TypeRefKind::Var }, names)));
        }
        let part = self.member_name()?;
        Ok(expr(pos, ExprKind::Name(part)))
    }

    pub(super) fn designation(&mut self) -> Checked<Designation> {
        self.nested(|p| {
            let pos = p.pos();
            if p.eat("(") {
                let mut names = vec![p.designation()?];
                while p.eat(",") {
                    names.push(p.designation()?);
                }
                p.expect(")")?;
                return Ok(Designation::Several(pos, names));
            }
            let name = p.ident()?;
            Ok(if &*name == "_" { Designation::Discard(pos) } else { Designation::Name(pos, name) })
        })
    }

    /// `(a)`, `(a, b)`, `(int x, string y)`
    fn bracketed(&mut self) -> Checked<Expr> {
        let pos = self.pos();
        self.expect("(")?;
        let mut parts = Vec::new();
        loop {
            if let Some(declared) = self.declared_variable() {
                parts.push((None, declared));
            } else {
                let mut name = None;
                if matches!(self.tok(), Tok::Ident(_)) && self.is_ahead(1, ":") {
                    name = Some(self.ident()?);
                    self.advance();
                }
                parts.push((name, self.expression()?));
            }
            if !self.eat(",") {
                break;
            }
        }
        self.expect(")")?;
        if parts.len() == 1
            && let Some((None, value)) = parts.pop()
        {
            return Ok(expr(pos, ExprKind::Bracketed(Box::new(value))));
        }
        Ok(expr(pos, ExprKind::Tuple(parts)))
    }

    fn creation(&mut self) -> Checked<Expr> {
        let pos = self.pos();
        self.expect_kw("new")?;
        if self.is("{") {
            return self.anonymous(pos);
        }
        if self.is("[") {
            let rank = self.rank()?;
            let init = self.array_initialiser()?;
            return Ok(expr(pos, ExprKind::NewArray(None, Vec::new(), rank, Some(Box::new(init)))));
        }
        if self.is("(") && !matches!(self.ahead(1), Tok::Kw(_)) {
            let args = self.arguments()?;
            let init = if self.is("{") { Some(self.initialiser()?) } else { None };
            return Ok(expr(pos, ExprKind::New(None, args, init)));
        }
        let ty = self.type_without_arrays()?;
        if self.is("[") {
            return self.array_creation(pos, ty);
        }
        let args = if self.is("(") { Some(self.arguments()?) } else { None };
        let init = if self.is("{") { Some(self.initialiser()?) } else { None };
        if args.is_none() && init.is_none() {
            return Err(Fault::new(
                self.pos(),
                1526,
                "A new expression requires an argument list or (), [], or {} after type",
            ));
        }
        Ok(expr(pos, ExprKind::New(Some(ty), args.unwrap_or_default(), init)))
    }

    fn array_creation(&mut self, pos: Pos, element: TypeRef) -> Checked<Expr> {
        if self.is_ahead(1, "]") || self.is_ahead(1, ",") {
            let array = self.array_ranks(element)?;
            let TypeRefKind::Array(element, rank) = array.kind else { return Err(self.no_expression()) };
            if !self.is("{") {
                return Err(Fault::new(
                    self.pos(),
                    1586,
                    "Array creation must have array size or array initializer",
                ));
            }
            let init = self.array_initialiser()?;
            return Ok(expr(pos, ExprKind::NewArray(Some(*element), Vec::new(), rank, Some(Box::new(init)))));
        }
        self.expect("[")?;
        let mut sizes = vec![self.expression()?];
        while self.eat(",") {
            sizes.push(self.expression()?);
        }
        self.expect("]")?;
        let element = self.array_ranks(element)?;
        let rank = sizes.len() as u8;
        let init = if self.is("{") { Some(Box::new(self.array_initialiser()?)) } else { None };
        Ok(expr(pos, ExprKind::NewArray(Some(element), sizes, rank, init)))
    }

    pub(super) fn array_initialiser(&mut self) -> Checked<Expr> {
        self.nested(|p| {
            let pos = p.pos();
            p.expect("{")?;
            let mut values = Vec::new();
            while !p.is("}") {
                values.push(if p.is("{") { p.array_initialiser()? } else { p.expression()? });
                if !p.eat(",") {
                    break;
                }
            }
            p.expect("}")?;
            Ok(expr(pos, ExprKind::ArrayInit(values)))
        })
    }

    fn initialiser(&mut self) -> Checked<Init> {
        self.nested(|p| {
            p.expect("{")?;
            let members = matches!(p.tok(), Tok::Ident(_)) && p.is_ahead(1, "=") || p.is("[");
            let mut set = Vec::new();
            let mut added = Vec::new();
            while !p.is("}") {
                if members {
                    set.push(p.set_member()?);
                } else if p.is("{") {
                    p.advance();
                    let mut values = vec![p.expression()?];
                    while p.eat(",") {
                        values.push(p.expression()?);
                    }
                    p.expect("}")?;
                    added.push(values);
                } else {
                    added.push(vec![p.expression()?]);
                }
                if !p.eat(",") {
                    break;
                }
            }
            p.expect("}")?;
            Ok(if members { Init::Members(set) } else { Init::Elements(added) })
        })
    }

    fn set_member(&mut self) -> Checked<(InitTarget, InitValue)> {
        let pos = self.pos();
        let target = if self.is("[") {
            InitTarget::Index(pos, self.index_arguments()?)
        } else {
            InitTarget::Member(pos, self.ident()?)
        };
        self.expect("=")?;
        let value = if self.is("{") {
            InitValue::Nested(self.initialiser()?)
        } else {
            InitValue::Value(self.expression()?)
        };
        Ok((target, value))
    }

    fn anonymous(&mut self, pos: Pos) -> Checked<Expr> {
        self.expect("{")?;
        let mut members = Vec::new();
        while !self.is("}") {
            if matches!(self.tok(), Tok::Ident(_)) && self.is_ahead(1, "=") {
                let name = self.ident()?;
                self.advance();
                members.push((name, self.expression()?));
            } else {
                let value = self.expression()?;
                let name = match &value.kind {
                    ExprKind::Name(part) | ExprKind::Member(_, part) => part.name.clone(),
                    _ => {
                        return Err(Fault::new(
                            value.pos,
                            746,
                            "Invalid anonymous type member declarator. Anonymous type members must be declared with a member assignment, simple name or member access.",
                        ));
                    }
                };
                members.push((name, value));
            }
            if !self.eat(",") {
                break;
            }
        }
        self.expect("}")?;
        Ok(expr(pos, ExprKind::Anonymous(members)))
    }

    /// The holes of an interpolated text are read by this parser, over their own tokens.
    fn interpolated(&mut self, pos: Pos, pieces: Vec<Piece>) -> Checked<Expr> {
        let mut read = Vec::new();
        for piece in pieces {
            read.push(match piece {
                Piece::Text(units) => TextPiece::Text(units.into()),
                Piece::Hole(tokens, format) => self.hole(pos, tokens, format)?,
            });
        }
        Ok(expr(pos, ExprKind::Interpolated(read)))
    }

    fn hole(&mut self, pos: Pos, tokens: Vec<Token>, format: Option<Name>) -> Checked<TextPiece> {
        let end = tokens.last().map_or(pos, |token| token.end);
        let outer =
            (std::mem::replace(&mut self.tokens, tokens), std::mem::replace(&mut self.at, 0), self.end);
        self.end = end;
        let result = (|| {
            let value = self.expression()?;
            let alignment = if self.eat(",") { Some(Box::new(self.expression()?)) } else { None };
            if self.at < self.tokens.len() {
                return Err(Fault::new(self.pos(), 1003, "Syntax error, '}' expected"));
            }
            Ok(TextPiece::Hole(Box::new(value), alignment, format))
        })();
        (self.tokens, self.at, self.end) = outer;
        result
    }
}
