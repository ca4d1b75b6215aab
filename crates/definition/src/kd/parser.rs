//! Tokens to statements. Every fault is kept, and reading goes on with the next line.

use super::ast::{
    Argument, Call, Entry, Flags, Given, Group, Module, Name, Output, Span, Statement, Target, Values, Wire,
};
use super::lexer::{Kind, Token, lex};
use super::problem::Fault;
use super::text;

/// How deep calls, lists and values may stand inside each other. Clusters count as well.
const DEEPEST: u32 = 60;
/// The largest text that is read, in bytes.
const LARGEST: usize = 256 << 20;

/// Words that mean something where a name could stand.
pub(super) const RESERVED: [&str; 7] = ["true", "false", "null", "none", "nan", "inf", "else"];

pub(super) struct Parser<'a> {
    tokens: Vec<Token<'a>>,
    pub(super) at: usize,
    pub(super) faults: Vec<Fault>,
    depth: u32,
}

/// Reading stops here; the fault is already kept.
pub(super) struct Stop;

pub(super) type Parsed<T> = Result<T, Stop>;

/// The statements of a text, or all that is wrong with it.
pub(super) fn parse(text: &str) -> Result<Module, Vec<Fault>> {
    if text.len() > LARGEST {
        return Err(vec![Fault::new(0, 1, format!("a text of {} bytes is more than is read", text.len()))]);
    }
    let (mut tokens, mut faults) = lex(text);
    tokens.retain(|token| token.kind != Kind::Comment);
    let mut parser = Parser { tokens, at: 0, faults: Vec::new(), depth: 0 };
    let module = parser.module(false);
    if faults.is_empty() && parser.faults.is_empty() {
        return Ok(module);
    }
    // What goes wrong on a line behind a broken token goes wrong because of it.
    let line = |at: usize| text.get(..at).and_then(|before| before.rfind('\n')).unwrap_or(0);
    let broken: std::collections::HashSet<usize> = faults.iter().take(100).map(|f| line(f.at)).collect();
    parser.faults.truncate(1000);
    parser.faults.retain(|fault| !broken.contains(&line(fault.at)));
    faults.append(&mut parser.faults);
    Err(faults)
}

