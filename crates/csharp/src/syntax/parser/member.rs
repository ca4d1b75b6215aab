//! Members of types: fields, methods, constructors, operators, properties, indexers.

use std::sync::Arc;

use super::super::ast::{
    FnBody, Member, Method, Modifiers, Param, Property, TypeParam, TypeRef, TypeRefKind,
};
use super::super::token::{Name, Tok};
use super::Parser;
use crate::diagnostic::{Checked, Fault};
use crate::source::Pos;

type Accessor = Option<(Pos, Modifiers, Option<FnBody>)>;

impl Parser {
    pub(super) fn modifiers(&mut self) -> Modifiers {
        let mut found = Modifiers::default();
        loop {
            let word: &str = match self.tok() {
                Tok::Kw(word) => word,
                Tok::Ident(name)
                    if matches!(&**name, "partial" | "async")
                        && matches!(self.ahead(1), Tok::Ident(_) | Tok::Kw(_)) =>
                {
                    name
                }
                _ => return found,
            };
            let Some(bit) = Modifiers::WORDS.iter().position(|w| *w == word) else { return found };
            found.0 |= 1 << bit;
            self.advance();
        }
    }

    pub(super) fn member(&mut self, owner: &str) -> Checked<Member> {
        self.attributes()?;
        let modifiers = self.modifiers();
        if modifiers.has("async") {
            return self.unsupported("async");
        }
        if modifiers.has("unsafe") {
            return self.unsupported("unsafe code");
        }
        let pos = self.pos();
        if modifiers.has("event") {
            return self.event(modifiers);
        }
        if self.is_type_declaration() {
            return Ok(Member::Type(Arc::new(self.type_declaration(modifiers)?)));
        }
        match self.tok() {
            Tok::P("~") => return self.unsupported("A finalizer"),
            Tok::Kw("implicit" | "explicit") => return self.conversion(modifiers),
            Tok::Ident(name) if &**name == owner && self.is_ahead(1, "(") => {
                return self.constructor(modifiers);
            }
            _ => {}
        }
        let void = matches!(self.tok(), Tok::Kw("void"));
        let ty = self.type_ref()?;
        if self.is("(") {
            return Err(Fault::new(pos, 1520, "Method must have a return type"));
        }
        if self.is_kw("operator") {
            return self.operator_method(modifiers, ty);
        }
        let (explicit, name_pos, name) = self.member_title()?;
        if &*name == "this" {
            let params = self.params("[", "]")?;
            return self.property(name_pos, "Item".into(), modifiers, ty, params, explicit);
        }
        if self.is("(") || self.is("<") {
            let ret = if void { None } else { Some(ty) };
            return Ok(Member::Method(Arc::new(self.method_rest(name_pos, name, modifiers, ret, explicit)?)));
        }
        if self.is("{") || self.is("=>") {
            return self.property(name_pos, name, modifiers, ty, Vec::new(), explicit);
        }
        self.at -= 1;
        let variables = self.variables()?;
        self.expect(";")?;
        Ok(Member::Field(modifiers, ty, variables))
    }

    /// The name of a member, behind the interface it belongs to where that is written.
    fn member_title(&mut self) -> Checked<(Option<TypeRef>, Pos, Name)> {
        let start = self.pos();
        let mut parts = Vec::new();
        loop {
            let pos = self.pos();
            if self.eat_kw("this") {
                return Ok((explicit(start, parts), pos, "this".into()));
            }
            let name = self.ident()?;
            let args = if self.is("<") {
                self.attempt(|p| {
                    let args = p.type_args()?;
                    if p.is(".") { Ok(args) } else { p.unsupported("type parameters") }
                })
            } else {
                None
            };
            if !self.is(".") {
                return Ok((explicit(start, parts), pos, name));
            }
            self.advance();
            parts.push(super::super::ast::NamePart { pos, name, args: args.unwrap_or_default(), open: 0 });
        }
    }

    pub(super) fn method_rest(
        &mut self,
        pos: Pos,
        name: Name,
        modifiers: Modifiers,
        ret: Option<TypeRef>,
        explicit: Option<TypeRef>,
    ) -> Checked<Method> {
        let mut type_params = self.type_params()?;
        let params = self.params("(", ")")?;
        self.constraints(&mut type_params)?;
        let (body, iterator) = self.body()?;
        Ok(Method { pos, name, modifiers, ret, type_params, params, explicit, chain: None, body, iterator })
    }

    /// A body, or `;`; and whether `yield` stands in it.
    fn body(&mut self) -> Checked<(Option<FnBody>, bool)> {
        let outer = std::mem::replace(&mut self.yields, false);
        let body = if self.eat("=>") {
            let value = self.value_or_reference()?;
            self.expect(";")?;
            Some(FnBody::Expr(Box::new(value)))
        } else if self.is("{") {
            Some(FnBody::Block(self.block()?))
        } else {
            self.expect(";")?;
            None
        };
        Ok((body, std::mem::replace(&mut self.yields, outer)))
    }

