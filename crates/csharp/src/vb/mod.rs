//! VB as script components use it, rewritten as C#, line by line, so that faults keep their lines.
//!
//! What the two languages do otherwise than by spelling is left to the binder, which knows types: arguments handed over by
//! reference without a word, `a(i)` for elements, `/` of whole numbers, names in any case.

mod expression;
mod library;
mod member;
mod property;
mod statement;
mod token;
mod unstructured;

use std::collections::HashMap;

use token::{Kind, Token};

/// Why a text cannot be rewritten: its line from 1, and what is wrong.
pub(crate) type Wrong = (usize, String);

/// The body of a component's `RunScript` as C#; `known` are the names that stand already: parameters and members.
pub(crate) fn body(text: &str, known: &[String]) -> Result<String, Wrong> {
    let mut writer = Writer::new(text, known)?;
    writer.begin_handling(1);
    writer.statements()?;
    writer.end_handling("return;");
    Ok(writer.finish())
}

/// Further members of the class as C#.
pub(crate) fn members(text: &str, known: &[String]) -> Result<String, Wrong> {
    let mut writer = Writer::new(text, known)?;
    writer.declarations()?;
    Ok(writer.finish())
}

/// `Imports` lines as C#.
pub(crate) fn imports(text: &str) -> String {
    let line = |line: &str| {
        let plain = line.trim();
        match plain.get(..8).filter(|word| word.eq_ignore_ascii_case("imports ")) {
            Some(_) => format!("using {};\n", plain.get(8..).unwrap_or_default().trim()),
            None => "\n".to_owned(),
        }
    };
    text.lines().map(line).collect()
}

/// The names that the members of a class declare.
pub(crate) fn declared(text: &str) -> Result<Vec<String>, Wrong> {
    Ok(names(&token::tokens(text)?))
}

/// All names that a text declares: behind `Dim`, `As`, `For`, `Sub` and the like.
fn names(tokens: &[Token]) -> Vec<String> {
    let mut found = Vec::new();
    for (i, token) in tokens.iter().enumerate() {
        let Kind::Word(name) = &token.kind else { continue };
        let before = i.checked_sub(1).and_then(|i| tokens.get(i));
        let next = tokens.get(i + 1);
        let after_word = before.is_some_and(|t| {
            [
                "dim",
                "sub",
                "function",
                "each",
                "for",
                "catch",
                "const",
                "byval",
                "byref",
                "class",
                "property",
                "structure",
                "enum",
            ]
            .iter()
            .any(|w| t.is(w))
        });
        if after_word || next.is_some_and(|t| t.is("as")) {
            found.push(name.clone());
        } else if next.is_some_and(|t| t.is_op(",")) && before.is_some_and(|t| t.is("dim") || t.is_op(",")) {
            // `Dim a, b As Double`
            let start = tokens[..i].iter().rposition(|t| t.kind == Kind::End).map_or(0, |at| at + 1);
            if tokens
                .get(start)
                .is_some_and(|t| ["dim", "private", "public", "const"].iter().any(|w| t.is(w)))
            {
                found.push(name.clone());
            }
        }
    }
    found
}

/// Writes C#.
struct Writer {
    tokens: Vec<Token>,
    at: usize,
    /// The spelling of declared names, by their small letters.
    names: HashMap<String, String>,
    /// Names that stand in the blocks around.
    scopes: Vec<Vec<String>>,
    /// What closes the open blocks.
    blocks: Vec<Block>,
    /// The lines so far.
    lines: Vec<String>,
    /// How many names of its own it has made.
    made: usize,
    /// How deep expressions stand in one another.
    depth: usize,
    /// How many `If` of one line are open: there `Else` ends a statement.
    inline: usize,
    /// What `On Error` and jumps need in the function that is being written.
    handling: unstructured::Handling,
}

/// An open block.
#[derive(Debug, Clone, PartialEq)]
enum Block {
    If,
    For,
    While,
    Do,
    /// With the variable that holds what is looked at, and whether a case has begun.
    Select(String, bool),
    Try,
    Using,
    Sub,
    /// With its name in small letters.
    Function(String),
    /// With its type, and its name in small letters.
    Property(String, String),
    /// A function of several lines within an expression.
    Lambda,
    /// `Get` (true) or `Set`.
    Accessor(bool),
    /// With what a leading dot stands for.
    With(String),
    /// A class or structure, with its name.
    Class(String),
}