impl<'a> Parser<'a> {
    pub(super) fn peek(&self) -> Token<'a> {
        self.peek_at(0)
    }

    pub(super) fn peek_at(&self, k: usize) -> Token<'a> {
        let end = Token { kind: Kind::End, text: "", at: 0, glued: false };
        self.tokens.get(self.at + k).or(self.tokens.last()).copied().unwrap_or(end)
    }

    pub(super) fn next(&mut self) -> Token<'a> {
        let token = self.peek();
        if token.kind != Kind::End {
            self.at += 1;
        }
        token
    }

    /// Takes the sign if it comes next.
    pub(super) fn eat(&mut self, sign: &str) -> bool {
        let found = self.peek().is(sign);
        self.at += usize::from(found);
        found
    }

    pub(super) fn span(token: Token<'_>) -> Span {
        Span { at: token.at, len: token.text.len() }
    }

    /// From there to the token just taken.
    pub(super) fn since(&self, start: Token<'_>) -> Span {
        let last = self.at.checked_sub(1).and_then(|k| self.tokens.get(k)).copied().unwrap_or(start);
        Span { at: start.at, len: (last.at + last.text.len()).saturating_sub(start.at) }
    }

    pub(super) fn fail<T>(&mut self, fault: Fault) -> Parsed<T> {
        self.faults.push(fault);
        Err(Stop)
    }

    /// The next token is not what should stand there.
    pub(super) fn expected<T>(&mut self, what: &str) -> Parsed<T> {
        let token = self.peek();
        let found = match token.kind {
            Kind::End => "the text ends".to_owned(),
            Kind::Newline => "the line ends".to_owned(),
            _ => format!("{} stands", text::quote(&token.text.chars().take(30).collect::<String>(), '"')),
        };
        self.fail(Fault::new(token.at, token.text.len().max(1), format!("{found} where {what} should be")))
    }

    pub(super) fn expect(&mut self, sign: &str, what: &str) -> Parsed<()> {
        if self.eat(sign) { Ok(()) } else { self.expected(&format!("{sign} {what}")) }
    }

    /// Goes one level deeper to read something, unless that is too deep.
    pub(super) fn deeper<T>(&mut self, read: impl FnOnce(&mut Self) -> Parsed<T>) -> Parsed<T> {
        if self.depth >= DEEPEST {
            let at = self.peek().at;
            return self.fail(Fault::new(
                at,
                1,
                format!("more than {DEEPEST} things stand inside each other"),
            ));
        }
        self.depth += 1;
        let result = read(self);
        self.depth -= 1;
        result
    }

    /// The statements up to the closing brace, or to the end of the text.
    fn module(&mut self, nested: bool) -> Module {
        let mut module = Module::default();
        loop {
            while self.peek().kind == Kind::Newline {
                self.at += 1;
            }
            let token = self.peek();
            if token.kind == Kind::End || nested && token.is("}") {
                return module;
            }
            let before = self.at;
            if self.line(&mut module).is_ok() {
                let end = self.peek();
                let ends = matches!(end.kind, Kind::Newline | Kind::End) || nested && end.is("}");
                if ends || self.expected::<()>("the end of the line").is_ok() {
                    continue;
                }
            }
            self.recover(before);
        }
    }

    /// Skips to the end of the line that the fault is in; blocks that begin in it go too.
    fn recover(&mut self, before: usize) {
        self.at = self.at.max(before);
        let mut open = 0usize;
        loop {
            let token = self.peek();
            match token.kind {
                Kind::End => return,
                Kind::Newline if open == 0 => return,
                Kind::Sign if token.text == "{" => open += 1,
                Kind::Sign if token.text == "}" => {
                    if open == 0 && self.at > before {
                        return;
                    }
                    open = open.saturating_sub(1);
                }
                _ => {}
            }
            self.at += 1;
        }
    }

    /// One statement, header line or block.
    fn line(&mut self, module: &mut Module) -> Parsed<()> {
        let (first, second) = (self.peek(), self.peek_at(1));
        if first.kind == Kind::Word {
            match (first.text, second.kind) {
                ("katydid", Kind::Number) => return self.version(),
                ("units", Kind::Word) if self.peek_at(2).kind != Kind::Sign => {
                    self.at += 1;
                    module.units = Some(self.name("a unit")?);
                    return Ok(());
                }
                ("title", Kind::Text | Kind::Raw) => {
                    self.at += 1;
                    module.title = Some(self.string("a title")?);
                    return Ok(());
                }
                ("about", Kind::Text | Kind::Raw) => {
                    self.at += 1;
                    module.about = Some(self.string("a description")?);
                    return Ok(());
                }
                ("layout" | "ids" | "details" | "data" | "file", Kind::Sign) if second.text == "{" => {
                    self.at += 1;
                    return self.block(first.text, module);
                }
                ("layout" | "ids" | "details" | "data" | "file", Kind::Path) => {
                    self.at += 2;
                    return Ok(());
                }
                _ => {}
            }
        }
        if let Some(group) = self.group()? {
            module.entries.push(Entry::Group(group));
        } else {
            let statement = self.statement()?;
            module.entries.push(Entry::Object(statement));
        }
        Ok(())
    }

    fn version(&mut self) -> Parsed<()> {
        self.at += 1;
        let token = self.next();
        if token.text == "1" {
            return Ok(());
        }
        let fault = Fault::new(token.at, token.text.len(), "only version 1 of the format is known");
        self.fail(fault)
    }

    fn block(&mut self, which: &str, module: &mut Module) -> Parsed<()> {
        match which {
            "layout" => self.lines(|p| {
                let place = p.place()?;
                module.layout.push(place);
                Ok(())
            }),
            "ids" => self.lines(|p| {
                let ids = p.ids()?;
                module.ids.push(ids);
                Ok(())
            }),
            "details" => self.lines(|p| {
                let label = p.label("an object's name")?;
                let edits = p.edits()?;
                module.details.push((label, edits));
                Ok(())
            }),
            "data" => self.lines(|p| {
                let data = p.data()?;
                module.data.push(data);
                Ok(())
            }),
            _ => {
                let mut edits = self.edits()?;
                module.file.append(&mut edits);
                Ok(())
            }
        }
    }

    /// The lines between braces.
    pub(super) fn lines(&mut self, mut line: impl FnMut(&mut Self) -> Parsed<()>) -> Parsed<()> {
        if matches!(self.peek(), Token { kind: Kind::Path, text: "{}", .. }) {
            self.at += 1;
            return Ok(());
        }
        let open = self.peek();
        self.expect("{", "to open the block")?;
        loop {
            while self.peek().kind == Kind::Newline {
                self.at += 1;
            }
            if self.eat("}") {
                return Ok(());
            }
            if self.peek().kind == Kind::End {
                return self.fail(Fault::new(open.at, 1, "this block is never closed: } is missing"));
            }
            let before = self.at;
            if line(self).is_ok() {
                let end = self.peek();
                if end.kind == Kind::Newline
                    || end.is("}")
                    || self.expected::<()>("the end of the line").is_ok()
                {
                    continue;
                }
            }
            self.recover(before);
        }
    }

    /// `group label(attributes): members`, or without the word; nothing when the line is something else.
    fn group(&mut self) -> Parsed<Option<Group>> {
        let (start, faults) = (self.at, self.faults.len());
        let word = self.peek().is_word("group") && !self.peek_at(1).is("=") && !self.peek_at(1).is("(");
        if word {
            self.at += 1;
        }
        let token = self.peek();
        let label = if token.kind == Kind::Text {
            let text = self.string("a name")?;
            Some(Name { text, quoted: true, suffix: self.suffix()?, span: Self::span(token) })
        } else if matches!(token.kind, Kind::Word | Kind::Name) {
            self.label("the group's name").ok()
        } else {
            None
        };
        let next = self.peek();
        let is_group = next.is(":") || word && next.is("(");
        let Some(label) = label.filter(|_| is_group) else {
            self.at = start;
            self.faults.truncate(faults);
            return Ok(None);
        };
        let attributes = if next.is("(") { self.arguments()? } else { Vec::new() };
        self.expect(":", "before the members of the group")?;
        let mut members = Vec::new();
        while !matches!(self.peek().kind, Kind::Newline | Kind::End) && !self.peek().is("}") {
            members.push(match self.peek().kind {
                Kind::Guid => Target::Guid(self.guid()?),
                _ => Target::Label(self.label("an object's name")?),
            });
            if !self.eat(",") {
                break;
            }
            // A long list goes on on the next line.
            while self.peek().kind == Kind::Newline {
                self.at += 1;
            }
        }
        Ok(Some(Group { label, attributes, members }))
    }

    fn statement(&mut self) -> Parsed<Statement> {
        let start = self.peek();
        let name = self.name("a name or a component")?;
        let suffix = self.suffix()?;
        let mut statement = Statement::default();
        if self.eat("=") {
            statement.label = Some(Name { suffix, ..name });
            let start = self.peek();
            let name = self.name("a component")?;
            let name = self.behind_panel(name)?;
            statement.call = self.call(name, start)?;
        } else if suffix.is_some() {
            return self.expected("= and a component");
        } else {
            let name = self.behind_panel(name)?;
            statement.call = self.call(name, start)?;
        }
        statement.flags = self.flags()?;
        if self.eat("->") {
            statement.outputs = Some(self.outputs()?);
        }
        if self.peek().is("{") || self.peek().kind == Kind::Path {
            statement.settings = self.edits()?;
        }
        if self.peek().is_word("inside") {
            self.at += 1;
            let open = self.peek();
            if open.kind == Kind::Path && open.text == "{}" {
                self.at += 1;
                statement.inside = Some(Box::default());
                return Ok(statement);
            }
            self.expect("{", "to open the cluster")?;
            let module = self.deeper(|p| {
                let module = p.module(true);
                if p.eat("}") {
                    return Ok(module);
                }
                p.fail(Fault::new(open.at, 1, "this cluster is never closed: } is missing"))
            })?;
            statement.inside = Some(Box::new(module));
        }
        Ok(statement)
    }

    /// `Grid/Square`: what stood before the slash was the component's panel.
    fn behind_panel(&mut self, panel: Name) -> Parsed<Name> {
        if !self.eat("/") {
            return Ok(panel);
        }
        let name = self.name("a component of this panel")?;
        let len = (name.span.at + name.span.len).saturating_sub(panel.span.at);
        let text = format!("{}/{}", panel.text, name.text);
        Ok(Name { text, span: Span { at: panel.span.at, len }, ..name })
    }

    fn flags(&mut self) -> Parsed<Flags> {
        let mut flags = Flags::default();
        while self.peek().kind == Kind::Word && !self.peek().is_word("inside") {
            let token = self.next();
            match token.text {
                "disabled" => flags.disabled = true,
                "hidden" => flags.hidden = true,
                "parameter" => flags.parameter = true,
                "variable" => flags.variable = true,
                _ => {
                    self.at -= 1;
                    return self.expected("disabled, hidden, parameter, variable or the end of the line");
                }
            }
        }
        Ok(flags)
    }

    fn outputs(&mut self) -> Parsed<Vec<Output>> {
        let mut outputs = Vec::new();
        // A component may have no outputs at all, and say so.
        while matches!(self.peek().kind, Kind::Word | Kind::Name | Kind::Number) {
            let name = self.port("an output")?;
            outputs.push(Output { name, modifiers: self.modifiers()? });
            if !self.eat(",") {
                break;
            }
            while self.peek().kind == Kind::Newline {
                self.at += 1;
            }
        }
        Ok(outputs)
    }

    /// What comes behind a component's name.
    pub(super) fn call(&mut self, name: Name, start: Token<'a>) -> Parsed<Call> {
        let guid = if self.peek().kind == Kind::Guid { Some(self.guid()?) } else { None };
        let exact = self.eat("!");
        if !self.peek().is("(") {
            return self.expected("( and the inputs of the component");
        }
        let arguments = self.deeper(Self::arguments)?;
        Ok(Call { name, guid, exact, arguments, span: self.since(start) })
    }

    fn arguments(&mut self) -> Parsed<Vec<Argument>> {
        let open = self.peek();
        self.expect("(", "before the inputs")?;
        let mut arguments = Vec::new();
        loop {
            if self.eat(")") {
                return Ok(arguments);
            }
            if self.peek().kind == Kind::End {
                return self.fail(Fault::new(open.at, 1, "this bracket is never closed: ) is missing"));
            }
            arguments.push(self.argument()?);
            if self.peek().kind != Kind::End && !self.eat(",") && !self.peek().is(")") {
                return self.expected(", or )");
            }
        }
    }

    fn argument(&mut self) -> Parsed<Argument> {
        let start = self.peek();
        let chosen = self.eat("*");
        if chosen || start.kind == Kind::Text && self.peek_at(1).is(":") {
            let name = self.string("the name of an item")?;
            self.expect(":", "between an item's name and its value")?;
            let value = self.value()?;
            let choice = Some((name, value, chosen));
            return Ok(Argument { choice, span: self.since(start), ..Argument::default() });
        }
        let before = self.at;
        let mut name = None;
        if matches!(start.kind, Kind::Word | Kind::Name) && !RESERVED.contains(&start.text) {
            let read = self.name("an input")?;
            if self.eat("=") {
                name = Some(read);
            } else {
                self.at = before;
            }
        }
        let given = self.given()?;
        Ok(Argument { name, choice: None, given, span: self.since(start) })
    }

    /// Wires, values and modifiers of an input.
    fn given(&mut self) -> Parsed<Given> {
        let mut given = Given::default();
        if self.peek().is_word("_") && !self.peek_at(1).is(".") {
            self.at += 1;
        } else if self.peek().is("[") {
            self.deeper(|p| p.list(&mut given))?;
        } else if self.starts_value() {
            given.values = self.values()?;
        } else {
            given.wires.push(self.wire()?);
        }
        if self.peek().is_word("else") {
            self.at += 1;
            if given.wires.is_empty() {
                return self.expected("a wire, not a value, before else");
            }
            let mut kept = Given::default();
            if self.peek().is("[") {
                self.deeper(|p| p.list(&mut kept))?;
            } else {
                kept.values = self.values()?;
            }
            if !kept.wires.is_empty() {
                return self.expected("values, not wires, after else");
            }
            given.values = kept.values;
        }
        given.modifiers = self.modifiers()?;
        Ok(given)
    }

    fn values(&mut self) -> Parsed<Values> {
        if self.peek().is_word("none") {
            self.at += 1;
            return Ok(Values::None);
        }
        Ok(Values::One(self.value()?))
    }

    pub(super) fn wire(&mut self) -> Parsed<Wire> {
        let start = self.peek();
        let target = if start.kind == Kind::Guid {
            Target::Guid(self.guid()?)
        } else {
            let name = self.name("an object, a component or a value")?;
            let name = self.behind_panel(name)?;
            let suffix = self.suffix()?;
            let next = self.peek();
            if suffix.is_none() && (next.is("(") || next.is("!") || next.kind == Kind::Guid) {
                Target::Call(Box::new(self.call(name, start)?))
            } else {
                Target::Label(Name { suffix, ..name })
            }
        };
        let port = if self.eat(".") { Some(self.port("an output")?) } else { None };
        Ok(Wire { target, port, span: self.since(start) })
    }
}