    fn constructor(&mut self, modifiers: Modifiers) -> Checked<Member> {
        let pos = self.pos();
        self.advance();
        let params = self.params("(", ")")?;
        let mut chain = None;
        if self.eat(":") {
            let at = self.pos();
            let base = self.is_kw("base");
            if !base && !self.is_kw("this") {
                return Err(Fault::new(at, 1018, "Keyword 'this' or 'base' expected"));
            }
            self.advance();
            chain = Some((base, at, self.arguments()?));
        }
        let (body, iterator) = self.body()?;
        let name = if modifiers.has("static") { ".cctor" } else { ".ctor" }.into();
        Ok(Member::Method(Arc::new(Method {
            pos,
            name,
            modifiers,
            ret: None,
            type_params: Vec::new(),
            params,
            explicit: None,
            chain,
            body,
            iterator,
        })))
    }

    fn conversion(&mut self, modifiers: Modifiers) -> Checked<Member> {
        let pos = self.pos();
        let name: Name = if self.is_kw("implicit") { "op_Implicit" } else { "op_Explicit" }.into();
        self.advance();
        self.expect_kw("operator")?;
        let ty = self.type_ref()?;
        Ok(Member::Method(Arc::new(self.method_rest(pos, name, modifiers, Some(ty), None)?)))
    }

    fn operator_method(&mut self, modifiers: Modifiers, ret: TypeRef) -> Checked<Member> {
        self.expect_kw("operator")?;
        let pos = self.pos();
        let shift = self.is(">") && self.adjacent_shift(">");
        let symbol = match self.tok() {
            Tok::P(_) if shift => ">>",
            Tok::P(p) => p,
            Tok::Kw(word @ ("true" | "false")) => word,
            _ => return Err(Fault::new(pos, 1037, "Overloadable operator expected")),
        };
        self.at += if shift { 2 } else { 1 };
        let params_at = self.at;
        let unary = self.params("(", ")")?.len() == 1;
        self.at = params_at;
        let Some(name) = operator_name(symbol, unary) else {
            return Err(Fault::new(pos, 1037, "Overloadable operator expected"));
        };
        Ok(Member::Method(Arc::new(self.method_rest(pos, name.into(), modifiers, Some(ret), None)?)))
    }

    fn property(
        &mut self,
        pos: Pos,
        name: Name,
        modifiers: Modifiers,
        ty: TypeRef,
        params: Vec<Param>,
        explicit: Option<TypeRef>,
    ) -> Checked<Member> {
        let (mut getter, mut setter): (Accessor, Accessor) = (None, None);
        let mut value = None;
        let mut iterator = false;
        if self.is("=>") {
            let (body, yields) = self.body()?;
            iterator = yields;
            getter = Some((pos, Modifiers::default(), body));
        } else {
            self.expect("{")?;
            while !self.is("}") {
                self.attributes()?;
                let words = self.modifiers();
                let at = self.pos();
                let which = self.ident()?;
                let (body, yields) = self.body()?;
                match &*which {
                    "get" => {
                        getter = Some((at, words, body));
                        iterator = yields;
                    }
                    "set" | "init" => setter = Some((at, words, body)),
                    _ => return Err(Fault::new(at, 1014, "A get or set accessor expected")),
                }
            }
            self.expect("}")?;
            if self.eat("=") {
                value = Some(if self.is("{") { self.array_initialiser()? } else { self.expression()? });
                self.expect(";")?;
            }
        }
        Ok(Member::Property(Arc::new(Property {
            pos,
            name,
            modifiers,
            ty,
            params,
            explicit,
            getter,
            setter,
            value,
            iterator,
        })))
    }

    /// An event is a property of a delegate type: who is not its type only adds to it and takes away. With accessors of
    /// its own, `add` stands for `get` and `remove` for `set`.
    fn event(&mut self, modifiers: Modifiers) -> Checked<Member> {
        let ty = self.type_ref()?;
        let (explicit, pos, name) = self.member_title()?;
        let (mut getter, mut setter): (Accessor, Accessor) = (None, None);
        let mut value = None;
        if self.eat("{") {
            while !self.is("}") {
                self.attributes()?;
                let at = self.pos();
                let which = self.ident()?;
                let (body, _) = self.body()?;
                match &*which {
                    "add" => getter = Some((at, Modifiers::default(), body)),
                    "remove" => setter = Some((at, Modifiers::default(), body)),
                    _ => return Err(Fault::new(at, 1055, "An add or remove accessor expected")),
                }
            }
            self.expect("}")?;
            if getter.is_none() || setter.is_none() {
                let message = format!("'{name}': event property must have both add and remove accessors");
                return Err(Fault::new(pos, 65, message));
            }
        } else {
            getter = Some((pos, Modifiers::default(), None));
            setter = Some((pos, Modifiers::default(), None));
            if self.eat("=") {
                value = Some(self.expression()?);
            }
            if self.is(",") {
                return self.unsupported("Several events in one declaration");
            }
            self.expect(";")?;
        }
        let params = Vec::new();
        let iterator = false;
        Ok(Member::Property(Arc::new(Property {
            pos,
            name,
            modifiers,
            ty,
            params,
            explicit,
            getter,
            setter,
            value,
            iterator,
        })))
    }

