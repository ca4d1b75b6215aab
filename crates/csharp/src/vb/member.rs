//! Members of a class in VB, and variables, as C#.

use super::property::Halves;
use super::token::Kind;
use super::{Block, Writer, Wrong};

impl Writer {
    /// Members of a class: fields, Sub, Function, classes.
    pub(super) fn declarations(&mut self) -> Result<(), Wrong> {
        while self.peek().is_some() {
            match self.blocks.last() {
                None | Some(Block::Class(_)) => self.member()?,
                Some(Block::Property(kind, _)) => {
                    let (line, kind) = (self.line(), kind.clone());
                    self.accessor(line, &kind)?;
                }
                Some(_) => self.statement()?,
            }
        }
        match self.blocks.last() {
            Some(open) => Err(self.wrong(&format!("{open:?} has no end"))),
            None => Ok(()),
        }
    }

    fn member(&mut self) -> Result<(), Wrong> {
        if self.at_end() {
            self.at += 1;
            return Ok(());
        }
        let line = self.line();
        if self.take("end") {
            if !self.take("structure") {
                self.expect("class")?;
            }
            self.blocks.pop();
            self.put(line, "}");
            return Ok(());
        }
        let mut halves = Halves::Both;
        let mut words = Vec::new();
        while let Some(Kind::Word(word)) = self.peek().map(|token| &token.kind) {
            let word = word.to_lowercase();
            words.push(match word.as_str() {
                "readonly"
                    if self.tokens.get(self.at + 1).is_some_and(|t| t.is("property") || t.is("default")) =>
                {
                    halves = Halves::Get;
                    ""
                }
                "public" => "public",
                "private" => "private",
                "protected" => "protected",
                "friend" => "internal",
                "shared" => "static",
                "readonly" => "readonly",
                "overrides" => "override",
                "overridable" => "virtual",
                "const" => "const",
                "dim" | "default" | "shadows" | "overloads" => "",
                "mustinherit" | "mustoverride" => "abstract",
                "notinheritable" => "sealed",
                "writeonly" => {
                    halves = Halves::Set;
                    ""
                }
                _ => break,
            });
            self.at += 1;
        }
        let is_open = |word: &&str| ["public", "private", "protected", "internal"].contains(word);
        let has_body =
            ["sub", "function", "property", "class", "structure", "enum"].iter().any(|w| self.is(w));
        if has_body && !words.iter().any(is_open) {
            words.insert(0, "public");
        }
        let access = words.join(" ");
        if self.take("class") {
            let name = self.word()?;
            let base = if self.is("inherits") || {
                self.at += usize::from(self.at_end());
                self.is("inherits")
            } {
                self.at += 1;
                format!(" : {}", self.type_name()?)
            } else {
                String::new()
            };
            self.blocks.push(Block::Class(name.clone()));
            self.put(line, &format!("{access} class {name}{base} {{"));
        } else if self.take("structure") {
            let name = self.word()?;
            self.blocks.push(Block::Class(name.clone()));
            self.put(line, &format!("{access} struct {name} {{"));
        } else if self.is("enum") {
            self.enumeration(line, &access)?;
        } else if self.is("property") {
            self.property(line, &access, halves)?;
        } else if self.is("sub") || self.is("function") {
            self.method(line, &access)?;
        } else {
            self.refuse_missing()?;
            self.fields(line, &access)?;
        }
        Ok(())
    }

    fn method(&mut self, line: usize, access: &str) -> Result<(), Wrong> {
        let is_function = self.is("function");
        self.at += 1;
        let name = self.word()?;
        let is_constructor = name.eq_ignore_ascii_case("new");
        let mut parameters = Vec::new();
        if self.take_op("(") {
            while !self.take_op(")") {
                parameters.push(self.parameter()?);
                if !self.is_op(")") {
                    self.expect_op(",")?;
                }
            }
        }
        let list = parameters.join(", ");
        if is_constructor {
            let Some(Block::Class(class)) = self.blocks.last().cloned() else {
                return Err((line, "a constructor stands in a class".to_owned()));
            };
            let chain = self.chain()?;
            self.put(line, &format!("{access} {class}({list}){chain} {{"));
            self.blocks.push(Block::Sub);
            self.scopes.push(Vec::new());
            self.begin_handling(line);
            return Ok(());
        }
        let result = match (is_function, self.take("as")) {
            (true, true) => self.array_type()?,
            (true, false) => "dynamic".to_owned(),
            _ => "void".to_owned(),
        };
        self.put(line, &format!("{access} {result} {name}({list}) {{"));
        if is_function {
            self.put(line, &format!("{result} __result = default({result});"));
            self.blocks.push(Block::Function(name.to_lowercase()));
        } else {
            self.blocks.push(Block::Sub);
        }
        self.scopes.push(Vec::new());
        self.begin_handling(line);
        Ok(())
    }

