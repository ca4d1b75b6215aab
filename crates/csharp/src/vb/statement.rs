//! Statements of VB as C#.

use super::token::Kind;
use super::unstructured::label;
use super::{Block, Writer, Wrong};

/// What is not rewritten, by its first word.
const MISSING: [&str; 5] = ["raiseevent", "addhandler", "removehandler", "synclock", "static"];

/// What assigns, with how C# writes it.
const ASSIGNS: [(&str, &str); 8] =
    [("=", "="), ("^=", ""), ("+=", "+="), ("-=", "-="), ("*=", "*="), ("/=", "/="), ("\\=", ""), ("&=", "")];

impl Writer {
    pub(super) fn statements(&mut self) -> Result<(), Wrong> {
        while self.peek().is_some() {
            self.statement()?;
        }
        match self.blocks.last() {
            Some(open) => Err(self.wrong(&format!("{open:?} has no end"))),
            None => Ok(()),
        }
    }

    pub(super) fn refuse_missing(&self) -> Result<(), Wrong> {
        match MISSING.iter().find(|word| self.is(word)) {
            Some(word) => Err(self.wrong(&format!("'{word}' is not supported in VB"))),
            None => Ok(()),
        }
    }

    pub(super) fn statement(&mut self) -> Result<(), Wrong> {
        if self.at_end() {
            self.at += 1;
            return Ok(());
        }
        let line = self.line();
        self.refuse_missing()?;
        let first = match self.peek().map(|token| token.kind.clone()) {
            Some(Kind::Word(word)) => word.to_lowercase(),
            Some(Kind::Label(name)) => {
                self.at += 1;
                self.put(line, &format!("{}: ;", label(&name)));
                return Ok(());
            }
            _ => String::new(),
        };
        if self.handles() { self.guarded_statement(line, &first) } else { self.plain_statement(line, &first) }
    }

