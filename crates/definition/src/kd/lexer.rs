//! Text to tokens. Every byte belongs to a token or to the blanks between two.

use super::problem::Fault;

/// What a token is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    /// Letters, digits and `_`.
    Word,
    /// A name in backquotes.
    Name,
    /// A number, with its sign.
    Number,
    /// A text in quotes.
    Text,
    /// A text over several lines between `"""`.
    Raw,
    /// `{0;1}`.
    Path,
    /// `@` and a GUID.
    Guid,
    /// `|{x*2}`.
    Formula,
    /// `$3`.
    Data,
    /// `'2`.
    Suffix,
    /// `# …` up to the end of the line.
    Comment,
    /// One or more ends of line; more than one stands for a blank line.
    Newline,
    /// A sign of one or two characters.
    Sign,
    /// The end of the text.
    End,
}

/// A token with its text.
#[derive(Debug, Clone, Copy)]
pub(super) struct Token<'a> {
    pub(super) kind: Kind,
    pub(super) text: &'a str,
    /// Where it begins, in bytes.
    pub(super) at: usize,
    /// Whether nothing stands between it and the token before.
    pub(super) glued: bool,
}

impl Token<'_> {
    pub(super) fn is(&self, sign: &str) -> bool {
        self.kind == Kind::Sign && self.text == sign
    }

    pub(super) fn is_word(&self, word: &str) -> bool {
        self.kind == Kind::Word && self.text == word
    }
}

/// Longest first.
const SIGNS: [&str; 20] =
    ["->", "..", "(", ")", "[", "]", "{", "}", ",", "=", ":", ";", ".", "|", "*", "/", "~", "!", "-", "+"];

struct Lexer<'a> {
    text: &'a str,
    at: usize,
    tokens: Vec<Token<'a>>,
    /// The brackets that are open; inside round and square ones the ends of lines mean nothing.
    open: Vec<char>,
    faults: Vec<Fault>,
}

fn is_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// The tokens of a text, with what is no token.
pub(super) fn lex(text: &str) -> (Vec<Token<'_>>, Vec<Fault>) {
    let start = if text.starts_with('\u{feff}') { 3 } else { 0 };
    let mut lexer = Lexer { text, at: start, tokens: Vec::new(), open: Vec::new(), faults: Vec::new() };
    while lexer.token() {}
    let end = text.len();
    lexer.tokens.push(Token { kind: Kind::End, text: "", at: end, glued: false });
    (lexer.tokens, lexer.faults)
}