    pub(super) fn parameter(&mut self) -> Result<String, Wrong> {
        let (mut passing, mut rest) = ("", false);
        loop {
            if self.take("byref") {
                passing = "ref ";
            } else if self.take("paramarray") {
                rest = true;
            } else if self.take("optional") || self.take("byval") {
                continue;
            } else {
                break;
            }
        }
        let name = self.word()?;
        let brackets = self.brackets();
        let kind = if self.take("as") { self.array_type()? } else { "dynamic".into() };
        let default = if self.take_op("=") { format!(" = {}", self.expression()?) } else { String::new() };
        let rest = if rest { "params " } else { "" };
        Ok(format!("{passing}{rest}{kind}{brackets} {}{default}", self.spelled(&name)))
    }

    /// `()` behind a name: an array.
    fn brackets(&mut self) -> &'static str {
        for (length, brackets) in [(2, "[]"), (3, "[,]"), (4, "[,,]")] {
            let at = |i: usize, op: &str| self.tokens.get(self.at + i).is_some_and(|token| token.is_op(op));
            if at(0, "(") && (1..length - 1).all(|i| at(i, ",")) && at(length - 1, ")") {
                self.at += length;
                return brackets;
            }
        }
        ""
    }

    /// A type, with `()` behind it.
    pub(super) fn array_type(&mut self) -> Result<String, Wrong> {
        let name = self.type_name()?;
        Ok(format!("{name}{}", self.brackets()))
    }

    fn fields(&mut self, line: usize, access: &str) -> Result<(), Wrong> {
        for (text, _) in self.variables()? {
            self.put(line, &format!("{access} {text};"));
        }
        Ok(())
    }

    /// `a, b As T`, `x As New T(...)`, `y As T = v`, `z = v`, `a(5) As T`: each as C#, with its name.
    pub(super) fn variables(&mut self) -> Result<Vec<(String, String)>, Wrong> {
        let mut made = Vec::new();
        let mut waiting: Vec<(String, Option<Vec<String>>, &'static str)> = Vec::new();
        loop {
            let name = self.word()?;
            let name = self.spelled(&name);
            let brackets = self.brackets();
            let size = if brackets.is_empty() && self.take_op("(") { Some(self.list(")")?) } else { None };
            waiting.push((name, size, brackets));
            if self.take_op(",") {
                continue;
            }
            if self.take("as") {
                if self.take("new") {
                    let value = self.creation()?;
                    for (name, ..) in waiting.drain(..) {
                        made.push((format!("var {name} = {value}"), name));
                    }
                } else {
                    let kind = self.array_type()?;
                    let value = if self.take_op("=") { Some(self.expression()?) } else { None };
                    for (name, size, brackets) in waiting.drain(..) {
                        made.push((variable(&kind, &name, size, brackets, value.as_deref()), name));
                    }
                }
            } else if self.take_op("=") {
                let value = self.expression()?;
                for (name, ..) in waiting.drain(..) {
                    made.push((format!("var {name} = {value}"), name));
                }
            } else {
                for (name, ..) in waiting.drain(..) {
                    made.push((format!("dynamic {name} = null"), name));
                }
            }
            if !self.take_op(",") {
                return Ok(made);
            }
        }
    }
}

/// A declared variable: what has no value begins with the first of its type.
fn variable(
    kind: &str,
    name: &str,
    size: Option<Vec<String>>,
    brackets: &str,
    value: Option<&str>,
) -> String {
    if let Some(most) = size {
        let commas = ",".repeat(most.len().saturating_sub(1));
        let sizes: Vec<_> = most.iter().map(|most| format!("{most} + 1")).collect();
        return format!("{kind}[{commas}] {name} = new {kind}[{}]", sizes.join(", "));
    }
    let kind = format!("{kind}{brackets}");
    match value {
        None | Some("null") => format!("{kind} {name} = default({kind})"),
        Some(value) => format!("{kind} {name} = {}", narrowed(&kind, value)),
    }
}

/// A value for a variable of a plain type: VB narrows by itself.
fn narrowed(kind: &str, value: &str) -> String {
    match kind {
        "int" => format!("__VB.Int({value})"),
        "double" => format!("__VB.Dbl({value})"),
        "string" => format!("__VB.Str({value})"),
        _ => value.to_owned(),
    }
}
