//! Blocks, `try`, `switch` and other statements made of blocks.

use super::super::ast::{Block, CaseLabel, Catch, Section, Stmt, StmtKind};
use super::Parser;
use crate::diagnostic::{Checked, Fault};
use crate::source::Pos;

pub(super) fn stmt(pos: Pos, kind: StmtKind) -> Stmt {
    Stmt { pos, kind }
}

impl Parser {
    pub(super) fn block(&mut self) -> Checked<Block> {
        self.nested(|p| {
            let pos = p.pos();
            p.expect("{")?;
            let mut stmts = Vec::new();
            while !p.is("}") {
                if p.at >= p.tokens.len() {
                    return Err(Fault::new(p.last_end(), 1513, "} expected"));
                }
                stmts.push(p.statement()?);
            }
            let end = p.pos();
            p.expect("}")?;
            Ok(Block { pos, end, stmts })
        })
    }

    pub(super) fn try_statement(&mut self) -> Checked<StmtKind> {
        self.expect_kw("try")?;
        let body = self.block()?;
        let mut catches = Vec::new();
        while self.is_kw("catch") {
            catches.push(self.catch()?);
        }
        let finally = if self.eat_kw("finally") { Some(self.block()?) } else { None };
        if catches.is_empty() && finally.is_none() {
            return Err(Fault::new(self.pos(), 1524, "Expected catch or finally"));
        }
        Ok(StmtKind::Try(body, catches, finally))
    }

    fn catch(&mut self) -> Checked<Catch> {
        let pos = self.pos();
        self.expect_kw("catch")?;
        let (mut ty, mut name, mut filter) = (None, None, None);
        if self.eat("(") {
            ty = Some(self.type_ref()?);
            if !self.is(")") {
                name = Some(self.ident()?);
            }
            self.expect(")")?;
        }
        if self.eat_word("when") {
            self.expect("(")?;
            filter = Some(self.expression()?);
            self.expect(")")?;
        }
        let body = self.block()?;
        Ok(Catch { pos, ty, name, filter, body })
    }

    pub(super) fn switch_statement(&mut self) -> Checked<StmtKind> {
        self.expect_kw("switch")?;
        self.expect("(")?;
        let mut subject = self.expression()?;
        if self.is(",") {
            // `switch (a, b)` goes over a tuple.
            let mut parts = vec![(None, subject)];
            while self.eat(",") {
                parts.push((None, self.expression()?));
            }
            let pos = parts.first().map_or(0, |(_, part)| part.pos);
            subject = super::expression::expr(pos, super::super::ast::ExprKind::Tuple(parts));
        }
        self.expect(")")?;
        self.expect("{")?;
        let mut sections = Vec::new();
        while !self.is("}") {
            let mut labels = Vec::new();
            while self.is_kw("case") || (self.is_kw("default") && self.is_ahead(1, ":")) {
                labels.push(self.label()?);
            }
            if labels.is_empty() {
                return Err(Fault::new(self.pos(), 1003, "Syntax error, 'case' or 'default' expected"));
            }
            let mut stmts = Vec::new();
            while !(self.is("}") || self.is_kw("case") || self.is_kw("default") && self.is_ahead(1, ":")) {
                if self.at >= self.tokens.len() {
                    return Err(Fault::new(self.last_end(), 1513, "} expected"));
                }
                stmts.push(self.statement()?);
            }
            sections.push(Section { labels, stmts });
        }
        self.expect("}")?;
        Ok(StmtKind::Switch(subject, sections))
    }

    fn label(&mut self) -> Checked<CaseLabel> {
        let pos = self.pos();
        if self.eat_kw("default") {
            self.expect(":")?;
            return Ok(CaseLabel::Default(pos));
        }
        self.expect_kw("case")?;
        let pattern = self.pattern()?;
        let guard = if self.eat_word("when") { Some(self.expression()?) } else { None };
        self.expect(":")?;
        Ok(CaseLabel::Case(Box::new(pattern), guard))
    }
}