impl<'a> Lexer<'a> {
    fn rest(&self) -> &'a str {
        self.text.get(self.at..).unwrap_or_default()
    }

    /// Takes the next `len` bytes as a token.
    fn push(&mut self, kind: Kind, len: usize) {
        let end = self.at.saturating_add(len).min(self.text.len());
        let glued = self.tokens.last().is_some_and(|last| last.at + last.text.len() == self.at);
        let text = self.text.get(self.at..end).unwrap_or_default();
        self.tokens.push(Token { kind, text, at: self.at, glued });
        self.at = end;
    }

    /// Takes the next token; `false` at the end.
    fn token(&mut self) -> bool {
        let rest = self.rest();
        let Some(c) = rest.chars().next() else { return false };
        match c {
            '\n' => self.newlines(),
            _ if c.is_whitespace() => self.at += c.len_utf8(),
            '#' => self.push(Kind::Comment, rest.find('\n').unwrap_or(rest.len())),
            '"' if rest.starts_with("\"\"\"") => self.raw(),
            '"' => self.quoted(Kind::Text, '"'),
            '`' => self.quoted(Kind::Name, '`'),
            '@' => self.push(Kind::Guid, 1 + run(rest, 1, |c| c.is_ascii_hexdigit() || c == '-')),
            '$' => self.push(Kind::Data, 1 + run(rest, 1, |c| c.is_ascii_digit())),
            '\'' => self.push(Kind::Suffix, 1 + run(rest, 1, |c| c.is_ascii_digit())),
            '|' if rest.starts_with("|{") => self.formula(),
            '{' => match path(rest) {
                Some(len) => self.push(Kind::Path, len),
                None => self.sign(),
            },
            _ => match number(rest) {
                // `2D` and `1st` are words.
                Some(len) if !rest.get(len..).is_some_and(|r| r.starts_with(is_word)) => {
                    self.push(Kind::Number, len);
                }
                _ if is_word(c) => self.push(Kind::Word, run(rest, 0, is_word)),
                _ => self.sign(),
            },
        }
        true
    }

    fn newlines(&mut self) {
        let rest = self.rest();
        let len = run(rest, 0, char::is_whitespace);
        // The blanks before the next line's first token do not belong to it.
        let len = rest.get(..len).and_then(|blank| blank.rfind('\n')).map_or(len, |k| k + 1);
        if matches!(self.open.last(), Some('(' | '[')) {
            self.at += len;
        } else {
            self.push(Kind::Newline, len);
        }
    }

    fn sign(&mut self) {
        let rest = self.rest();
        let Some(sign) = SIGNS.iter().find(|sign| rest.starts_with(**sign)) else {
            let c = rest.chars().next().unwrap_or(' ');
            self.faults.push(Fault::new(self.at, c.len_utf8(), format!("{c:?} means nothing here")));
            self.at += c.len_utf8();
            return;
        };
        match *sign {
            "(" => self.open.push('('),
            "[" => self.open.push('['),
            "{" => self.open.push('{'),
            ")" | "]" | "}" => {
                let opener = match *sign {
                    ")" => '(',
                    "]" => '[',
                    _ => '{',
                };
                // A closer also closes what was forgotten inside; without its opener it closes nothing.
                if let Some(k) = self.open.iter().rposition(|c| *c == opener) {
                    self.open.truncate(k);
                }
            }
            _ => {}
        }
        self.push(Kind::Sign, sign.len());
    }

    /// A text on one line, up to the quote that no backslash stands before.
    fn quoted(&mut self, kind: Kind, quote: char) {
        let mut escaped = false;
        for (k, c) in self.rest().char_indices().skip(1) {
            match c {
                '\n' => break,
                _ if escaped => escaped = false,
                '\\' => escaped = true,
                _ if c == quote => {
                    self.push(kind, k + 1);
                    return;
                }
                _ => {}
            }
        }
        let len = self.rest().find('\n').unwrap_or(self.rest().len());
        self.faults.push(Fault::new(self.at, 1, "this text does not end on its line"));
        self.push(kind, len);
    }

    /// From three quotes or more to as many.
    fn raw(&mut self) {
        let rest = self.rest();
        let quotes = run(rest, 0, |c| c == '"');
        let fence = rest.get(..quotes).unwrap_or_default();
        let inside = rest.get(quotes..).unwrap_or_default();
        // The closing fence stands alone at the start of a line, behind blanks.
        let mut from = 0;
        while let Some(k) = inside.get(from..).and_then(|r| r.find('\n')) {
            from += k + 1;
            let line = inside.get(from..).unwrap_or_default();
            let blanks = run(line, 0, |c| c == ' ' || c == '\t');
            let closing = line.get(blanks..).unwrap_or_default();
            if closing.starts_with(fence) && !closing.get(quotes..).is_some_and(|r| r.starts_with('"')) {
                self.push(Kind::Raw, quotes + from + blanks + quotes);
                return;
            }
        }
        self.faults.push(Fault::new(self.at, quotes, format!("no line with {fence} ends this text")));
        self.push(Kind::Raw, rest.len());
    }

    /// From `|{` to the brace that closes it, on one line.
    fn formula(&mut self) {
        let mut depth = 0;
        for (k, c) in self.rest().char_indices() {
            match c {
                '{' => depth += 1,
                '}' => {
                    depth -= 1;
                    if depth == 0 {
                        self.push(Kind::Formula, k + 1);
                        return;
                    }
                }
                '\n' => break,
                _ => {}
            }
        }
        let len = self.rest().find('\n').unwrap_or(self.rest().len());
        self.faults.push(Fault::new(self.at, 2, "this expression has no closing } on its line"));
        self.push(Kind::Formula, len);
    }
}

