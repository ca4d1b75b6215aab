//! Properties, structures, enums and constructors of VB as C#.

use super::token::Kind;
use super::{Block, Writer, Wrong, escaped};

impl Writer {
    /// `Property P As T = v`, or one with `Get` and `Set`.
    pub(super) fn property(&mut self, line: usize, access: &str, halves: Halves) -> Result<(), Wrong> {
        self.at += 1;
        let name = self.word()?;
        let name = self.spelled(&name);
        let mut parameters = Vec::new();
        if self.take_op("(") {
            while !self.take_op(")") {
                parameters.push(self.parameter()?);
                if !self.is_op(")") {
                    self.expect_op(",")?;
                }
            }
        }
        let kind = if self.take("as") { self.array_type()? } else { "dynamic".to_owned() };
        let value = if self.take_op("=") { Some(self.expression()?) } else { None };
        let mut ahead = self.at;
        while self.tokens.get(ahead).is_some_and(|token| token.kind == Kind::End) {
            ahead += 1;
        }
        let is_written = self.tokens.get(ahead).is_some_and(|token| token.is("get") || token.is("set"));
        if !is_written {
            let set = if halves == Halves::Get { "" } else { " set;" };
            let value = value.map_or_else(String::new, |value| format!(" = {value};"));
            self.put(line, &format!("{access} {kind} {name} {{ get;{set} }}{value}"));
            return Ok(());
        }
        let own = name.to_lowercase();
        let title = if parameters.is_empty() { name } else { format!("this[{}]", parameters.join(", ")) };
        self.put(line, &format!("{access} {kind} {title} {{"));
        self.blocks.push(Block::Property(kind, own));
        self.scopes.push(Vec::new());
        Ok(())
    }

    /// `Get`, `Set(value As T)` and `End Property` inside a property.
    pub(super) fn accessor(&mut self, line: usize, kind: &str) -> Result<(), Wrong> {
        if self.at_end() {
            self.at += 1;
            return Ok(());
        }
        if self.take("end") {
            self.expect("property")?;
            self.blocks.pop();
            self.scopes.pop();
            self.put(line, "}");
            return Ok(());
        }
        if self.take("get") {
            self.blocks.push(Block::Accessor(true));
            self.scopes.push(Vec::new());
            self.put(line, &format!("get {{ {kind} __result = default({kind});"));
            return Ok(());
        }
        self.expect("set")?;
        let mut own = String::new();
        if self.take_op("(") && !self.take_op(")") {
            self.take("byval");
            let name = self.word()?;
            if self.take("as") {
                self.array_type()?;
            }
            self.expect_op(")")?;
            if !name.eq_ignore_ascii_case("value") {
                own = format!("{kind} {} = value;", self.spelled(&name));
            }
        }
        self.blocks.push(Block::Accessor(false));
        self.scopes.push(Vec::new());
        self.put(line, &format!("set {{ {own}"));
        Ok(())
    }

    /// `Enum E`, with its members to the end.
    pub(super) fn enumeration(&mut self, line: usize, access: &str) -> Result<(), Wrong> {
        self.at += 1;
        let name = self.word()?;
        self.put(line, &format!("{access} enum {name} {{"));
        loop {
            let line = self.line();
            if self.peek().is_none() {
                return Err(self.wrong("'End Enum' expected"));
            }
            if self.at_end() {
                self.at += 1;
            } else if self.take("end") {
                self.expect("enum")?;
                self.put(line, "}");
                return Ok(());
            } else {
                let member = escaped(&self.word()?);
                let value =
                    if self.take_op("=") { format!(" = {}", self.expression()?) } else { String::new() };
                self.put(line, &format!("{member}{value},"));
            }
        }
    }

    /// `MyBase.New(...)` or `Me.New(...)` where a constructor begins.
    pub(super) fn chain(&mut self) -> Result<String, Wrong> {
        let mut ahead = self.at;
        while self.tokens.get(ahead).is_some_and(|token| token.kind == Kind::End) {
            ahead += 1;
        }
        let word = |at: usize, word: &str| self.tokens.get(at).is_some_and(|token| token.is(word));
        let which = if word(ahead, "mybase") {
            "base"
        } else if word(ahead, "me") {
            "this"
        } else {
            return Ok(String::new());
        };
        if !self.tokens.get(ahead + 1).is_some_and(|token| token.is_op(".")) || !word(ahead + 2, "new") {
            return Ok(String::new());
        }
        self.at = ahead + 3;
        let arguments = if self.take_op("(") { self.list(")")?.join(", ") } else { String::new() };
        Ok(format!(" : {which}({arguments})"))
    }
}

/// Which halves a property has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Halves {
    Both,
    Get,
    Set,
}