    /// A statement by its first word.
    pub(super) fn plain_statement(&mut self, line: usize, first: &str) -> Result<(), Wrong> {
        match first {
            "on" => self.on_error(line),
            "resume" => self.resume(line),
            "goto" => {
                self.at += 1;
                let to = self.label_name()?;
                self.put(line, &format!("goto {to};"));
                Ok(())
            }
            "dim" | "const" => {
                self.at += 1;
                for (text, name) in self.variables()? {
                    if let Some(scope) = self.scopes.last_mut() {
                        scope.push(name.clone());
                    }
                    if self.handles() {
                        self.guarded_variable(line, &text, &name);
                    } else {
                        self.put(line, &format!("{text};"));
                    }
                }
                Ok(())
            }
            "if" => self.begin_if(line),
            "elseif" => {
                self.at += 1;
                let test = self.test()?;
                self.reopen(line, &format!("}} else if ({test}) {{"));
                Ok(())
            }
            "else" => {
                self.at += 1;
                if self.take("if") {
                    let test = self.test()?;
                    self.reopen(line, &format!("}} else if ({test}) {{"));
                } else {
                    self.reopen(line, "} else {");
                }
                Ok(())
            }
            "for" => self.begin_for(line),
            "next" => {
                self.at += 1;
                while !self.at_end() {
                    self.at += 1;
                }
                self.close(line, &Block::For, "}")
            }
            "while" => {
                self.at += 1;
                let test = self.expression()?;
                self.open(line, Block::While, &format!("while ({test}) {{"));
                Ok(())
            }
            "wend" => {
                self.at += 1;
                self.close(line, &Block::While, "}")
            }
            "do" => {
                self.at += 1;
                let test = self.condition()?.unwrap_or_else(|| "true".to_owned());
                self.open(line, Block::Do, &format!("while ({test}) {{ {{"));
                Ok(())
            }
            "loop" => {
                self.at += 1;
                match self.condition()? {
                    Some(test) => self.close(line, &Block::Do, &format!("}} if (!({test})) break; }}")),
                    None => self.close(line, &Block::Do, "} }"),
                }
            }
            "select" => {
                self.at += 1;
                self.take("case");
                let value = self.expression()?;
                let name = self.fresh();
                self.open(line, Block::Select(name.clone(), false), &format!("{{ var {name} = {value};"));
                Ok(())
            }
            "case" => self.case(line),
            "try" => {
                self.at += 1;
                self.open(line, Block::Try, "try {");
                Ok(())
            }
            "catch" => {
                self.at += 1;
                let text = if self.at_end() {
                    "} catch {".to_owned()
                } else {
                    let name = self.word()?;
                    let kind = if self.take("as") { self.type_name()? } else { "Exception".into() };
                    format!("}} catch ({kind} {}) {{", self.spelled(&name))
                };
                self.reopen(line, &text);
                Ok(())
            }
            "finally" => {
                self.at += 1;
                self.reopen(line, "} finally {");
                Ok(())
            }
            "using" => {
                self.at += 1;
                let name = self.word()?;
                self.expect_op("=")?;
                let value = self.expression()?;
                let text = format!("using (var {} = {value}) {{", self.spelled(&name));
                self.open(line, Block::Using, &text);
                Ok(())
            }
            "with" => {
                self.at += 1;
                let value = self.expression()?;
                // A place is meant itself: a structure would be changed in a copy.
                if value.chars().all(|c| c.is_alphanumeric() || matches!(c, '_' | '.' | '@')) {
                    self.open(line, Block::With(value), "{");
                } else {
                    let name = self.fresh();
                    self.open(line, Block::With(name.clone()), &format!("{{ var {name} = {value};"));
                }
                Ok(())
            }
            "redim" => self.redim(line),
            "erase" => {
                self.at += 1;
                let name = self.postfix()?;
                self.put(line, &format!("{name} = null;"));
                Ok(())
            }
            "throw" => {
                self.at += 1;
                let value = if self.at_end() { String::new() } else { format!(" {}", self.expression()?) };
                self.put(line, &format!("throw{value};"));
                Ok(())
            }
            "return" => {
                self.at += 1;
                let value = if self.at_end() { String::new() } else { format!(" {}", self.expression()?) };
                self.put(line, &format!("return{value};"));
                Ok(())
            }
            "exit" => {
                self.at += 1;
                let what = self.word()?.to_lowercase();
                let jump = match what.as_str() {
                    "sub" => "return;".to_owned(),
                    "property" if !self.blocks.contains(&Block::Accessor(true)) => "return;".to_owned(),
                    "function" | "property" => "return __result;".to_owned(),
                    "for" | "while" | "do" | "select" => self.leave(line, &what)?,
                    _ => return Err((line, format!("'Exit {what}' is not supported in VB"))),
                };
                self.put(line, &jump);
                Ok(())
            }
            "continue" => {
                self.at += 1;
                let what = self.word()?.to_lowercase();
                let jump = self.go_on(line, &what)?;
                self.put(line, &jump);
                Ok(())
            }
            "end" => self.end(line),
            "call" => {
                self.at += 1;
                let call = self.postfix()?;
                self.put(line, &called(&call));
                Ok(())
            }
            _ => self.assignment(line),
        }
    }

    fn test(&mut self) -> Result<String, Wrong> {
        let test = self.expression()?;
        self.take("then");
        Ok(test)
    }

    /// `While c` or `Until c`.
    fn condition(&mut self) -> Result<Option<String>, Wrong> {
        if self.take("while") {
            return self.expression().map(Some);
        }
        if self.take("until") {
            return Ok(Some(format!("!({})", self.expression()?)));
        }
        Ok(None)
    }

    fn begin_if(&mut self, line: usize) -> Result<(), Wrong> {
        self.at += 1;
        let test = self.test()?;
        let test = if self.handles() { self.guarded_test(line, &test) } else { test };
        if self.at_end() {
            self.open(line, Block::If, &format!("if ({test}) {{"));
            return Ok(());
        }
        // All on one line.
        self.put(line, &format!("if ({test}) {{"));
        self.inline += 1;
        while !(self.peek().is_none_or(|token| token.kind == Kind::End)
            && self.tokens.get(self.at + 1).is_none_or(|token| token.line != line))
        {
            if self.take("else") {
                self.put(line, "} else {");
            } else {
                self.deeper(Self::statement)?;
            }
        }
        self.inline -= 1;
        self.put(line, "}");
        Ok(())
    }

