//! Tokens to syntax trees: recursive descent, with a bound on depth.

mod block;
mod declaration;
mod expression;
mod lookahead;
mod member;
mod operator;
mod pattern;
mod primary;
mod query;
mod statement;
mod types;

use super::ast::Namespace;
use super::token::{Name, Tok, Token};
use crate::diagnostic::{Checked, Fault};
use crate::source::Pos;

/// How deep a tree may be. Brackets and statements count [`NESTING`], a further operand counts one.
const MAX_DEPTH: u32 = 400;
const NESTING: u32 = 5;

/// Reads a whole file. `end` is the place of its end.
pub(crate) fn parse(tokens: Vec<Token>, end: Pos) -> Checked<Namespace> {
    let mut parser = Parser { tokens, at: 0, end, depth: 0, yields: false, unit: 0 };
    let mut file = Namespace::default();
    parser.namespace_body(&mut file, true)?;
    Ok(file)
}

struct Parser {
    tokens: Vec<Token>,
    at: usize,
    end: Pos,
    depth: u32,
    /// Whether `yield` was met in the function that is being read.
    yields: bool,
    /// A counter for names that the parser makes.
    unit: u32,
}

const EOF: Tok = Tok::Eof;

impl Parser {
    fn tok(&self) -> &Tok {
        self.ahead(0)
    }

    fn ahead(&self, n: usize) -> &Tok {
        self.tokens.get(self.at + n).map_or(&EOF, |token| &token.tok)
    }

    fn pos(&self) -> Pos {
        self.tokens.get(self.at).map_or(self.end, |token| token.pos)
    }

    /// Where the last token ended: csc puts "; expected" there.
    fn last_end(&self) -> Pos {
        self.at.checked_sub(1).and_then(|i| self.tokens.get(i)).map_or(self.end, |token| token.end)
    }

    fn advance(&mut self) {
        self.at += 1;
    }

    fn is(&self, p: &str) -> bool {
        matches!(self.tok(), Tok::P(q) if *q == p)
    }

    fn is_ahead(&self, n: usize, p: &str) -> bool {
        matches!(self.ahead(n), Tok::P(q) if *q == p)
    }

    fn is_kw(&self, word: &str) -> bool {
        matches!(self.tok(), Tok::Kw(w) if *w == word)
    }

    /// A contextual keyword.
    fn is_word(&self, word: &str) -> bool {
        matches!(self.tok(), Tok::Ident(name) if &**name == word)
    }

    fn eat(&mut self, p: &str) -> bool {
        let there = self.is(p);
        self.at += usize::from(there);
        there
    }

    fn eat_kw(&mut self, word: &str) -> bool {
        let there = self.is_kw(word);
        self.at += usize::from(there);
        there
    }

    fn eat_word(&mut self, word: &str) -> bool {
        let there = self.is_word(word);
        self.at += usize::from(there);
        there
    }

    fn expect(&mut self, p: &'static str) -> Checked<()> {
        if self.eat(p) {
            return Ok(());
        }
        Err(match p {
            ";" => Fault::new(self.last_end(), 1002, "; expected"),
            "}" => Fault::new(self.last_end(), 1513, "} expected"),
            "{" => Fault::new(self.last_end(), 1514, "{ expected"),
            ")" => Fault::new(self.last_end(), 1026, ") expected"),
            "]" => Fault::new(self.last_end(), 1003, "Syntax error, ']' expected"),
            _ => Fault::new(self.pos(), 1003, format!("Syntax error, '{p}' expected")),
        })
    }

    fn expect_kw(&mut self, word: &'static str) -> Checked<()> {
        if self.eat_kw(word) {
            return Ok(());
        }
        Err(Fault::new(self.pos(), 1003, format!("Syntax error, '{word}' expected")))
    }

    fn ident(&mut self) -> Checked<Name> {
        if let Tok::Ident(name) = self.tok() {
            let name = name.clone();
            self.advance();
            return Ok(name);
        }
        Err(match self.tok() {
            Tok::Kw(word) => {
                Fault::new(self.pos(), 1041, format!("Identifier expected; '{word}' is a keyword"))
            }
            _ => Fault::new(self.pos(), 1001, "Identifier expected"),
        })
    }

    /// Reads with a bound on depth; what was added to the depth inside is taken back.
    fn nested<T>(&mut self, read: impl FnOnce(&mut Self) -> Checked<T>) -> Checked<T> {
        let depth = self.depth;
        self.deeper(NESTING)?;
        let result = read(self);
        self.depth = depth;
        result
    }

    fn deeper(&mut self, by: u32) -> Checked<()> {
        self.depth += by;
        if self.depth > MAX_DEPTH {
            return Err(Fault::new(self.pos(), 8078, "An expression is too long or complex to compile"));
        }
        Ok(())
    }

    /// Tries to read; goes back when it does not work out.
    fn attempt<T>(&mut self, read: impl FnOnce(&mut Self) -> Checked<T>) -> Option<T> {
        let (at, depth, yields) = (self.at, self.depth, self.yields);
        let result = read(self).ok();
        if result.is_none() {
            (self.at, self.depth, self.yields) = (at, depth, yields);
        }
        result
    }

    fn unsupported<T>(&self, what: &str) -> Checked<T> {
        Err(Fault::new(self.pos(), 0, format!("{what} is not supported")))
    }

    /// A name that cannot be written in source.
    fn made_name(&mut self, what: &str) -> Name {
        self.unit += 1;
        format!("<{what}{}>", self.unit).into()
    }
}
