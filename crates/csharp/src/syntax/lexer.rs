//! Source text to tokens (C# specification, lexical structure).

use std::collections::HashSet;

use super::number;
use super::token::{KEYWORDS, Name, PUNCTUATION, Tok, Token};
use crate::diagnostic::{Checked, Fault};
use crate::source::{MAX_SOURCE, Pos};

/// How deep interpolated texts may stand in one another.
const MAX_HOLES: u32 = 8;

/// Reads all tokens of a text whose first byte is at `base`. There is no token for the end.
pub(crate) fn tokens(text: &str, base: Pos) -> Checked<Vec<Token>> {
    if text.len() > MAX_SOURCE {
        return Err(Fault::new(base, 0, "The source is too long"));
    }
    Lexer { text, at: 0, base, depth: 0, symbols: HashSet::new(), skipping: Vec::new() }.all()
}

pub(super) struct Lexer<'a> {
    pub(super) text: &'a str,
    pub(super) at: usize,
    pub(super) base: Pos,
    pub(super) depth: u32,
    symbols: HashSet<&'a str>,
    /// One entry an open `#if`: whether this branch is read, and whether any branch has been.
    skipping: Vec<(bool, bool)>,
}

impl<'a> Lexer<'a> {
    /// Reads the tokens of a hole, from byte `from` to byte `to` of the text.
    pub(super) fn hole(&self, from: usize, to: usize) -> Checked<Vec<Token>> {
        if self.depth >= MAX_HOLES {
            return Err(self.fault(from, 8076, "Interpolated strings are nested too deeply"));
        }
        let mut inner = Lexer {
            text: &self.text[..to],
            at: from,
            base: self.base,
            depth: self.depth + 1,
            symbols: HashSet::new(),
            skipping: Vec::new(),
        };
        let mut tokens = Vec::new();
        while let Some(token) = inner.next()? {
            tokens.push(token);
        }
        Ok(tokens)
    }

    fn all(mut self) -> Checked<Vec<Token>> {
        let mut tokens = Vec::new();
        while let Some(token) = self.next()? {
            tokens.push(token);
        }
        if !self.skipping.is_empty() {
            return Err(self.fault(self.at, 1027, "#endif directive expected"));
        }
        Ok(tokens)
    }

    pub(super) fn fault(&self, at: usize, code: u16, message: &str) -> Fault {
        Fault::new(self.base + at as Pos, code, message)
    }

