//! Texts and characters in source text.

use super::lexer::Lexer;
use super::token::{Piece, Tok};
use crate::diagnostic::{Checked, Fault};

impl Lexer<'_> {
    pub(super) fn char_literal(&mut self) -> Checked<Tok> {
        let start = self.at;
        self.at += 1;
        let mut units = Vec::new();
        match self.peek() {
            Some('\'') => return Err(self.fault(start, 1011, "Empty character literal")),
            Some('\\') => self.escape(&mut units)?,
            Some(c) if c != '\n' && c != '\r' => {
                self.at += c.len_utf8();
                push(&mut units, c);
            }
            _ => return Err(self.fault(start, 1010, "Newline in constant")),
        }
        if self.peek() != Some('\'') || units.len() != 1 {
            return Err(self.fault(start, 1012, "Too many characters in character literal"));
        }
        self.at += 1;
        Ok(Tok::Char(units[0]))
    }

    pub(super) fn text_literal(&mut self) -> Checked<Tok> {
        let start = self.at;
        self.at += 1;
        let mut units = Vec::new();
        loop {
            match self.peek() {
                Some('"') => break,
                Some('\\') => self.escape(&mut units)?,
                Some(c) if c != '\n' && c != '\r' => {
                    self.at += c.len_utf8();
                    push(&mut units, c);
                }
                _ => return Err(self.fault(start, 1010, "Newline in constant")),
            }
        }
        self.at += 1;
        Ok(Tok::Str(units.into()))
    }

    pub(super) fn verbatim(&mut self) -> Checked<Tok> {
        let start = self.at;
        self.at += 2;
        let mut units = Vec::new();
        loop {
            match self.peek() {
                Some('"') if self.rest().starts_with("\"\"") => {
                    units.push(u16::from(b'"'));
                    self.at += 2;
                }
                Some('"') => break,
                Some(c) => {
                    self.at += c.len_utf8();
                    push(&mut units, c);
                }
                None => return Err(self.fault(start, 1039, "Unterminated string literal")),
            }
        }
        self.at += 1;
        Ok(Tok::Str(units.into()))
    }

    pub(super) fn interpolated(&mut self) -> Checked<Tok> {
        let start = self.at;
        let verbatim = self.rest().starts_with("$@");
        self.at += if verbatim { 3 } else { 2 };
        let mut pieces = Vec::new();
        let mut units = Vec::new();
        loop {
            let rest = self.rest();
            match rest.chars().next() {
                Some('{') if rest.starts_with("{{") => {
                    units.push(u16::from(b'{'));
                    self.at += 2;
                }
                Some('}') if rest.starts_with("}}") => {
                    units.push(u16::from(b'}'));
                    self.at += 2;
                }
                Some('}') => {
                    return Err(self.fault(
                        self.at,
                        8086,
                        "A '}' character must be escaped (by doubling) in an interpolated string.",
                    ));
                }
                Some('{') => {
                    if !units.is_empty() {
                        pieces.push(Piece::Text(std::mem::take(&mut units)));
                    }
                    pieces.push(self.read_hole()?);
                }
                Some('"') if verbatim && rest.starts_with("\"\"") => {
                    units.push(u16::from(b'"'));
                    self.at += 2;
                }
                Some('"') => break,
                Some('\\') if !verbatim => self.escape(&mut units)?,
                Some(c) if verbatim || (c != '\n' && c != '\r') => {
                    self.at += c.len_utf8();
                    push(&mut units, c);
                }
                _ => return Err(self.fault(start, 1010, "Newline in constant")),
            }
        }
        self.at += 1;
        if !units.is_empty() {
            pieces.push(Piece::Text(units));
        }
        Ok(Tok::Interpolated(pieces))
    }

    /// From `{` to its `}`. A `:` outside brackets begins the format.
    fn read_hole(&mut self) -> Checked<Piece> {
        let open = self.at;
        let from = self.at + 1;
        let bytes = self.text.as_bytes();
        let mut at = from;
        let mut depth = 0_u32;
        let mut quote = None;
        let (mut colon, mut after_question) = (None, 0_u32);
        loop {
            let Some(&b) = bytes.get(at) else {
                return Err(self.fault(
                    open,
                    8076,
                    "Missing close delimiter '}' for interpolated expression started with '{'.",
                ));
            };
            if let Some(q) = quote {
                if b == b'\\' && q != 0 {
                    at += 1
                } else if b == q || (q == 0 && b == b'"') {
                    quote = None
                }
            } else if colon.is_some() {
                if b == b'}' {
                    break;
                }
                if b == b'"' {
                    return Err(self.fault(
                        open,
                        8076,
                        "Missing close delimiter '}' for interpolated expression started with '{'.",
                    ));
                }
            } else {
                match b {
                    b'"' => quote = Some(if at > from && matches!(bytes[at - 1], b'@') { 0 } else { b'"' }),
                    b'\'' => quote = Some(b'\''),
                    b'(' | b'[' | b'{' => depth += 1,
                    b'}' if depth == 0 => break,
                    b')' | b']' | b'}' => depth = depth.saturating_sub(1),
                    b'?' if depth == 0 => after_question += 1,
                    b':' if depth == 0 && bytes.get(at + 1) == Some(&b':') => at += 1,
                    b':' if depth == 0 && after_question == 0 => colon = Some(at),
                    _ => {}
                }
            }
            at += 1;
        }
        let tokens = self.hole(from, colon.unwrap_or(at))?;
        let format = colon.and_then(|colon| self.text.get(colon + 1..at)).map(Into::into);
        self.at = at + 1;
        Ok(Piece::Hole(tokens, format))
    }

    fn escape(&mut self, units: &mut Vec<u16>) -> Checked<()> {
        let start = self.at;
        self.at += 1;
        let Some(c) = self.peek() else { return Err(self.bad_escape(start)) };
        self.at += c.len_utf8();
        let unit = match c {
            '\'' | '"' | '\\' => c as u16,
            '0' => 0,
            'a' => 7,
            'b' => 8,
            'f' => 12,
            'n' => 10,
            'r' => 13,
            't' => 9,
            'v' => 11,
            'u' | 'U' | 'x' => {
                let (least, most) = match c {
                    'u' => (4, 4),
                    'U' => (8, 8),
                    _ => (1, 4),
                };
                let rest = self.rest();
                let count = rest.bytes().take(most).take_while(u8::is_ascii_hexdigit).count();
                let code = rest.get(..count).and_then(|hex| u32::from_str_radix(hex, 16).ok());
                self.at += count;
                match code {
                    Some(code) if count >= least => {
                        if code < 0x1_0000 {
                            units.push(code as u16);
                        } else if let Some(c) = char::from_u32(code) {
                            push(units, c);
                        } else {
                            return Err(self.bad_escape(start));
                        }
                        return Ok(());
                    }
                    _ => return Err(self.bad_escape(start)),
                }
            }
            _ => return Err(self.bad_escape(start)),
        };
        units.push(unit);
        Ok(())
    }

    fn bad_escape(&self, at: usize) -> Fault {
        self.fault(at, 1009, "Unrecognized escape sequence")
    }
}

fn push(units: &mut Vec<u16>, c: char) {
    units.extend_from_slice(c.encode_utf16(&mut [0; 2]));
}
