//! Names, values, modifiers, and the lines of the blocks at the end.

use base64::{Engine, engine::general_purpose::STANDARD as BASE64};
use uuid::Uuid;

use super::ast::{Change, Edit, Given, Ids, Lit, LitKind, Modifier, ModifierKind, Name, Place, Step, Values};
use super::lexer::{Kind, Token};
use super::parser::{Parsed, Parser, RESERVED};
use super::problem::{Fault, nearest};
use super::{raw_value, text};

/// Values that are written like calls. Components have capitals, or quotes.
pub(super) const MADE: [&str; 19] = [
    "point",
    "vector",
    "plane",
    "line",
    "circle",
    "arc",
    "rectangle",
    "box",
    "domain2",
    "complex",
    "face",
    "material",
    "loft",
    "mesher",
    "quads",
    "content",
    "geometry",
    "rgb",
    "int",
];
/// As [`MADE`], with a time in them.
pub(super) const TIME: &str = "time";

impl<'a> Parser<'a> {
    /// A name: words with a blank between them, or whatever stands between backquotes.
    pub(super) fn name(&mut self, what: &str) -> Parsed<Name> {
        let start = self.peek();
        if start.kind == Kind::Name {
            self.at += 1;
            let text = self.decode(start, text::unquote(start.text))?;
            return Ok(Name { text, quoted: true, suffix: None, span: Self::span(start) });
        }
        if start.kind != Kind::Word || RESERVED.contains(&start.text) {
            return self.expected(what);
        }
        let mut text = String::new();
        loop {
            let token = self.peek();
            let fits = match token.kind {
                Kind::Word => {
                    !(RESERVED.contains(&token.text) || token.text == "inside" && self.before_brace())
                }
                Kind::Number => !text.is_empty() && token.text.bytes().all(|b| b.is_ascii_digit()),
                _ => false,
            };
            // `V.2` is a word, a point and a number, and `x 1..2` is no name.
            if !fits || !text.is_empty() && token.glued {
                break;
            }
            if !text.is_empty() {
                text.push(' ');
            }
            text.push_str(token.text);
            self.at += 1;
        }
        Ok(Name { text, quoted: false, suffix: None, span: self.since(start) })
    }

    fn before_brace(&self) -> bool {
        let next = self.peek_at(1);
        next.is("{") || next.kind == Kind::Path
    }

    pub(super) fn suffix(&mut self) -> Parsed<Option<u32>> {
        let token = self.peek();
        if token.kind != Kind::Suffix {
            return Ok(None);
        }
        match token.text.trim_start_matches('\'').parse() {
            Ok(n) => {
                self.at += 1;
                Ok(Some(n))
            }
            Err(_) => self.expected("a number after '"),
        }
    }

    /// A name that may have a number behind it.
    pub(super) fn label(&mut self, what: &str) -> Parsed<Name> {
        let name = self.name(what)?;
        Ok(Name { suffix: self.suffix()?, ..name })
    }

    /// A port: by name, or by its number from 0.
    pub(super) fn port(&mut self, what: &str) -> Parsed<Name> {
        let token = self.peek();
        if token.kind == Kind::Number && token.text.bytes().all(|b| b.is_ascii_digit()) {
            self.at += 1;
            return Ok(Name {
                text: token.text.to_owned(),
                quoted: false,
                suffix: None,
                span: Self::span(token),
            });
        }
        self.name(what)
    }

    fn decode(&mut self, token: Token<'_>, decoded: Result<String, usize>) -> Parsed<String> {
        decoded.or_else(|k| {
            let message = if token.kind == Kind::Raw {
                "this line does not begin as the closing quotes do"
            } else {
                "this escape means nothing; there are \\n \\r \\t \\\\ \\\" \\` \\u{…}"
            };
            self.fail(Fault::new(token.at + k, 2, message))
        })
    }

    /// A text, on one line or several.
    pub(super) fn string(&mut self, what: &str) -> Parsed<String> {
        let token = self.peek();
        let decoded = match token.kind {
            Kind::Text => text::unquote(token.text),
            Kind::Raw => text::unraw(token.text),
            _ => return self.expected(what),
        };
        self.at += 1;
        self.decode(token, decoded)
    }