    fn begin_for(&mut self, line: usize) -> Result<(), Wrong> {
        self.at += 1;
        let is_each = self.take("each");
        let name = self.word()?;
        let name = self.spelled(&name);
        let is_known = self.scopes.iter().flatten().any(|own| *own == name);
        let kind = if self.take("as") { Some(self.array_type()?) } else { None };
        if is_each {
            self.expect("in")?;
            let items = self.expression()?;
            let text = match (&kind, is_known) {
                (Some(kind), _) => format!("foreach ({kind} {name} in {items}) {{"),
                (None, false) => format!("foreach (var {name} in {items}) {{"),
                (None, true) => {
                    let item = self.fresh();
                    format!("foreach (var {item} in {items}) {{ {name} = {item};")
                }
            };
            self.open(line, Block::For, &text);
            return Ok(());
        }
        self.expect_op("=")?;
        let from = self.expression()?;
        self.expect("to")?;
        let to = self.expression()?;
        let step = if self.take("step") { Some(self.expression()?) } else { None };
        let last = self.fresh();
        let first = match (&kind, is_known) {
            (Some(kind), _) => format!("{kind} {name} = {from}"),
            (None, true) => format!("{name} = {from}"),
            (None, false) => format!("var {name} = {from}"),
        };
        let (test, turn) = match step.as_deref() {
            None => (format!("{name} <= {last}"), format!("{name}++")),
            Some(step) if step.starts_with("(-") => {
                (format!("{name} >= {last}"), format!("{name} += {step}"))
            }
            Some(step) => {
                (format!("({step} >= 0 ? {name} <= {last} : {name} >= {last})"), format!("{name} += {step}"))
            }
        };
        // The end is worked out once.
        self.open(line, Block::For, &format!("var {last} = {to}; for ({first}; {test}; {turn}) {{"));
        Ok(())
    }

    fn case(&mut self, line: usize) -> Result<(), Wrong> {
        self.at += 1;
        let Some(Block::Select(value, begun)) = self.blocks.last().cloned() else {
            return Err((line, "'Case' stands in no 'Select'".into()));
        };
        let before = if begun { "} else " } else { "" };
        if self.take("else") {
            self.reopen(line, &format!("{before}{{"));
        } else {
            let mut tests = Vec::new();
            loop {
                self.take("is");
                let operator = ["<=", ">=", "<>", "<", ">", "="].into_iter().find(|op| self.is_op(op));
                self.at += usize::from(operator.is_some());
                let first = self.expression()?;
                tests.push(match operator {
                    Some("<>") => format!("{value} != {first}"),
                    Some("=") => format!("{value} == {first}"),
                    Some(operator) => format!("{value} {operator} {first}"),
                    None if self.take("to") => {
                        format!("({value} >= {first} && {value} <= {})", self.expression()?)
                    }
                    None => format!("{value} == {first}"),
                });
                if !self.take_op(",") {
                    break;
                }
            }
            self.reopen(line, &format!("{before}if ({}) {{", tests.join(" || ")));
        }
        if let Some(Block::Select(_, begun)) = self.blocks.last_mut() {
            *begun = true;
        }
        Ok(())
    }

    fn end(&mut self, line: usize) -> Result<(), Wrong> {
        self.at += 1;
        let what = self.word()?.to_lowercase();
        match (what.as_str(), self.blocks.last().cloned()) {
            ("if", _) => self.close(line, &Block::If, "}"),
            ("while", _) => self.close(line, &Block::While, "}"),
            ("try", _) => self.close(line, &Block::Try, "}"),
            ("using", _) => self.close(line, &Block::Using, "}"),
            ("with", Some(Block::With(_))) => {
                self.blocks.pop();
                self.scopes.pop();
                self.put(line, "}");
                Ok(())
            }
            ("get", Some(Block::Accessor(true))) => {
                self.close(line, &Block::Accessor(true), "return __result; }")
            }
            ("function", Some(Block::Lambda)) => self.close(line, &Block::Lambda, "}"),
            ("set", _) => self.close(line, &Block::Accessor(false), "}"),
            ("select", Some(Block::Select(_, begun))) => {
                self.blocks.pop();
                self.scopes.pop();
                self.put(line, if begun { "} }" } else { "}" });
                if let Some(name) = self.handling.left(self.blocks.len()) {
                    self.put(line, &format!("{name}: ;"));
                }
                Ok(())
            }
            ("sub", _) => {
                if self.blocks.last() == Some(&Block::Sub) {
                    self.end_handling("return;");
                }
                self.close(line, &Block::Sub, "}")
            }
            ("function", Some(Block::Function(_))) => {
                self.end_handling("return __result;");
                self.blocks.pop();
                self.scopes.pop();
                self.put(line, "return __result; }");
                Ok(())
            }
            _ => Err((line, format!("'End {what}' ends nothing here"))),
        }
    }