/// How many bytes from `skip` on are characters of this sort.
fn run(text: &str, skip: usize, of: impl Fn(char) -> bool) -> usize {
    let rest = text.get(skip..).unwrap_or_default();
    rest.find(|c| !of(c)).unwrap_or(rest.len())
}

/// The length of a number: digits, a point and more digits, an exponent.
fn number(text: &str) -> Option<usize> {
    let digits = |from: usize| run(text, from, |c| c.is_ascii_digit());
    let sign = usize::from(text.starts_with('-'));
    if sign == 1 {
        for word in ["-inf", "-nan"] {
            if text.starts_with(word) && !text.get(4..).is_some_and(|r| r.starts_with(is_word)) {
                return Some(4);
            }
        }
    }
    let whole = digits(sign);
    if whole == 0 {
        return None;
    }
    let mut len = sign + whole;
    if text.get(len..).is_some_and(|r| r.starts_with('.')) && digits(len + 1) > 0 {
        len += 1 + digits(len + 1);
    }
    let exponent = text.get(len..).unwrap_or_default();
    if exponent.starts_with(['e', 'E']) {
        let sign = usize::from(exponent.get(1..).is_some_and(|r| r.starts_with(['+', '-'])));
        let n = digits(len + 1 + sign);
        if n > 0 {
            len += 1 + sign + n;
        }
    }
    Some(len)
}

/// The length of a path, `{0;1}`.
fn path(text: &str) -> Option<usize> {
    let end = text.find('}')?;
    let inside = text.get(1..end)?;
    let fits = inside.chars().all(|c| c.is_ascii_digit() || matches!(c, ' ' | ';' | '-'));
    (fits && crate::document::parse_path(text.get(..=end)?).is_some()).then_some(end + 1)
}

#[cfg(test)]
mod tests {
    use super::{Kind, lex};

    fn kinds(text: &str) -> Vec<(Kind, &str)> {
        let (tokens, faults) = lex(text);
        assert!(faults.is_empty(), "{faults:?}");
        tokens.iter().map(|t| (t.kind, t.text)).filter(|(k, _)| *k != Kind::End).collect()
    }

    #[test]
    fn numbers_ranges_and_words() {
        use Kind::{Number, Sign, Word};
        assert_eq!(
            kinds("0..10 -1.5e3 2D V.2 x"),
            [
                (Number, "0"),
                (Sign, ".."),
                (Number, "10"),
                (Number, "-1.5e3"),
                (Word, "2D"),
                (Word, "V"),
                (Sign, "."),
                (Number, "2"),
                (Word, "x")
            ]
        );
    }

    #[test]
    fn lines_end_only_outside_round_brackets() {
        let (tokens, _) = lex("a = B(\n1,\n2)\nc\n\n  d");
        let lines: Vec<_> = tokens.iter().filter(|t| t.kind == Kind::Newline).map(|t| t.text).collect();
        assert_eq!(lines, ["\n", "\n\n"]);
    }

    #[test]
    fn texts_formulas_and_paths() {
        use Kind::{Formula, Name, Path, Raw, Text};
        assert_eq!(
            kinds("\"a\\\"b\" `c d` |{x*{2}} {0;1} \"\"\"\n \"\" \n  \"\"\""),
            [
                (Text, "\"a\\\"b\""),
                (Name, "`c d`"),
                (Formula, "|{x*{2}}"),
                (Path, "{0;1}"),
                (Raw, "\"\"\"\n \"\" \n  \"\"\"")
            ]
        );
    }

    #[test]
    fn what_is_no_token_is_told() {
        let (_, faults) = lex("a = ? \"open\nb = \"\"\"\n");
        assert_eq!(faults.len(), 3);
    }
}
