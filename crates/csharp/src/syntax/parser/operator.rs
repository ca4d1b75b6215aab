//! Operators of one and two operands.

use super::super::ast::{BinaryOp, Expr, ExprKind, Pattern, PatternKind, UnaryOp};
use super::super::token::Tok;
use super::Parser;
use super::expression::expr;
use crate::diagnostic::Checked;

/// How strongly `is` and `as` bind: as comparisons do.
const RELATIONAL: u8 = 8;

impl Parser {
    /// The operator here, how strongly it binds, and its number of tokens.
    fn operator(&self) -> Option<(BinaryOp, u8, usize)> {
        let Tok::P(p) = self.tok() else { return None };
        Some(match *p {
            "??" => (BinaryOp::Coalesce, 1, 1),
            "||" => (BinaryOp::OrElse, 2, 1),
            "&&" => (BinaryOp::AndAlso, 3, 1),
            "|" => (BinaryOp::Or, 4, 1),
            "^" => (BinaryOp::Xor, 5, 1),
            "&" => (BinaryOp::And, 6, 1),
            "==" => (BinaryOp::Eq, 7, 1),
            "!=" => (BinaryOp::Ne, 7, 1),
            "<" => (BinaryOp::Lt, 8, 1),
            "<=" => (BinaryOp::Le, 8, 1),
            ">" if self.adjacent_shift(">=") => return None,
            ">" if self.adjacent_shift(">") => (BinaryOp::Shr, 9, 2),
            ">" => (BinaryOp::Gt, 8, 1),
            ">=" => (BinaryOp::Ge, 8, 1),
            "<<" => (BinaryOp::Shl, 9, 1),
            "+" => (BinaryOp::Add, 10, 1),
            "-" => (BinaryOp::Sub, 10, 1),
            "*" => (BinaryOp::Mul, 11, 1),
            "/" => (BinaryOp::Div, 11, 1),
            "%" => (BinaryOp::Rem, 11, 1),
            _ => return None,
        })
    }

    pub(super) fn binary(&mut self, least: u8) -> Checked<Expr> {
        let mut left = self.unary()?;
        loop {
            let pos = self.pos();
            if least <= RELATIONAL && self.is_kw("is") {
                self.deeper(1)?;
                self.advance();
                let pattern = self.pattern_after_is()?;
                left = expr(pos, ExprKind::Is(Box::new(left), Box::new(pattern)));
                continue;
            }
            if least <= RELATIONAL && self.is_kw("as") {
                self.deeper(1)?;
                self.advance();
                let ty = self.type_ref()?;
                left = expr(pos, ExprKind::As(Box::new(left), ty));
                continue;
            }
            let Some((op, strength, tokens)) = self.operator() else { return Ok(left) };
            if strength < least {
                return Ok(left);
            }
            self.deeper(1)?;
            self.at += tokens;
            // `??` takes what follows first; all others what came before.
            let right = if op == BinaryOp::Coalesce {
                if self.is_kw("throw") { self.expression()? } else { self.nested(|p| p.binary(strength))? }
            } else {
                self.nested(|p| p.binary(strength + 1))?
            };
            left = expr(pos, ExprKind::Binary(op, Box::new(left), Box::new(right)));
        }
    }

    fn pattern_after_is(&mut self) -> Checked<Pattern> {
        let pos = self.pos();
        let pattern = self.pattern()?;
        // Behind `is` a name is a type first.
        Ok(match pattern.kind {
            PatternKind::Type(ty, None) => Pattern { pos, kind: PatternKind::Type(ty, None) },
            kind => Pattern { pos, kind },
        })
    }

    pub(super) fn unary(&mut self) -> Checked<Expr> {
        let pos = self.pos();
        let op = match self.tok() {
            Tok::P("-") => UnaryOp::Minus,
            Tok::P("+") => UnaryOp::Plus,
            Tok::P("!") => UnaryOp::Not,
            Tok::P("~") => UnaryOp::Complement,
            Tok::P("++" | "--") => {
                let by = if self.is("++") { 1 } else { -1 };
                self.advance();
                let operand = self.nested(Self::unary)?;
                return Ok(expr(pos, ExprKind::Step(by, false, Box::new(operand))));
            }
            Tok::P("(") => {
                if let Some(cast) = self.cast()? {
                    return Ok(cast);
                }
                return self.postfix();
            }
            Tok::P("&" | "*") => return self.unsupported("A pointer"),
            Tok::P("^") => return self.unsupported("An index from the end"),
            Tok::Ident(name) if &**name == "await" && matches!(self.ahead(1), Tok::Ident(_)) => {
                return self.unsupported("await");
            }
            _ => return self.postfix(),
        };
        self.advance();
        let operand = self.nested(Self::unary)?;
        Ok(expr(pos, ExprKind::Unary(op, Box::new(operand))))
    }

    /// `(T)a`, when it is one.
    fn cast(&mut self) -> Checked<Option<Expr>> {
        if self.is_lambda() {
            return Ok(None);
        }
        let pos = self.pos();
        let ty = self.attempt(|p| {
            p.expect("(")?;
            let predefined = p.predefined().is_some();
            let ty = p.type_ref()?;
            p.expect(")")?;
            let sure = predefined
                || matches!(
                    ty.kind,
                    super::super::ast::TypeRefKind::Array(..) | super::super::ast::TypeRefKind::Nullable(_)
                );
            if p.after_cast(sure) { Ok(ty) } else { p.unsupported("not a cast") }
        });
        let Some(ty) = ty else { return Ok(None) };
        let operand = self.nested(Self::unary)?;
        Ok(Some(expr(pos, ExprKind::Cast(ty, Box::new(operand)))))
    }
}