    /// `ReDim [Preserve] a(n)`, `a(n, m)`: a new array, of the old elements where they are kept.
    fn redim(&mut self, line: usize) -> Result<(), Wrong> {
        self.at += 1;
        let keeps = self.take("preserve");
        loop {
            let name = self.word()?;
            let mut place = self.spelled(&name);
            while self.take_op(".") {
                place = format!("{place}.{}", self.word()?);
            }
            self.expect_op("(")?;
            let most = self.list(")")?;
            if self.take("as") {
                self.array_type()?;
            }
            if keeps && most.len() > 1 {
                return Err((line, "'ReDim Preserve' of several dimensions is not supported in VB".into()));
            }
            let word = if keeps { "Preserve" } else { "ReDim" };
            let sizes: Vec<_> = most.iter().map(|most| format!("__VB.Int({most})")).collect();
            self.put(line, &format!("__VB.{word}(ref {place}, {});", sizes.join(", ")));
            if !self.take_op(",") {
                return Ok(());
            }
        }
    }

    pub(super) fn open(&mut self, line: usize, block: Block, text: &str) {
        self.blocks.push(block);
        self.scopes.push(Vec::new());
        self.put(line, text);
    }

    /// Another part of the open block.
    fn reopen(&mut self, line: usize, text: &str) {
        if let Some(scope) = self.scopes.last_mut() {
            scope.clear();
        }
        self.put(line, text);
    }

    fn close(&mut self, line: usize, block: &Block, text: &str) -> Result<(), Wrong> {
        if self.blocks.last() != Some(block) {
            return Err((line, format!("this ends a {block:?} that is not open")));
        }
        if let Some(name) = self.handling.going_on(self.blocks.len() - 1) {
            self.put(line, &format!("{name}: ;"));
        }
        self.blocks.pop();
        self.scopes.pop();
        self.put(line, text);
        if let Some(name) = self.handling.left(self.blocks.len()) {
            self.put(line, &format!("{name}: ;"));
        }
        Ok(())
    }

    fn assignment(&mut self, line: usize) -> Result<(), Wrong> {
        let place = self.postfix()?;
        let function = self.blocks.iter().rev().find_map(|block| match block {
            Block::Function(name) | Block::Property(_, name) => Some(name.clone()),
            _ => None,
        });
        let place = match function {
            Some(name) if self.is_op("=") && place.to_lowercase() == name => "__result".to_owned(),
            _ => place,
        };
        let Some((vb, cs)) = ASSIGNS.into_iter().find(|(own, _)| self.is_op(own)) else {
            if !self.at_end() {
                return Err(self.wrong("end of statement expected"));
            }
            self.put(line, &called(&place));
            return Ok(());
        };
        self.at += 1;
        let value = self.expression()?;
        // `a(i) = v` is an element, whatever `a(i)` is elsewhere.
        let place = element(&place);
        self.put(
            line,
            &match vb {
                "\\=" => format!("{place} = __VB.Whole({place}, {value});"),
                "^=" => format!("{place} = Math.Pow({place}, {value});"),
                "&=" => format!("{place} = __VB.Join({place}, {value});"),
                _ => format!("{place} {cs} {value};"),
            },
        );
        Ok(())
    }
}

/// A statement that is a call, though it may have no parentheses.
fn called(call: &str) -> String {
    if call.ends_with(')') { format!("{call};") } else { format!("{call}();") }
}

/// The last parentheses of a place as brackets.
fn element(place: &str) -> String {
    if !place.ends_with(')') {
        return place.to_owned();
    }
    let mut depth = 0;
    for (at, c) in place.char_indices().rev() {
        match c {
            ')' => depth += 1,
            '(' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            let (before, inside) = place.split_at(at);
            return match inside.get(1..inside.len() - 1) {
                Some(inner) => format!("{before}[{inner}]"),
                None => place.to_owned(),
            };
        }
    }
    place.to_owned()
}