    pub(super) fn rest(&self) -> &'a str {
        self.text.get(self.at..).unwrap_or("")
    }

    pub(super) fn peek(&self) -> Option<char> {
        self.rest().chars().next()
    }

    fn next(&mut self) -> Checked<Option<Token>> {
        self.trivia()?;
        let start = self.at;
        let Some(c) = self.peek() else { return Ok(None) };
        let tok = match c {
            '"' => self.text_literal()?,
            '\'' => self.char_literal()?,
            '@' if self.rest().starts_with("@\"") => self.verbatim()?,
            '$' if self.is_interpolated() => self.interpolated()?,
            '@' => {
                self.at += 1;
                let name = self.word();
                if name.is_empty() {
                    return Err(self.fault(
                        start,
                        1646,
                        "Keyword, identifier, or string expected after verbatim specifier: @",
                    ));
                }
                Tok::Ident(name.into())
            }
            c if c.is_ascii_digit() => self.number()?,
            '.' if self.rest().as_bytes().get(1).is_some_and(u8::is_ascii_digit) => self.number()?,
            c if c == '_' || c.is_alphabetic() || c == '\\' => {
                let name = self.word();
                if name.is_empty() {
                    return Err(self.fault(start, 1056, "Unexpected character '\\'"));
                }
                match KEYWORDS.binary_search(&name.as_str()) {
                    Ok(i) => Tok::Kw(KEYWORDS[i]),
                    Err(_) => Tok::Ident(Name::from(name)),
                }
            }
            c => {
                let Some(p) = PUNCTUATION.iter().find(|p| self.rest().starts_with(**p)) else {
                    return Err(self.fault(start, 1056, &format!("Unexpected character '{c}'")));
                };
                // `a?.5:b` is a condition.
                let p = if *p == "?." && self.rest().as_bytes().get(2).is_some_and(u8::is_ascii_digit) {
                    "?"
                } else {
                    p
                };
                self.at += p.len();
                Tok::P(p)
            }
        };
        Ok(Some(Token { tok, pos: self.base + start as Pos, end: self.base + self.at as Pos }))
    }

    fn is_interpolated(&self) -> bool {
        let rest = self.rest();
        rest.starts_with("$\"") || rest.starts_with("$@\"")
    }

    fn word(&mut self) -> String {
        let rest = self.rest();
        let end = rest.find(|c: char| !(c == '_' || c.is_alphanumeric())).unwrap_or(rest.len());
        self.at += end;
        rest[..end].to_owned()
    }

    fn number(&mut self) -> Checked<Tok> {
        let (tok, length) =
            number::read(self.rest()).map_err(|(code, message)| self.fault(self.at, code, message))?;
        self.at += length;
        Ok(tok)
    }

    /// Skips white space, comments, directives and what conditions leave out.
    fn trivia(&mut self) -> Checked<()> {
        let mut line_start = self.at == 0;
        loop {
            let rest = self.rest();
            let Some(c) = rest.chars().next() else { return Ok(()) };
            if c.is_whitespace() || c == '\u{feff}' {
                line_start |= c == '\n';
                self.at += c.len_utf8();
            } else if rest.starts_with("//") {
                self.at += rest.find('\n').unwrap_or(rest.len());
            } else if rest.starts_with("/*") {
                let Some(end) = rest.find("*/") else {
                    return Err(self.fault(self.at, 1035, "End-of-file found, '*/' expected"));
                };
                self.at += end + 2;
            } else if c == '#' && (line_start || self.at_line_start()) {
                self.directive()?;
                line_start = false;
            } else if self.skipping.iter().any(|(reads, _)| !reads) {
                self.at += rest.find('\n').unwrap_or(rest.len());
            } else {
                return Ok(());
            }
        }
    }

    fn at_line_start(&self) -> bool {
        let before = &self.text[..self.at];
        before[before.rfind('\n').map_or(0, |i| i + 1)..].trim().is_empty()
    }

    fn directive(&mut self) -> Checked<()> {
        let rest = self.rest();
        let line = rest[1..].split('\n').next().unwrap_or("");
        let start = self.at;
        self.at += 1 + line.len();
        let line = line.split("//").next().unwrap_or("").trim();
        let (word, argument) = line.split_once(char::is_whitespace).unwrap_or((line, ""));
        let skipped = self.skipping.iter().any(|(reads, _)| !reads);
        match word {
            "if" => {
                let holds = !skipped && self.condition(argument);
                self.skipping.push((holds, holds || skipped));
            }
            "elif" | "else" => {
                let holds = word == "else" || self.condition(argument);
                let Some((reads, done)) = self.skipping.last_mut() else {
                    return Err(self.fault(start, 1028, "Unexpected preprocessor directive"));
                };
                *reads = holds && !*done;
                *done |= holds;
            }
            "endif" => {
                if self.skipping.pop().is_none() {
                    return Err(self.fault(start, 1028, "Unexpected preprocessor directive"));
                }
            }
            "define" if !skipped => {
                self.symbols.insert(argument.trim());
            }
            "undef" if !skipped => {
                self.symbols.remove(argument.trim());
            }
            "error" if !skipped => {
                return Err(self.fault(start, 1029, &format!("#error: '{}'", argument.trim())));
            }
            "define" | "undef" | "error" | "warning" | "region" | "endregion" | "pragma" | "line" | "r"
            | "load" | "nullable" => {}
            _ if skipped => {}
            _ => return Err(self.fault(start, 1024, "Preprocessor directive expected")),
        }
        Ok(())
    }

    /// `A && !B || C`, without brackets.
    fn condition(&self, text: &str) -> bool {
        text.split("||").any(|all| {
            all.split("&&").all(|one| {
                let one = one.trim().trim_matches(['(', ')']).trim();
                let (negated, name) = one.strip_prefix('!').map_or((false, one), |name| (true, name.trim()));
                (name == "true" || self.symbols.contains(name)) != negated
            })
        })
    }
}