    pub(super) fn guid(&mut self) -> Parsed<Uuid> {
        let token = self.peek();
        match token.text.strip_prefix('@').map(Uuid::try_parse) {
            Some(Ok(id)) if token.kind == Kind::Guid => {
                self.at += 1;
                Ok(id)
            }
            _ => self.expected("@ and a GUID"),
        }
    }

    pub(super) fn modifiers(&mut self) -> Parsed<Vec<Modifier>> {
        let mut modifiers: Vec<Modifier> = Vec::new();
        loop {
            let token = self.peek();
            let kind = if token.kind == Kind::Formula {
                self.at += 1;
                let inside = token.text.strip_prefix("|{").and_then(|t| t.strip_suffix('}'));
                ModifierKind::Expression(inside.unwrap_or_default().to_owned())
            } else if self.eat("|") {
                let word = self.next();
                match ModifierKind::WORDS.iter().find(|(name, _)| word.is_word(name)) {
                    Some((_, kind)) => kind.clone(),
                    None if word.is_word("expression") => ModifierKind::Expression(self.string("its text")?),
                    None => {
                        let names = ModifierKind::WORDS.iter().map(|(name, _)| *name);
                        let hint = match nearest(word.text, names.clone()) {
                            Some(name) => format!("did you mean {name}?"),
                            None => names.collect::<Vec<_>>().join(", "),
                        };
                        let fault =
                            Fault::new(word.at, word.text.len(), "there is no such modifier").hint(hint);
                        return self.fail(fault);
                    }
                }
            } else {
                return Ok(modifiers);
            };
            let clash = modifiers.iter().any(|other| other.kind.item().0 == kind.item().0);
            let span = Self::span(token);
            if clash {
                return self.fail(Fault::new(span.at, span.len, "this modifier goes against one before it"));
            }
            modifiers.push(Modifier { kind, span });
        }
    }

    /// Whether a value comes next, and not a wire.
    pub(super) fn starts_value(&self) -> bool {
        let token = self.peek();
        match token.kind {
            Kind::Number | Kind::Text | Kind::Raw | Kind::Path | Kind::Data => true,
            Kind::Sign => token.text == "(",
            Kind::Word if RESERVED.contains(&token.text) => token.text != "else",
            Kind::Word => {
                (MADE.contains(&token.text) || token.text == TIME || token.text == "guid")
                    && self.peek_at(1).is("(")
            }
            _ => false,
        }
    }

    /// `[…]`: wires, values, or branches of values.
    pub(super) fn list(&mut self, given: &mut Given) -> Parsed<()> {
        let open = self.peek();
        self.expect("[", "before a list")?;
        if self.peek().kind == Kind::Path && self.peek_at(1).is(":") {
            given.values = Values::Tree(self.branches()?);
            return Ok(());
        }
        let mut items = Vec::new();
        while !self.eat("]") {
            if self.peek().kind == Kind::End {
                return self.fail(Fault::new(open.at, 1, "this list is never closed: ] is missing"));
            }
            let token = self.peek();
            let value = self.starts_value();
            if value && !given.wires.is_empty() || !value && !items.is_empty() {
                let message = "wires and values cannot stand in one list: write [A, B] else [1, 2]";
                return self.fail(Fault::new(token.at, token.text.len(), message));
            }
            if value {
                items.push(self.value()?);
            } else {
                given.wires.push(self.wire()?);
            }
            if self.peek().kind != Kind::End && !self.eat(",") && !self.peek().is("]") {
                return self.expected(", or ]");
            }
        }
        if given.wires.is_empty() {
            let branches = if items.is_empty() { Vec::new() } else { vec![(vec![0], items)] };
            given.values = Values::Tree(branches);
        }
        Ok(())
    }

    /// `{0;0}: 1, 2; {0;1}: 3]`.
    fn branches(&mut self) -> Parsed<Vec<(Vec<i32>, Vec<Lit>)>> {
        let mut branches = Vec::new();
        loop {
            let token = self.peek();
            let path = crate::document::parse_path(token.text).filter(|_| token.kind == Kind::Path);
            let Some(path) = path else { return self.expected("a path such as {0;1}") };
            self.at += 1;
            self.expect(":", "after the path of a branch")?;
            let mut items = Vec::new();
            while !self.peek().is(";") && !self.peek().is("]") {
                items.push(self.value()?);
                if !self.eat(",") && !self.peek().is(";") && !self.peek().is("]") {
                    return self.expected(", or ; or ]");
                }
            }
            branches.push((path, items));
            if self.eat("]") {
                return Ok(branches);
            }
            self.expect(";", "between two branches")?;
            if self.eat("]") {
                return Ok(branches);
            }
        }
    }

