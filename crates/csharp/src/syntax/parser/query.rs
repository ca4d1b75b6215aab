//! Queries, translated to calls of methods (C# specification, query expression translation).
//!
//! Range variables beyond the first travel together in one anonymous object, whose members the next lambda's
//! parameter carries.

use std::sync::Arc;

use super::super::ast::{Arg, Expr, ExprKind, FnBody, LambdaParam, NamePart, Passing, TypeRef};
use super::super::token::{Name, Tok};
use super::Parser;
use super::expression::expr;
use crate::diagnostic::{Checked, Fault};
use crate::source::Pos;

impl Parser {
    pub(super) fn is_query(&self) -> bool {
        matches!(self.ahead(1), Tok::Ident(_) | Tok::Kw(_))
            && !matches!(self.ahead(1), Tok::Kw("is" | "as" | "in"))
            && !matches!(self.ahead(2), Tok::P("=" | ";" | ","))
    }

    pub(super) fn query(&mut self) -> Checked<Expr> {
        self.nested(|p| {
            let (name, source) = p.source_clause()?;
            p.query_body(source, vec![name])
        })
    }

    fn source_clause(&mut self) -> Checked<(Name, Expr)> {
        let pos = self.pos();
        self.advance();
        let (ty, name) = self.range_variable()?;
        self.expect_kw("in")?;
        let source = self.expression()?;
        Ok((name, cast(pos, source, ty)))
    }

    fn range_variable(&mut self) -> Checked<(Option<TypeRef>, Name)> {
        if matches!(self.ahead(1), Tok::Kw("in")) {
            return Ok((None, self.ident()?));
        }
        let ty = self.type_ref()?;
        Ok((Some(ty), self.ident()?))
    }

    fn query_body(&mut self, mut source: Expr, mut names: Vec<Name>) -> Checked<Expr> {
        loop {
            let pos = self.pos();
            self.deeper(2)?;
            let Tok::Ident(word) = self.tok() else {
                return Err(Fault::new(
                    pos,
                    742,
                    "A query body must end with a select clause or a group clause",
                ));
            };
            match &*word.clone() {
                "from" => {
                    let (name, inner) = self.source_clause()?;
                    let many = self.lambda_of(pos, &names, inner);
                    let (joined, all) = self.joined(pos, &names, &name);
                    source = call(pos, source, "SelectMany", vec![many, joined]);
                    names = all;
                }
                "let" => {
                    self.advance();
                    let name = self.ident()?;
                    self.expect("=")?;
                    let value = self.expression()?;
                    let object = anonymous(pos, &names, Some((name.clone(), value)));
                    let select = self.lambda_of(pos, &names, object);
                    source = call(pos, source, "Select", vec![select]);
                    names.push(name);
                }
                "where" => {
                    self.advance();
                    let condition = self.expression()?;
                    let test = self.lambda_of(pos, &names, condition);
                    source = call(pos, source, "Where", vec![test]);
                }
                "join" => (source, names) = self.join_clause(source, names)?,
                "orderby" => source = self.order_clause(source, &names)?,
                "select" => {
                    self.advance();
                    let value = self.expression()?;
                    let select = self.lambda_of(pos, &names, value);
                    let result = call(pos, source, "Select", vec![select]);
                    return self.continued(result);
                }
                "group" => {
                    self.advance();
                    let element = self.expression()?;
                    if !self.eat_word("by") {
                        return Err(Fault::new(self.pos(), 743, "Expected contextual keyword 'by'"));
                    }
                    let key = self.expression()?;
                    let key = self.lambda_of(pos, &names, key);
                    let element = self.lambda_of(pos, &names, element);
                    let result = call(pos, source, "GroupBy", vec![key, element]);
                    return self.continued(result);
                }
                _ => {
                    return Err(Fault::new(
                        pos,
                        742,
                        "A query body must end with a select clause or a group clause",
                    ));
                }
            }
        }
    }

    /// `into`
    fn continued(&mut self, source: Expr) -> Checked<Expr> {
        if !self.eat_word("into") {
            return Ok(source);
        }
        let name = self.ident()?;
        self.query_body(source, vec![name])
    }

