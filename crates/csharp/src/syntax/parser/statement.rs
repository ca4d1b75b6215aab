//! Statements.

use std::sync::Arc;

use super::super::ast::{
    Designation, Expr, ExprKind, Method, Modifiers, Stmt, StmtKind, TypeRef, TypeRefKind, Variable,
};
use super::super::token::Tok;
use super::Parser;
use super::block::stmt;
use crate::diagnostic::{Checked, Fault};

impl Parser {
    pub(super) fn statement(&mut self) -> Checked<Stmt> {
        self.nested(|p| {
            let pos = p.pos();
            let kind = p.statement_kind()?;
            Ok(stmt(pos, kind))
        })
    }

    fn statement_kind(&mut self) -> Checked<StmtKind> {
        match self.tok() {
            Tok::P("{") => Ok(StmtKind::Block(self.block()?)),
            Tok::P(";") => {
                self.advance();
                Ok(StmtKind::Empty)
            }
            Tok::Kw(word) => {
                let word = *word;
                match self.by_statement_keyword(word)? {
                    Some(kind) => Ok(kind),
                    None => self.declaration_or_expression(),
                }
            }
            Tok::Ident(name)
                if &**name == "yield" && matches!(self.ahead(1), Tok::Kw("return" | "break")) =>
            {
                self.yields = true;
                self.advance();
                let value = if self.eat_kw("break") {
                    None
                } else {
                    self.advance();
                    Some(self.expression()?)
                };
                self.expect(";")?;
                Ok(StmtKind::Yield(value))
            }
            Tok::Ident(name) if &**name == "async" && matches!(self.ahead(1), Tok::Ident(_) | Tok::Kw(_)) => {
                self.unsupported("async")
            }
            Tok::Ident(_) if self.is_ahead(1, ":") && !self.is_ahead(1, "::") => {
                let name = self.ident()?;
                self.advance();
                let inner = self.statement()?;
                Ok(StmtKind::Label(name, Box::new(inner)))
            }
            _ => self.declaration_or_expression(),
        }
    }

    /// The statement that a keyword begins; none when the keyword begins a type or an expression.
    fn by_statement_keyword(&mut self, word: &str) -> Checked<Option<StmtKind>> {
        Ok(Some(match word {
            "if" => {
                self.advance();
                let condition = self.condition()?;
                let yes = Box::new(self.embedded()?);
                let no = if self.eat_kw("else") { Some(Box::new(self.embedded()?)) } else { None };
                StmtKind::If(condition, yes, no)
            }
            "while" => {
                self.advance();
                let condition = self.condition()?;
                StmtKind::While(condition, Box::new(self.embedded()?))
            }
            "do" => {
                self.advance();
                let body = Box::new(self.embedded()?);
                self.expect_kw("while")?;
                let condition = self.condition()?;
                self.expect(";")?;
                StmtKind::Do(body, condition)
            }
            "for" => self.for_statement()?,
            "foreach" => self.foreach_statement()?,
            "switch" => self.switch_statement()?,
            "try" => self.try_statement()?,
            "break" | "continue" => {
                self.advance();
                self.expect(";")?;
                if word == "break" { StmtKind::Break } else { StmtKind::Continue }
            }
            "return" | "throw" => {
                self.advance();
                let value = if self.is(";") { None } else { Some(self.value_or_reference()?) };
                self.expect(";")?;
                if word == "return" { StmtKind::Return(value) } else { StmtKind::Throw(value) }
            }
            "goto" => self.goto_statement()?,
            "lock" => {
                self.advance();
                let object = self.condition()?;
                StmtKind::Lock(object, Box::new(self.embedded()?))
            }
            "using" => self.using_statement()?,
            "checked" | "unchecked" if self.is_ahead(1, "{") => {
                self.advance();
                StmtKind::Checked(word == "checked", self.block()?)
            }
            "const" => {
                self.advance();
                let kind = self.local(true, false)?;
                self.expect(";")?;
                kind
            }
            "static" => {
                self.advance();
                self.declaration_or_expression()?
            }
            "unsafe" | "fixed" => return self.unsupported("unsafe code"),
            "ref" => self.reference_statement()?,
            "else" => return Err(self.no_expression()),
            _ => return Ok(None),
        }))
    }

    /// `ref T a = ref b;`, or a function in a function that gives a reference.
    fn reference_statement(&mut self) -> Checked<StmtKind> {
        self.advance();
        let fixed = self.eat_kw("readonly");
        if let Some(mut function) = self.local_function()? {
            function.modifiers = function.modifiers.with("ref");
            return Ok(StmtKind::Function(Arc::new(function)));
        }
        let ty = self.type_ref()?;
        let ty = if matches!(ty.kind, TypeRefKind::Var) { None } else { Some(ty) };
        let variables = self.variables()?;
        self.expect(";")?;
        Ok(StmtKind::Reference(ty, variables, fixed))
    }

    /// A value, or `ref` and a variable.
    pub(super) fn value_or_reference(&mut self) -> Checked<Expr> {
        let pos = self.pos();
        if !self.eat_kw("ref") {
            return self.expression();
        }
        let place = self.expression()?;
        Ok(Expr { pos, kind: ExprKind::Ref(Box::new(place)) })
    }

    fn condition(&mut self) -> Checked<Expr> {
        self.expect("(")?;
        let value = self.expression()?;
        self.expect(")")?;
        Ok(value)
    }