    fn number(&mut self, what: &str) -> Parsed<(f64, Option<u32>)> {
        let token = self.peek();
        let special = matches!(token.text, "nan" | "inf") && token.kind == Kind::Word;
        if token.kind != Kind::Number && !special {
            return self.expected(what);
        }
        self.at += 1;
        // A NaN has no sign that any file could keep.
        let x: f64 = if token.text == "-nan" { f64::NAN } else { token.text.parse().unwrap_or(f64::NAN) };
        if x.is_infinite() && !token.text.ends_with("inf") {
            return self.fail(Fault::new(token.at, token.text.len(), "this number is too large"));
        }
        let digits = token.text.split_once('.').map(|(_, digits)| u32::try_from(digits.len()).unwrap_or(99));
        let exponent = token.text.contains(['e', 'E', 'n']);
        Ok((x, if exponent { Some(0) } else { digits }))
    }

    /// A value.
    pub(super) fn value(&mut self) -> Parsed<Lit> {
        let start = self.peek();
        let kind = match start.kind {
            Kind::Text | Kind::Raw => LitKind::Text(self.string("a text")?),
            Kind::Guid => LitKind::Guid(self.guid()?),
            Kind::Data => LitKind::Data(self.data_number()?),
            Kind::Path => {
                self.at += 1;
                LitKind::Path(crate::document::parse_path(start.text).unwrap_or_default())
            }
            Kind::Word if matches!(start.text, "true" | "false") => {
                self.at += 1;
                LitKind::Boolean(start.text == "true")
            }
            Kind::Word if start.text == "null" => {
                self.at += 1;
                LitKind::Null
            }
            Kind::Sign if start.text == "(" => self.deeper(Self::coordinates)?,
            Kind::Number => self.number_or_range()?,
            Kind::Word if matches!(start.text, "nan" | "inf") => self.number_or_range()?,
            Kind::Word if self.starts_value() => self.deeper(Self::made)?,
            _ => return self.expected("a value"),
        };
        Ok(Lit { kind, span: self.since(start) })
    }

    fn number_or_range(&mut self) -> Parsed<LitKind> {
        let (x, digits) = self.number("a number")?;
        if !self.eat("..") {
            return Ok(LitKind::Number(x, digits));
        }
        let (y, more) = self.number("the end of the range")?;
        Ok(LitKind::Range(x, y, digits.max(more).unwrap_or(0)))
    }

    fn coordinates(&mut self) -> Parsed<LitKind> {
        self.expect("(", "before coordinates")?;
        let mut xyz = [0.0; 3];
        let mut n = 0;
        for x in &mut xyz {
            *x = self.number("a coordinate")?.0;
            n += 1;
            if !self.eat(",") || self.peek().is(")") {
                break;
            }
        }
        if n < 2 {
            return self.expected("a second coordinate");
        }
        self.expect(")", "after two or three coordinates")?;
        Ok(LitKind::Point(xyz))
    }

    /// `plane((0, 0, 0), (1, 0, 0), (0, 1, 0))` and the like.
    fn made(&mut self) -> Parsed<LitKind> {
        let what = self.next();
        self.expect("(", "before the parts of the value")?;
        let mut parts = Vec::new();
        while !self.eat(")") {
            let word = self.peek();
            let name = if word.kind == Kind::Word && self.peek_at(1).is("=") {
                self.at += 2;
                Some(word.text.to_owned())
            } else {
                None
            };
            parts.push((name, self.value()?));
            if !self.eat(",") && !self.peek().is(")") {
                return self.expected(", or )");
            }
        }
        Ok(LitKind::Made(what.text.to_owned(), parts))
    }

    fn single(&mut self) -> Parsed<f32> {
        let (x, _) = self.number("a number of pixels")?;
        Ok(x as f32)
    }

