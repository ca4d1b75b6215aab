//! Files, namespaces and types.

use std::sync::Arc;

use super::super::ast::{
    Method, Modifiers, Namespace, TypeDecl, TypeKind, TypeRef, TypeRefKind, Using, Variable,
};
use super::super::token::{Name, Tok};
use super::Parser;
use crate::diagnostic::{Checked, Fault};

impl Parser {
    pub(super) fn namespace_body(&mut self, into: &mut Namespace, file: bool) -> Checked<()> {
        loop {
            let pos = self.pos();
            match self.tok() {
                Tok::Eof if file => return Ok(()),
                Tok::P("}") if !file => return Ok(()),
                Tok::P(";") => self.advance(),
                Tok::Kw("using") => into.usings.push(self.using()?),
                Tok::Kw("extern") => return self.unsupported("extern alias"),
                Tok::Kw("namespace") => {
                    self.advance();
                    let name = self.dotted()?;
                    let mut inner = Namespace { name, ..Namespace::default() };
                    if self.eat(";") {
                        self.namespace_body(&mut inner, true)?;
                        into.inner.push(inner);
                        return Ok(());
                    }
                    self.expect("{")?;
                    self.nested(|p| p.namespace_body(&mut inner, false))?;
                    self.expect("}")?;
                    into.inner.push(inner);
                }
                Tok::Eof => return Err(Fault::new(self.last_end(), 1513, "} expected")),
                _ => {
                    let attributes = self.attributes()?;
                    let modifiers = self.modifiers();
                    if !self.is_type_declaration() {
                        return Err(self.no_type_here(pos));
                    }
                    let mut decl = self.type_declaration(modifiers)?;
                    decl.attributes = attributes;
                    into.types.push(Arc::new(decl));
                }
            }
        }
    }

    fn no_type_here(&self, pos: u32) -> Fault {
        match self.tok() {
            Tok::P("}") => Fault::new(pos, 1022, "Type or namespace definition, or end-of-file expected"),
            _ => Fault::new(
                pos,
                116,
                "A namespace cannot directly contain members such as fields, methods or statements",
            ),
        }
    }

    fn dotted(&mut self) -> Checked<String> {
        let mut name = self.ident()?.to_string();
        while self.eat(".") {
            name.push('.');
            name.push_str(&self.ident()?);
        }
        Ok(name)
    }

    fn using(&mut self) -> Checked<Using> {
        let pos = self.pos();
        self.advance();
        let statics = self.eat_kw("static");
        let mut alias = None;
        if matches!(self.tok(), Tok::Ident(_)) && self.is_ahead(1, "=") {
            alias = Some(self.ident()?);
            self.advance();
        }
        let target = self.type_ref()?;
        self.expect(";")?;
        Ok(Using { pos, alias, statics, target })
    }

    /// Attributes are read and dropped, but for their names.
    pub(super) fn attributes(&mut self) -> Checked<Vec<Name>> {
        let mut names = Vec::new();
        while self.is("[") {
            self.advance();
            let mut depth = 1_u32;
            while depth > 0 {
                match self.tok() {
                    Tok::P("[") => depth += 1,
                    Tok::P("]") => depth -= 1,
                    Tok::Ident(name) => {
                        if &**name == "DllImport" {
                            return self.unsupported("DllImport");
                        }
                        names.push(name.clone());
                    }
                    Tok::Eof => return Err(Fault::new(self.last_end(), 1003, "Syntax error, ']' expected")),
                    _ => {}
                }
                self.advance();
            }
        }
        Ok(names)
    }

    pub(super) fn is_type_declaration(&self) -> bool {
        matches!(self.tok(), Tok::Kw("class" | "struct" | "interface" | "enum" | "delegate"))
            || (self.is_word("record") && matches!(self.ahead(1), Tok::Ident(_)))
    }

    pub(super) fn type_declaration(&mut self, modifiers: Modifiers) -> Checked<TypeDecl> {
        self.nested(|p| {
            let kind = match p.tok() {
                Tok::Kw("class") => TypeKind::Class,
                Tok::Kw("struct") => TypeKind::Struct,
                Tok::Kw("interface") => TypeKind::Interface,
                Tok::Kw("enum") => TypeKind::Enum,
                Tok::Kw("delegate") => TypeKind::Delegate,
                _ => return p.unsupported("A record"),
            };
            p.advance();
            if kind == TypeKind::Delegate {
                return p.delegate(modifiers);
            }
            let pos = p.pos();
            let name = p.ident()?;
            let mut decl = TypeDecl {
                pos,
                kind,
                name,
                modifiers,
                attributes: Vec::new(),
                type_params: p.type_params()?,
                bases: Vec::new(),
                members: Vec::new(),
                values: Vec::new(),
                invoke: None,
            };
            if p.eat(":") {
                decl.bases.push(p.type_ref()?);
                while p.eat(",") {
                    decl.bases.push(p.type_ref()?);
                }
            }
            p.constraints(&mut decl.type_params)?;
            p.expect("{")?;
            while !p.is("}") {
                if p.at >= p.tokens.len() {
                    return Err(Fault::new(p.last_end(), 1513, "} expected"));
                }
                if kind == TypeKind::Enum {
                    decl.values.push(p.enum_value()?);
                    if !p.eat(",") {
                        break;
                    }
                } else if !p.eat(";") {
                    let owner = decl.name.clone();
                    decl.members.push(p.member(&owner)?);
                }
            }
            p.expect("}")?;
            Ok(decl)
        })
    }

    fn enum_value(&mut self) -> Checked<Variable> {
        self.attributes()?;
        let pos = self.pos();
        let name = self.ident()?;
        let value = if self.eat("=") { Some(self.expression()?) } else { None };
        Ok(Variable { pos, name, value })
    }

    fn delegate(&mut self, modifiers: Modifiers) -> Checked<TypeDecl> {
        let void = matches!(self.tok(), Tok::Kw("void"));
        let ty: TypeRef = self.type_ref()?;
        let pos = self.pos();
        let name = self.ident()?;
        let mut type_params = self.type_params()?;
        let params = self.params("(", ")")?;
        self.constraints(&mut type_params)?;
        self.expect(";")?;
        let void = void && matches!(ty.kind, TypeRefKind::Named(_));
        let invoke = Method {
            pos,
            name: "Invoke".into(),
            modifiers: Modifiers(1),
            ret: if void { None } else { Some(ty) },
            type_params: Vec::new(),
            params,
            explicit: None,
            chain: None,
            body: None,
            iterator: false,
        };
        Ok(TypeDecl {
            pos,
            kind: TypeKind::Delegate,
            name,
            modifiers,
            attributes: Vec::new(),
            type_params,
            bases: Vec::new(),
            members: Vec::new(),
            values: Vec::new(),
            invoke: Some(Arc::new(invoke)),
        })
    }
}
