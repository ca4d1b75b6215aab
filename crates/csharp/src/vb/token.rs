//! Words, numbers and signs of VB; the end of a line ends a statement unless it goes on.

use super::Wrong;

/// What a token is.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Kind {
    Word(String),
    /// A number as C# writes it.
    Number(String),
    /// The characters of a text.
    Text(String),
    Char(char),
    Op(&'static str),
    /// A label at the beginning of a line, in small letters.
    Label(String),
    /// The end of a statement.
    End,
}

/// A token, and its line from 1.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Token {
    pub(super) kind: Kind,
    pub(super) line: usize,
}

impl Token {
    pub(super) fn is(&self, word: &str) -> bool {
        matches!(&self.kind, Kind::Word(own) if own.eq_ignore_ascii_case(word))
    }

    pub(super) fn is_op(&self, op: &str) -> bool {
        matches!(&self.kind, Kind::Op(own) if *own == op)
    }
}

const OPS: [&str; 31] = [
    "<<=", ">>=", ":=", "<>", "<=", ">=", "<<", ">>", "+=", "-=", "*=", "/=", "\\=", "^=", "&=", "+", "-",
    "*", "/", "\\", "^", "&", "=", "<", ">", "(", ")", "{", "}", ",", ".",
];

/// The tokens of a text.
pub(super) fn tokens(text: &str) -> Result<Vec<Token>, Wrong> {
    let mut all: Vec<Token> = Vec::new();
    for (number, line) in text.lines().enumerate() {
        let line_number = number + 1;
        let goes_on = of_line(line, line_number, &mut all)?;
        let ends_open = all.last().is_some_and(|token| match &token.kind {
            Kind::Op(op) => !matches!(*op, ")" | "}"),
            Kind::Word(_) => {
                ["and", "or", "andalso", "orelse", "xor", "mod", "not"].iter().any(|word| token.is(word))
            }
            _ => false,
        });
        if !goes_on && !ends_open && all.last().is_some_and(|token| token.kind != Kind::End) {
            all.push(Token { kind: Kind::End, line: line_number });
        }
    }
    if all.last().is_some_and(|token| token.kind != Kind::End) {
        let line = all.last().map_or(1, |token| token.line);
        all.push(Token { kind: Kind::End, line });
    }
    Ok(all)
}

/// The tokens of one line; whether the statement goes on in the next.
fn of_line(line: &str, number: usize, all: &mut Vec<Token>) -> Result<bool, Wrong> {
    let mut rest = line;
    if all.last().is_none_or(|token| token.kind == Kind::End)
        && let Some((name, behind)) = label(line)
    {
        all.push(Token { kind: Kind::Label(name), line: number });
        all.push(Token { kind: Kind::End, line: number });
        rest = behind;
    }
    loop {
        rest = rest.trim_start();
        let Some(first) = rest.chars().next() else { return Ok(false) };
        if first == '\'' || first == '#' || is_remark(rest) {
            return Ok(false);
        }
        if first == '_' && rest.trim() == "_" {
            return Ok(true);
        }
        let (kind, length) = next(rest, number)?;
        rest = rest.get(length..).unwrap_or_default();
        all.push(Token { kind, line: number });
    }
}

/// Words that may stand alone before a colon without being a label.
const NO_LABELS: [&str; 13] =
    ["else", "try", "finally", "do", "loop", "next", "wend", "return", "get", "set", "stop", "catch", "end"];

/// `name:` or `10:` at the beginning of a line, and what stands behind it.
fn label(line: &str) -> Option<(String, &str)> {
    let text = line.trim_start();
    let end = text.find(|c: char| !c.is_alphanumeric() && c != '_')?;
    let (name, behind) = text.split_at(end);
    let behind = behind.trim_start().strip_prefix(':').filter(|rest| !rest.starts_with('='))?;
    let is_label = !name.is_empty() && !NO_LABELS.iter().any(|word| word.eq_ignore_ascii_case(name));
    is_label.then(|| (name.to_lowercase(), behind))
}

fn is_remark(rest: &str) -> bool {
    rest.get(..3).is_some_and(|word| word.eq_ignore_ascii_case("rem"))
        && rest.chars().nth(3).is_none_or(char::is_whitespace)
}