    pub(super) fn place(&mut self) -> Parsed<Place> {
        let label = self.label("an object's name")?;
        self.expect(":", "after the name")?;
        let mut place = Place { label, pivot: None, bounds: None };
        if self.peek().kind == Kind::Number || self.peek().is_word("nan") {
            place.pivot = Some([self.single()?, self.single()?]);
        }
        if self.eat("[") {
            place.bounds = Some([self.single()?, self.single()?, self.single()?, self.single()?]);
            self.expect("]", "after x, y, width and height")?;
        }
        Ok(place)
    }

    pub(super) fn ids(&mut self) -> Parsed<Ids> {
        let label = self.label("an object's name")?;
        self.expect(":", "after the name")?;
        let own = if self.peek().kind == Kind::Guid { Some(self.guid()?) } else { None };
        let inputs = self.id_list()?;
        let outputs = if self.eat("->") { self.id_list()? } else { Vec::new() };
        Ok(Ids { label, own, inputs, outputs })
    }

    fn id_list(&mut self) -> Parsed<Vec<Option<Uuid>>> {
        let mut ids = Vec::new();
        if !self.eat("[") {
            return Ok(ids);
        }
        while !self.eat("]") {
            if self.peek().is_word("_") {
                self.at += 1;
                ids.push(None);
            } else {
                ids.push(Some(self.guid()?));
            }
            if !self.eat(",") && !self.peek().is("]") {
                return self.expected(", or ]");
            }
        }
        Ok(ids)
    }

    pub(super) fn data_number(&mut self) -> Parsed<u32> {
        let token = self.peek();
        match token.text.strip_prefix('$').map(str::parse) {
            Some(Ok(n)) if token.kind == Kind::Data => {
                self.at += 1;
                Ok(n)
            }
            _ => self.expected("$ and the number of a piece of data"),
        }
    }

    pub(super) fn data(&mut self) -> Parsed<(u32, Vec<u8>)> {
        let n = self.data_number()?;
        self.expect("=", "after the number")?;
        let token = self.peek();
        let mut text = self.string("a text in base64")?;
        text.retain(|c| !c.is_whitespace());
        match BASE64.decode(text) {
            Ok(bytes) => Ok((n, bytes)),
            Err(error) => self.fail(Fault::new(token.at, 3, format!("this is not base64: {error}"))),
        }
    }

    /// The changes between braces.
    pub(super) fn edits(&mut self) -> Parsed<Vec<Edit>> {
        let mut edits = Vec::new();
        self.lines(|p| {
            let edit = p.edit()?;
            edits.push(edit);
            Ok(())
        })?;
        Ok(edits)
    }

    fn edit(&mut self) -> Parsed<Edit> {
        let start = self.peek();
        let remove = self.eat("-");
        let add = !remove && self.eat("+");
        let top = self.eat("/");
        let mut path = Vec::new();
        let chunk = loop {
            path.push(self.step()?);
            let slash = self.eat("/");
            if !slash || !matches!(self.peek().kind, Kind::Word | Kind::Name) {
                break slash;
            }
        };
        let change = match (remove, add, chunk) {
            (true, _, true) => Change::RemoveChunk,
            (true, ..) => Change::Remove,
            (_, true, _) => Change::Add,
            _ => {
                self.expect("=", "and a value")?;
                Change::Set(raw_value::parse(self)?)
            }
        };
        Ok(Edit { top, path, change, span: self.since(start) })
    }

    fn step(&mut self) -> Parsed<Step> {
        let token = self.peek();
        let name = match token.kind {
            Kind::Word => {
                self.at += 1;
                token.text.to_owned()
            }
            Kind::Name => self.name("a name")?.text,
            _ => return self.expected("the name of an item or chunk"),
        };
        let index = if self.eat("[") {
            let n = self.integer("an index")?;
            self.expect("]", "after the index")?;
            Some(n)
        } else {
            None
        };
        let nth = if self.eat("~") { self.integer("a number")? } else { 0 };
        Ok(Step { name, index, nth })
    }

    /// A whole number of whatever type is wanted.
    pub(super) fn integer<T: std::str::FromStr>(&mut self, what: &str) -> Parsed<T> {
        let token = self.peek();
        match token.text.parse() {
            Ok(n) if token.kind == Kind::Number => {
                self.at += 1;
                Ok(n)
            }
            _ => self.expected(what),
        }
    }

    pub(super) fn double(&mut self) -> Parsed<f64> {
        Ok(self.number("a number")?.0)
    }
}
