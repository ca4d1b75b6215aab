//! Tokens of an exchange structure.

use super::text;
use crate::{Error, Result};

/// A token.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Token {
    Keyword(String),
    Name(u64),
    Integer(i64),
    Real(f64),
    Text(String),
    Word(String),
    Binary,
    /// One of `( ) , ; = $ *`.
    Sign(u8),
    End,
}

/// The bytes that are still to be read.
pub(super) struct Lexer<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl<'a> Lexer<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Self { bytes, at: 0 }
    }

    fn peek(&self) -> Option<u8> {
        self.bytes.get(self.at).copied()
    }

    fn rest(&self) -> &'a [u8] {
        self.bytes.get(self.at..).unwrap_or(&[])
    }

    fn take_while(&mut self, mut wanted: impl FnMut(u8) -> bool) -> &'a [u8] {
        let rest = self.rest();
        let count = rest.iter().position(|b| !wanted(*b)).unwrap_or(rest.len());
        self.at += count;
        rest.get(..count).unwrap_or(&[])
    }

    /// An error where the lexer is.
    pub(super) fn error(&self, why: impl Into<String>) -> Error {
        let read = self.bytes.get(..self.at.min(self.bytes.len())).unwrap_or(&[]);
        let line = 1 + read.iter().filter(|b| **b == b'\n').count();
        Error::Syntax { line, why: why.into() }
    }

    fn skip_blanks(&mut self) -> Result<()> {
        loop {
            self.take_while(|b| b.is_ascii_whitespace() || b == 0);
            if self.rest().starts_with(b"/*") {
                let Some(end) = self.rest().windows(2).skip(2).position(|w| w == b"*/") else {
                    return Err(self.error("a comment does not end"));
                };
                self.at += end + 4;
            } else {
                return Ok(());
            }
        }
    }

    pub(super) fn next(&mut self) -> Result<Token> {
        self.skip_blanks()?;
        let Some(first) = self.peek() else { return Ok(Token::End) };
        match first {
            b'(' | b')' | b',' | b';' | b'=' | b'$' | b'*' => {
                self.at += 1;
                Ok(Token::Sign(first))
            }
            b'#' => {
                self.at += 1;
                let digits = self.take_while(|b| b.is_ascii_digit());
                let number = std::str::from_utf8(digits).ok().and_then(|s| s.parse().ok());
                number.map(Token::Name).ok_or_else(|| self.error("a # is followed by no number"))
            }
            b'\'' => self.text(),
            b'.' if self.rest().get(1).is_some_and(|b| b.is_ascii_alphabetic() || *b == b'_') => self.word(),
            b'"' => {
                self.at += 1;
                self.take_while(|b| b.is_ascii_hexdigit());
                if self.peek() != Some(b'"') {
                    return Err(self.error("a binary does not end"));
                }
                self.at += 1;
                Ok(Token::Binary)
            }
            b'+' | b'-' | b'.' | b'0'..=b'9' => self.number(),
            b'!' | b'_' => self.keyword(),
            _ if first.is_ascii_alphabetic() => self.keyword(),
            _ => Err(self.error(format!("byte {first:#04x} belongs to no token"))),
        }
    }

    fn keyword(&mut self) -> Result<Token> {
        let word = self.take_while(|b| b.is_ascii_alphanumeric() || matches!(b, b'_' | b'-' | b'!'));
        Ok(Token::Keyword(String::from_utf8_lossy(word).to_ascii_uppercase()))
    }

    fn word(&mut self) -> Result<Token> {
        self.at += 1;
        let word = self.take_while(|b| b.is_ascii_alphanumeric() || b == b'_');
        let word = String::from_utf8_lossy(word).to_ascii_uppercase();
        if self.peek() != Some(b'.') {
            return Err(self.error(format!(".{word} does not end with a point")));
        }
        self.at += 1;
        Ok(Token::Word(word))
    }

    fn number(&mut self) -> Result<Token> {
        let is_part = |b: u8| b.is_ascii_digit() || matches!(b, b'+' | b'-' | b'.' | b'e' | b'E');
        let bytes = self.take_while(is_part);
        let text = String::from_utf8_lossy(bytes);
        let is_real = text.contains(['.', 'e', 'E']);
        let parsed = if is_real {
            text.parse::<f64>().ok().filter(|x| x.is_finite()).map(Token::Real)
        } else {
            let whole = text.parse::<i64>().ok().map(Token::Integer);
            // An integer beyond 64 bits may still be meant for a length.
            whole.or_else(|| text.parse::<f64>().ok().filter(|x| x.is_finite()).map(Token::Real))
        };
        parsed.ok_or_else(|| self.error(format!("'{text}' is no number")))
    }

    fn text(&mut self) -> Result<Token> {
        let mut out = Vec::new();
        self.at += 1;
        loop {
            // Line ends inside a string are not part of it.
            out.extend(self.take_while(|b| b != b'\'').iter().filter(|b| !matches!(b, b'\r' | b'\n')));
            if self.peek().is_none() {
                return Err(self.error("a string does not end"));
            }
            self.at += 1;
            if self.peek() != Some(b'\'') {
                return Ok(Token::Text(text::decoded(&out)));
            }
            out.push(b'\'');
            self.at += 1;
        }
    }
}