impl Writer {
    fn new(text: &str, known: &[String]) -> Result<Self, Wrong> {
        let tokens = token::tokens(text)?;
        let mut all = HashMap::new();
        for name in known.iter().cloned().chain(names(&tokens)) {
            all.entry(name.to_lowercase()).or_insert(name);
        }
        Ok(Self {
            tokens,
            at: 0,
            names: all,
            scopes: vec![Vec::new()],
            blocks: Vec::new(),
            lines: Vec::new(),
            made: 0,
            depth: 0,
            inline: 0,
            handling: unstructured::Handling::default(),
        })
    }

    fn finish(self) -> String {
        self.lines.join("\n")
    }

    /// Writes text on the line of the next token.
    fn put(&mut self, line: usize, text: &str) {
        while self.lines.len() < line {
            self.lines.push(String::new());
        }
        // Text of several lines, as a lambda may be, takes as many here.
        for (i, part) in text.split('\n').enumerate() {
            if i > 0 {
                self.lines.push(String::new());
            }
            if let Some(last) = self.lines.last_mut() {
                last.push_str(part);
                last.push(' ');
            }
        }
    }

    fn peek(&self) -> Option<&Token> {
        self.tokens.get(self.at)
    }

    fn line(&self) -> usize {
        self.peek().or(self.tokens.last()).map_or(1, |token| token.line)
    }

    fn is(&self, word: &str) -> bool {
        self.peek().is_some_and(|token| token.is(word))
    }

    fn is_next(&self, word: &str) -> bool {
        self.tokens.get(self.at + 1).is_some_and(|token| token.is(word))
    }

    fn is_op(&self, op: &str) -> bool {
        self.peek().is_some_and(|token| token.is_op(op))
    }

    fn take(&mut self, word: &str) -> bool {
        let is = self.is(word);
        self.at += usize::from(is);
        is
    }

    fn take_op(&mut self, op: &str) -> bool {
        let is = self.is_op(op);
        self.at += usize::from(is);
        is
    }

    fn expect(&mut self, word: &str) -> Result<(), Wrong> {
        if self.take(word) { Ok(()) } else { Err(self.wrong(&format!("'{word}' expected"))) }
    }

    fn expect_op(&mut self, op: &str) -> Result<(), Wrong> {
        if self.take_op(op) { Ok(()) } else { Err(self.wrong(&format!("'{op}' expected"))) }
    }

    fn at_end(&self) -> bool {
        self.peek().is_none_or(|token| token.kind == Kind::End) || self.inline > 0 && self.is("else")
    }

    fn wrong(&self, what: &str) -> Wrong {
        (self.line(), what.to_owned())
    }

    fn word(&mut self) -> Result<String, Wrong> {
        match self.peek().map(|token| token.kind.clone()) {
            Some(Kind::Word(name)) => {
                self.at += 1;
                Ok(name)
            }
            _ => Err(self.wrong("identifier expected")),
        }
    }

    /// A name as it was declared.
    fn spelled(&self, name: &str) -> String {
        let own = self.names.get(&name.to_lowercase()).map_or(name, String::as_str);
        escaped(own)
    }

    /// A name of its own that no script has.
    fn fresh(&mut self) -> String {
        self.made += 1;
        format!("__vb{}", self.made)
    }
}

/// Words of C# that are no words of VB.
fn escaped(name: &str) -> String {
    let words = [
        "abstract",
        "base",
        "bool",
        "break",
        "checked",
        "decimal",
        "default",
        "delegate",
        "explicit",
        "extern",
        "fixed",
        "float",
        "foreach",
        "implicit",
        "in",
        "int",
        "internal",
        "lock",
        "null",
        "out",
        "override",
        "params",
        "readonly",
        "ref",
        "sealed",
        "sizeof",
        "stackalloc",
        "static",
        "struct",
        "switch",
        "this",
        "typeof",
        "uint",
        "ulong",
        "unchecked",
        "unsafe",
        "ushort",
        "virtual",
        "void",
        "volatile",
    ];
    if words.contains(&name) { format!("@{name}") } else { name.to_owned() }
}

#[cfg(test)]
mod tests;