    pub(super) fn params(&mut self, open: &'static str, close: &'static str) -> Checked<Vec<Param>> {
        self.expect(open)?;
        let mut params = Vec::new();
        while !self.is(close) {
            self.attributes()?;
            let extends = self.eat_kw("this");
            let rest = self.eat_kw("params");
            let passing = self.passing();
            let ty = self.type_ref()?;
            if matches!(ty.kind, TypeRefKind::Var) {
                return Err(Fault::new(
                    ty.pos,
                    825,
                    "The contextual keyword 'var' may only appear within a local variable declaration or in script code",
                ));
            }
            let pos = self.pos();
            let name = self.ident()?;
            let default = if self.eat("=") { Some(self.expression()?) } else { None };
            params.push(Param { pos, name, ty, passing, rest, extends, default });
            if !self.eat(",") {
                break;
            }
        }
        self.expect(close)?;
        Ok(params)
    }

    pub(super) fn type_params(&mut self) -> Checked<Vec<TypeParam>> {
        let mut list = Vec::new();
        if self.eat("<") {
            loop {
                self.attributes()?;
                // Variance of interfaces and delegates: conversions know the library's by name.
                let _ = self.eat_kw("in") || self.eat_kw("out");
                let pos = self.pos();
                let name = self.ident()?;
                list.push(TypeParam {
                    pos,
                    name,
                    bounds: Vec::new(),
                    class: false,
                    structure: false,
                    creatable: false,
                });
                if !self.eat(",") {
                    break;
                }
            }
            self.expect(">")?;
        }
        Ok(list)
    }

    pub(super) fn constraints(&mut self, params: &mut [TypeParam]) -> Checked<()> {
        while self.is_word("where") {
            self.advance();
            let pos = self.pos();
            let name = self.ident()?;
            self.expect(":")?;
            let Some(param) = params.iter_mut().find(|param| param.name == name) else {
                return Err(Fault::new(pos, 699, format!("The type parameter '{name}' is not declared")));
            };
            if param.class || param.structure || param.creatable || !param.bounds.is_empty() {
                let message =
                    format!("A constraint clause has already been specified for type parameter '{name}'");
                return Err(Fault::new(pos, 409, message));
            }
            loop {
                if param.creatable {
                    let message = "The new() constraint must be the last constraint specified";
                    return Err(Fault::new(self.pos(), 401, message));
                }
                let first = !param.class && !param.structure && param.bounds.is_empty();
                if (self.is_kw("class") || self.is_kw("struct")) && !first {
                    let message = "The 'class' or 'struct' constraint must be the first constraint specified";
                    return Err(Fault::new(self.pos(), 449, message));
                }
                if self.eat_kw("class") {
                    param.class = true;
                } else if self.eat_kw("struct") {
                    param.structure = true;
                } else if self.is_kw("new") {
                    self.advance();
                    self.expect("(")?;
                    self.expect(")")?;
                    param.creatable = true;
                } else {
                    param.bounds.push(self.type_ref()?);
                }
                if !self.eat(",") {
                    break;
                }
            }
        }
        Ok(())
    }
}

fn explicit(pos: Pos, parts: Vec<super::super::ast::NamePart>) -> Option<TypeRef> {
    if parts.is_empty() { None } else { Some(TypeRef { pos, kind: TypeRefKind::Named(parts) }) }
}

/// The names of operators in the specification.
fn operator_name(symbol: &str, unary: bool) -> Option<&'static str> {
    Some(match (symbol, unary) {
        ("+", true) => "op_UnaryPlus",
        ("-", true) => "op_UnaryNegation",
        ("!", true) => "op_LogicalNot",
        ("~", true) => "op_OnesComplement",
        ("++", true) => "op_Increment",
        ("--", true) => "op_Decrement",
        ("true", true) => "op_True",
        ("false", true) => "op_False",
        ("+", false) => "op_Addition",
        ("-", false) => "op_Subtraction",
        ("*", false) => "op_Multiply",
        ("/", false) => "op_Division",
        ("%", false) => "op_Modulus",
        ("&", false) => "op_BitwiseAnd",
        ("|", false) => "op_BitwiseOr",
        ("^", false) => "op_ExclusiveOr",
        ("<<", false) => "op_LeftShift",
        (">>", false) => "op_RightShift",
        ("==", false) => "op_Equality",
        ("!=", false) => "op_Inequality",
        ("<", false) => "op_LessThan",
        (">", false) => "op_GreaterThan",
        ("<=", false) => "op_LessThanOrEqual",
        (">=", false) => "op_GreaterThanOrEqual",
        _ => return None,
    })
}