    fn join_clause(&mut self, source: Expr, names: Vec<Name>) -> Checked<(Expr, Vec<Name>)> {
        let pos = self.pos();
        self.advance();
        let (ty, name) = self.range_variable()?;
        self.expect_kw("in")?;
        let inner = self.expression()?;
        let inner = cast(pos, inner, ty);
        if !self.eat_word("on") {
            return Err(Fault::new(self.pos(), 744, "Expected contextual keyword 'on'"));
        }
        let outer_key = self.expression()?;
        if !self.eat_word("equals") {
            return Err(Fault::new(self.pos(), 744, "Expected contextual keyword 'equals'"));
        }
        let inner_key = self.expression()?;
        let outer_key = self.lambda_of(pos, &names, outer_key);
        let inner_key = self.lambda_of(pos, std::slice::from_ref(&name), inner_key);
        let (method, joined_name) =
            if self.eat_word("into") { ("GroupJoin", self.ident()?) } else { ("Join", name) };
        let (joined, all) = self.joined(pos, &names, &joined_name);
        Ok((call(pos, source, method, vec![inner, outer_key, inner_key, joined]), all))
    }

    fn order_clause(&mut self, mut source: Expr, names: &[Name]) -> Checked<Expr> {
        let pos = self.pos();
        self.advance();
        let mut first = true;
        loop {
            let key = self.expression()?;
            let descending = self.eat_word("descending");
            if !descending {
                self.eat_word("ascending");
            }
            let method = match (first, descending) {
                (true, false) => "OrderBy",
                (true, true) => "OrderByDescending",
                (false, false) => "ThenBy",
                (false, true) => "ThenByDescending",
            };
            let key = self.lambda_of(pos, names, key);
            source = call(pos, source, method, vec![key]);
            first = false;
            if !self.eat(",") {
                return Ok(source);
            }
            self.deeper(1)?;
        }
    }

    fn lambda_of(&mut self, pos: Pos, names: &[Name], body: Expr) -> Expr {
        let param = self.carrier(pos, names);
        expr(pos, ExprKind::Lambda(Some(vec![param]), Arc::new(FnBody::Expr(Box::new(body)))))
    }

    /// One range variable is the parameter itself; several are members of it.
    fn carrier(&mut self, pos: Pos, names: &[Name]) -> LambdaParam {
        let (name, carries) = match names {
            [one] => (one.clone(), Vec::new()),
            _ => (self.made_name("range"), names.to_vec()),
        };
        LambdaParam { pos, name, ty: None, passing: Passing::Value, carries }
    }

    /// A lambda that puts one more range variable to those that are there.
    fn joined(&mut self, pos: Pos, names: &[Name], name: &Name) -> (Expr, Vec<Name>) {
        let first = self.carrier(pos, names);
        let second = self.carrier(pos, std::slice::from_ref(name));
        let mut all = names.to_vec();
        all.push(name.clone());
        let object = anonymous(pos, &all, None);
        let body = Arc::new(FnBody::Expr(Box::new(object)));
        (expr(pos, ExprKind::Lambda(Some(vec![first, second]), body)), all)
    }
}

fn variable(pos: Pos, name: &Name) -> Expr {
    expr(pos, ExprKind::Name(NamePart { pos, name: name.clone(), args: Vec::new(), open: 0 }))
}

fn anonymous(pos: Pos, names: &[Name], more: Option<(Name, Expr)>) -> Expr {
    let mut members: Vec<_> = names.iter().map(|name| (name.clone(), variable(pos, name))).collect();
    members.extend(more);
    expr(pos, ExprKind::Anonymous(members))
}

fn call(pos: Pos, receiver: Expr, method: &str, args: Vec<Expr>) -> Expr {
    call_with(pos, receiver, method, Vec::new(), args)
}

fn call_with(pos: Pos, receiver: Expr, method: &str, types: Vec<TypeRef>, args: Vec<Expr>) -> Expr {
    let part = NamePart { pos, name: method.into(), args: types, open: 0 };
    let callee = expr(pos, ExprKind::Member(Box::new(receiver), part));
    let args = args.into_iter().map(|value| Arg { name: None, passing: Passing::Value, value }).collect();
    expr(pos, ExprKind::Call(Box::new(callee), args))
}

/// A range variable with a type casts its source.
fn cast(pos: Pos, source: Expr, ty: Option<TypeRef>) -> Expr {
    match ty {
        Some(ty) => call_with(pos, source, "Cast", vec![ty], Vec::new()),
        None => source,
    }
}
