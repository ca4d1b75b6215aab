//! Expressions: assignments, lambdas, conditions.

use std::sync::Arc;

use super::super::ast::{BinaryOp, Block, Expr, ExprKind, FnBody, LambdaParam, Passing};
use super::super::token::Tok;
use super::Parser;
use crate::diagnostic::Checked;
use crate::source::Pos;

pub(super) fn expr(pos: Pos, kind: ExprKind) -> Expr {
    Expr { pos, kind }
}

impl Parser {
    pub(super) fn expression(&mut self) -> Checked<Expr> {
        self.nested(Self::assignment)
    }

    fn assignment(&mut self) -> Checked<Expr> {
        if self.is_lambda()
            || (self.is_word("async")
                && matches!(self.ahead(1), Tok::Ident(_) | Tok::P("("))
                && (self.is_ahead(2, "=>") || self.is_ahead(1, "(") && self.async_lambda()))
        {
            return self.lambda();
        }
        if self.is_word("from") && self.is_query() {
            return self.query();
        }
        if self.is_kw("throw") {
            let pos = self.pos();
            self.advance();
            let value = self.expression()?;
            return Ok(expr(pos, ExprKind::Throw(Box::new(value))));
        }
        let left = self.choice()?;
        let pos = self.pos();
        let op = match self.tok() {
            Tok::P("=") => None,
            Tok::P("+=") => Some(BinaryOp::Add),
            Tok::P("-=") => Some(BinaryOp::Sub),
            Tok::P("*=") => Some(BinaryOp::Mul),
            Tok::P("/=") => Some(BinaryOp::Div),
            Tok::P("%=") => Some(BinaryOp::Rem),
            Tok::P("&=") => Some(BinaryOp::And),
            Tok::P("|=") => Some(BinaryOp::Or),
            Tok::P("^=") => Some(BinaryOp::Xor),
            Tok::P("<<=") => Some(BinaryOp::Shl),
            Tok::P("??=") => Some(BinaryOp::Coalesce),
            Tok::P(">") if self.adjacent_shift(">=") => {
                self.advance();
                Some(BinaryOp::Shr)
            }
            _ => return Ok(left),
        };
        self.advance();
        if self.is_kw("ref") {
            return self.unsupported("A reference to a variable");
        }
        let right = self.expression()?;
        Ok(expr(pos, ExprKind::Assign(op, Box::new(left), Box::new(right))))
    }

    fn async_lambda(&mut self) -> bool {
        self.at += 1;
        let is = self.is_lambda();
        self.at -= 1;
        is
    }

    /// Whether `>` here and the next token stand together as one operator.
    pub(super) fn adjacent_shift(&self, second: &str) -> bool {
        let (Some(a), Some(b)) = (self.tokens.get(self.at), self.tokens.get(self.at + 1)) else {
            return false;
        };
        a.end == b.pos && matches!(b.tok, Tok::P(p) if p == second)
    }

    fn choice(&mut self) -> Checked<Expr> {
        let condition = self.binary(0)?;
        if !self.is("?") {
            return Ok(condition);
        }
        let pos = self.pos();
        self.advance();
        let yes = self.expression()?;
        self.expect(":")?;
        let no = self.expression()?;
        Ok(expr(pos, ExprKind::Choice(Box::new(condition), Box::new(yes), Box::new(no))))
    }

    fn lambda(&mut self) -> Checked<Expr> {
        if self.is_word("async") && !self.is_ahead(1, "=>") {
            return self.unsupported("async");
        }
        let mut params = Vec::new();
        if self.eat("(") {
            while !self.is(")") {
                params.push(self.lambda_param()?);
                if !self.eat(",") {
                    break;
                }
            }
            self.expect(")")?;
        } else {
            let pos = self.pos();
            let name = self.ident()?;
            params.push(LambdaParam { pos, name, ty: None, passing: Passing::Value, carries: Vec::new() });
        }
        let pos = self.pos();
        self.expect("=>")?;
        self.lambda_body(pos, Some(params))
    }

    fn lambda_param(&mut self) -> Checked<LambdaParam> {
        let passing = self.passing();
        let typed = !matches!(self.ahead(1), Tok::P("," | ")"));
        let ty = if typed { Some(self.type_ref()?) } else { None };
        let pos = self.pos();
        let name = self.ident()?;
        Ok(LambdaParam { pos, name, ty, passing, carries: Vec::new() })
    }

    fn lambda_body(&mut self, pos: Pos, params: Option<Vec<LambdaParam>>) -> Checked<Expr> {
        let yields = std::mem::replace(&mut self.yields, false);
        let body = if self.is("{") {
            FnBody::Block(self.block()?)
        } else {
            FnBody::Expr(Box::new(self.expression()?))
        };
        self.yields = yields;
        Ok(expr(pos, ExprKind::Lambda(params, Arc::new(body))))
    }

    /// `delegate(...) { }`
    pub(super) fn anonymous_method(&mut self) -> Checked<Expr> {
        let pos = self.pos();
        self.expect_kw("delegate")?;
        let mut params = None;
        if self.eat("(") {
            let mut list = Vec::new();
            while !self.is(")") {
                list.push(self.lambda_param()?);
                if !self.eat(",") {
                    break;
                }
            }
            self.expect(")")?;
            params = Some(list);
        }
        let block: Block = {
            let yields = std::mem::replace(&mut self.yields, false);
            let block = self.block();
            self.yields = yields;
            block?
        };
        Ok(expr(pos, ExprKind::Lambda(params, Arc::new(FnBody::Block(block)))))
    }

    pub(super) fn passing(&mut self) -> Passing {
        for (word, passing) in [("ref", Passing::Ref), ("out", Passing::Out), ("in", Passing::In)] {
            if self.eat_kw(word) {
                return passing;
            }
        }
        Passing::Value
    }
}