/// The next token, and how many bytes it is long.
fn next(rest: &str, line: usize) -> Result<(Kind, usize), Wrong> {
    let first = rest.chars().next().unwrap_or(' ');
    if first == '"' || first == '\u{201c}' {
        return text(rest, line);
    }
    if rest.starts_with("$\"") {
        return Err((line, "interpolated text is not supported in VB".to_owned()));
    }
    if first == '[' {
        let end = rest.find(']').ok_or((line, "']' expected".to_owned()))?;
        return Ok((Kind::Word(rest[1..end].to_owned()), end + 1));
    }
    if first.is_alphabetic() || first == '_' {
        let length = rest.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(rest.len());
        return Ok((Kind::Word(rest[..length].to_owned()), length));
    }
    let digit_behind = rest.get(1..).is_some_and(|more| more.starts_with(|c: char| c.is_ascii_digit()));
    if first.is_ascii_digit() || first == '.' && digit_behind {
        return Ok(numeral(rest));
    }
    if let Some(hex) = rest.get(..2).filter(|start| start.eq_ignore_ascii_case("&h")) {
        let digits = rest[hex.len()..].find(|c: char| !c.is_ascii_hexdigit()).unwrap_or(rest.len() - 2);
        return Ok((Kind::Number(format!("0x{}", &rest[2..2 + digits])), 2 + digits));
    }
    if first == ':' && !rest.starts_with(":=") {
        return Ok((Kind::End, 1));
    }
    match OPS.iter().find(|op| rest.starts_with(**op)) {
        Some(op) => Ok((Kind::Op(op), op.len())),
        None if rest.starts_with('?') => Ok((Kind::Op("?"), 1)),
        None => Err((line, format!("unexpected character '{first}'"))),
    }
}

/// A text, in which two quotation marks are one; with `c` behind it a character.
fn text(rest: &str, line: usize) -> Result<(Kind, usize), Wrong> {
    let is_mark = |c: char| matches!(c, '"' | '\u{201c}' | '\u{201d}');
    let mut held = String::new();
    let mut chars = rest.char_indices().skip(1).peekable();
    while let Some((at, c)) = chars.next() {
        if !is_mark(c) {
            held.push(c);
            continue;
        }
        if chars.peek().is_some_and(|(_, next)| is_mark(*next)) {
            held.push('"');
            chars.next();
            continue;
        }
        let end = at + c.len_utf8();
        let mut one = held.chars();
        if let (Some(only), None, true) = (one.next(), one.next(), rest[end..].starts_with(['c', 'C'])) {
            return Ok((Kind::Char(only), end + 1));
        }
        return Ok((Kind::Text(held), end));
    }
    Err((line, "the text has no end".to_owned()))
}

/// A number with its suffix.
fn numeral(rest: &str) -> (Kind, usize) {
    let bytes = rest.as_bytes();
    let mut at = 0;
    let digits = |mut at: usize| {
        while bytes.get(at).is_some_and(|b| b.is_ascii_digit() || *b == b'_') {
            at += 1;
        }
        at
    };
    at = digits(at);
    let mut real = false;
    if bytes.get(at) == Some(&b'.') && bytes.get(at + 1).is_some_and(u8::is_ascii_digit) {
        at = digits(at + 1);
        real = true;
    }
    if matches!(bytes.get(at), Some(b'e' | b'E')) {
        let sign = usize::from(matches!(bytes.get(at + 1), Some(b'+' | b'-')));
        if bytes.get(at + 1 + sign).is_some_and(u8::is_ascii_digit) {
            at = digits(at + 1 + sign);
            real = true;
        }
    }
    let mut written = rest[..at].replace('_', "");
    if written.starts_with('.') {
        written.insert(0, '0');
    }
    let suffix = match bytes.get(at).map(u8::to_ascii_lowercase) {
        Some(b'r' | b'#') => Some("d"),
        Some(b'f' | b'!') => Some("f"),
        Some(b'd' | b'@') => Some("m"),
        Some(b'l' | b'&') if !real => Some("L"),
        Some(b'i' | b's' | b'%') if !real => Some(""),
        _ => None,
    };
    let behind = bytes.get(at + 1).is_some_and(|b| b.is_ascii_alphanumeric());
    match suffix.filter(|_| !behind) {
        Some(suffix) => (Kind::Number(written + suffix), at + 1),
        None => (Kind::Number(written), at),
    }
}
