//! Patterns and switch expressions.

use super::super::ast::{Arm, BinaryOp, Designation, Expr, ExprKind, Pattern, PatternKind, TypeRefKind};
use super::super::token::Tok;
use super::Parser;
use super::expression::expr;
use crate::diagnostic::Checked;

impl Parser {
    pub(super) fn pattern(&mut self) -> Checked<Pattern> {
        self.nested(|p| {
            let mut left = p.pattern_and()?;
            while p.is_word("or") {
                p.deeper(1)?;
                p.advance();
                let right = p.pattern_and()?;
                left = Pattern { pos: left.pos, kind: PatternKind::Or(Box::new(left), Box::new(right)) };
            }
            Ok(left)
        })
    }

    fn pattern_and(&mut self) -> Checked<Pattern> {
        let mut left = self.pattern_one()?;
        while self.is_word("and") {
            self.deeper(1)?;
            self.advance();
            let right = self.pattern_one()?;
            left = Pattern { pos: left.pos, kind: PatternKind::And(Box::new(left), Box::new(right)) };
        }
        Ok(left)
    }

    fn pattern_one(&mut self) -> Checked<Pattern> {
        let pos = self.pos();
        let made = |kind| Ok(Pattern { pos, kind });
        if self.is("(") {
            return if self.is_positional() { self.recursive(None) } else { self.typed_or_value() };
        }
        match self.tok() {
            Tok::Ident(name) if &**name == "_" && !self.is_ahead(1, ".") => {
                self.advance();
                made(PatternKind::Discard)
            }
            Tok::Ident(name) if &**name == "not" && !self.is_ahead(1, ".") => {
                self.advance();
                let inner = self.nested(Self::pattern_one)?;
                made(PatternKind::Not(Box::new(inner)))
            }
            Tok::Ident(name) if &**name == "var" && matches!(self.ahead(1), Tok::Ident(_) | Tok::P("(")) => {
                self.advance();
                let names = self.designation()?;
                made(PatternKind::Var(names))
            }
            Tok::P(p @ ("<" | "<=" | ">" | ">=")) => {
                let op = match *p {
                    "<" => BinaryOp::Lt,
                    "<=" => BinaryOp::Le,
                    ">" => BinaryOp::Gt,
                    _ => BinaryOp::Ge,
                };
                self.advance();
                let value = self.binary(9)?;
                made(PatternKind::Relation(op, value))
            }
            Tok::P("{") => self.recursive(None),
            _ => self.typed_or_value(),
        }
    }

    /// Whether brackets hold patterns, and are not a value in brackets or a cast.
    fn is_positional(&mut self) -> bool {
        let (at, depth) = (self.at, self.depth);
        self.at += 1;
        let is = self.pattern().is_ok() && self.is(",");
        (self.at, self.depth) = (at, depth);
        is
    }

    fn typed_or_value(&mut self) -> Checked<Pattern> {
        let pos = self.pos();
        let typed = self.attempt(|p| {
            let ty = p.type_ref()?;
            let sure = !matches!(ty.kind, TypeRefKind::Named(_))
                || p.tokens.get(p.at - 1).is_some_and(|t| matches!(t.tok, Tok::Kw(_) | Tok::P(">")));
            if p.is("{") || (p.is("(") && !sure) {
                return if p.is("{") { p.recursive(Some(ty)) } else { p.unsupported("a call") };
            }
            let named = matches!(p.tok(), Tok::Ident(name)
                if !matches!(&**name, "when" | "and" | "or") || p.is_ahead(1, ":") || p.is_ahead(1, "=>"));
            if named {
                let name = p.designation()?;
                return Ok(Pattern { pos, kind: PatternKind::Type(ty, Some(name)) });
            }
            if sure && !p.is(".") {
                Ok(Pattern { pos, kind: PatternKind::Type(ty, None) })
            } else {
                p.unsupported("a value")
            }
        });
        if let Some(pattern) = typed {
            return Ok(pattern);
        }
        let value = self.binary(9)?;
        Ok(Pattern { pos, kind: PatternKind::Value(value) })
    }

    fn recursive(&mut self, ty: Option<super::super::ast::TypeRef>) -> Checked<Pattern> {
        let pos = self.pos();
        let mut positions = None;
        if self.eat("(") {
            let mut list = vec![self.pattern()?];
            while self.eat(",") {
                list.push(self.pattern()?);
            }
            self.expect(")")?;
            positions = Some(list);
        }
        let mut members = Vec::new();
        if self.eat("{") {
            while !self.is("}") {
                let at = self.pos();
                let name = self.ident()?;
                self.expect(":")?;
                members.push((at, name, self.pattern()?));
                if !self.eat(",") {
                    break;
                }
            }
            self.expect("}")?;
        }
        let named = matches!(self.tok(), Tok::Ident(name) if !matches!(&**name, "when" | "and" | "or"));
        let name: Option<Designation> = if named { Some(self.designation()?) } else { None };
        Ok(Pattern { pos, kind: PatternKind::Recursive(ty, positions, members, name) })
    }

    pub(super) fn switch_expression(&mut self, subject: Expr) -> Checked<Expr> {
        let pos = self.pos();
        self.expect_kw("switch")?;
        self.expect("{")?;
        let mut arms = Vec::new();
        while !self.is("}") {
            let pattern = self.pattern()?;
            let guard = if self.eat_word("when") { Some(self.expression()?) } else { None };
            self.expect("=>")?;
            let value = self.expression()?;
            arms.push(Arm { pattern, guard, value });
            if !self.eat(",") {
                break;
            }
        }
        self.expect("}")?;
        Ok(expr(pos, ExprKind::Switch(Box::new(subject), arms)))
    }
}