    /// A statement that cannot be a declaration.
    fn embedded(&mut self) -> Checked<Stmt> {
        let inner = self.statement()?;
        if matches!(inner.kind, StmtKind::Local { .. } | StmtKind::Function(_)) {
            return Err(Fault::new(
                inner.pos,
                1023,
                "Embedded statement cannot be a declaration or labeled statement",
            ));
        }
        Ok(inner)
    }

    fn for_statement(&mut self) -> Checked<StmtKind> {
        self.advance();
        self.expect("(")?;
        let mut first = Vec::new();
        let pos = self.pos();
        if !self.is(";") {
            if self.is_declaration() {
                let kind = self.local(false, false)?;
                first.push(stmt(pos, kind));
            } else {
                for value in self.expressions()? {
                    first.push(stmt(value.pos, StmtKind::Expr(value)));
                }
            }
        }
        self.expect(";")?;
        let condition = if self.is(";") { None } else { Some(self.expression()?) };
        self.expect(";")?;
        let step = if self.is(")") { Vec::new() } else { self.expressions()? };
        self.expect(")")?;
        Ok(StmtKind::For(first, condition, step, Box::new(self.embedded()?)))
    }

    fn expressions(&mut self) -> Checked<Vec<Expr>> {
        let mut list = vec![self.expression()?];
        while self.eat(",") {
            list.push(self.expression()?);
        }
        Ok(list)
    }

    fn foreach_statement(&mut self) -> Checked<StmtKind> {
        self.advance();
        self.expect("(")?;
        let pos = self.pos();
        let (ty, names) = if self.is_word("var") && self.is_ahead(1, "(") {
            self.advance();
            (TypeRef { pos, kind: TypeRefKind::Var }, self.designation()?)
        } else {
            let ty = self.type_ref()?;
            let at = self.pos();
            if self.is_kw("in") {
                return Err(Fault::new(
                    self.pos(),
                    230,
                    "Type and identifier are both required in a foreach statement",
                ));
            }
            let name = self.ident()?;
            (ty, Designation::Name(at, name))
        };
        self.expect_kw("in")?;
        let source = self.expression()?;
        self.expect(")")?;
        Ok(StmtKind::Foreach(ty, names, source, Box::new(self.embedded()?)))
    }

    fn goto_statement(&mut self) -> Checked<StmtKind> {
        self.advance();
        let kind = if self.eat_kw("case") {
            StmtKind::GotoCase(Some(self.expression()?))
        } else if self.eat_kw("default") {
            StmtKind::GotoCase(None)
        } else {
            StmtKind::Goto(self.ident()?)
        };
        self.expect(";")?;
        Ok(kind)
    }

    fn using_statement(&mut self) -> Checked<StmtKind> {
        self.advance();
        if !self.is("(") {
            let kind = self.local(false, true)?;
            self.expect(";")?;
            return Ok(kind);
        }
        self.expect("(")?;
        let pos = self.pos();
        let held = if self.is_declaration() {
            let kind = self.local(false, false)?;
            stmt(pos, kind)
        } else {
            let value = self.expression()?;
            stmt(pos, StmtKind::Expr(value))
        };
        self.expect(")")?;
        Ok(StmtKind::Using(Box::new(held), Box::new(self.embedded()?)))
    }

    fn declaration_or_expression(&mut self) -> Checked<StmtKind> {
        if self.is_declaration() {
            if let Some(function) = self.local_function()? {
                return Ok(StmtKind::Function(Arc::new(function)));
            }
            let kind = self.local(false, false)?;
            self.expect(";")?;
            return Ok(kind);
        }
        let value = self.expression()?;
        let allowed = matches!(
            value.kind,
            ExprKind::Assign(..)
                | ExprKind::Call(..)
                | ExprKind::Step(..)
                | ExprKind::New(..)
                | ExprKind::Conditional(..)
        );
        if !allowed {
            let code = Fault::new(
                value.pos,
                201,
                "Only assignment, call, increment, decrement, await, and new object expressions can be used as a statement",
            );
            return Err(if self.is(";") { code } else { Fault::new(self.last_end(), 1002, "; expected") });
        }
        self.expect(";")?;
        Ok(StmtKind::Expr(value))
    }

    fn local_function(&mut self) -> Checked<Option<Method>> {
        let start = self.at;
        let void = matches!(self.tok(), Tok::Kw("void"));
        let ty = self.type_ref()?;
        let pos = self.pos();
        if !matches!(self.tok(), Tok::Ident(_)) || !(self.is_ahead(1, "(") || self.is_ahead(1, "<")) {
            self.at = start;
            return Ok(None);
        }
        let name = self.ident()?;
        let ret = if void { None } else { Some(ty) };
        self.method_rest(pos, name, Modifiers::default(), ret, None).map(Some)
    }

    /// `int a = 1, b`
    pub(super) fn local(&mut self, constant: bool, using: bool) -> Checked<StmtKind> {
        let ty = self.type_ref()?;
        let variables = self.variables()?;
        Ok(StmtKind::Local { ty, variables, constant, using })
    }

    pub(super) fn variables(&mut self) -> Checked<Vec<Variable>> {
        let mut list = Vec::new();
        loop {
            let pos = self.pos();
            let name = self.ident()?;
            if self.is("[") {
                return Err(Fault::new(
                    self.pos(),
                    650,
                    "Bad array declarator: To declare a managed array the rank specifier precedes the variable's identifier.",
                ));
            }
            let value = if self.eat("=") {
                Some(if self.is("{") { self.array_initialiser()? } else { self.value_or_reference()? })
            } else {
                None
            };
            list.push(Variable { pos, name, value });
            if !self.eat(",") {
                return Ok(list);
            }
        }
    }
}
