//! Blanks and line ends. The tokens stay, and so do the comments; only what stands between them changes.

use super::lexer::{Kind, Token, lex};
use super::text;

/// Lines are broken when they would be longer, in characters.
const WIDTH: usize = 100;
/// What a block, or a part of a broken line, is set in.
const INDENT: usize = 4;

/// The text in its usual form. A text in that form stays as it is.
pub(super) fn tidy(source: &str) -> String {
    let (tokens, _) = lex(source);
    let mut printer = Printer { source, out: String::with_capacity(source.len()), column: 0, blank: false };
    printer.document(&tokens);
    let mut out = printer.out;
    out.truncate(out.trim_end().len());
    if !out.is_empty() {
        out.push('\n');
    }
    out
}

struct Printer<'a> {
    source: &'a str,
    out: String,
    /// How many characters stand in the line.
    column: usize,
    /// An empty line comes before the next one.
    blank: bool,
}

/// Whether a blank stands between two tokens of a line.
fn spaced(a: &Token<'_>, b: &Token<'_>) -> bool {
    let sign = |t: &Token<'_>, signs: &[&str]| t.kind == Kind::Sign && signs.contains(&t.text);
    if b.kind == Kind::Comment || b.kind == Kind::Formula {
        return true;
    }
    if sign(a, &["(", "[", ".", "..", "~", "|"]) || b.kind == Kind::Suffix {
        return false;
    }
    if sign(b, &[")", "]", ",", ";", ":", ".", "..", "~", "!"]) {
        return false;
    }
    if sign(a, &["-", "+", ",", ";", "=", ":", "*"]) {
        return true;
    }
    if sign(a, &["/"]) {
        return sign(b, &["="]) || b.kind == Kind::Newline;
    }
    if sign(b, &["/"]) {
        return false;
    }
    if a.is_word("else") {
        return true;
    }
    if sign(b, &["("]) {
        return !(matches!(
            a.kind,
            Kind::Word | Kind::Name | Kind::Guid | Kind::Number | Kind::Suffix | Kind::Text
        ) || sign(a, &["!"]));
    }
    if sign(b, &["["]) {
        // An index is glued to its name.
        return !(b.glued && matches!(a.kind, Kind::Word | Kind::Name));
    }
    true
}

/// Where the bracket that opens at `k` is closed.
fn closing(tokens: &[Token<'_>], k: usize) -> usize {
    let mut depth = 0usize;
    for (n, token) in tokens.iter().enumerate().skip(k) {
        if token.is("(") || token.is("[") {
            depth += 1;
        } else if token.is(")") || token.is("]") {
            depth = depth.saturating_sub(1);
            if depth == 0 {
                return n;
            }
        }
    }
    tokens.len()
}

/// The tokens on one line.
fn flat(tokens: &[Token<'_>]) -> String {
    let mut line = String::new();
    let mut last: Option<&Token<'_>> = None;
    for (k, token) in tokens.iter().enumerate() {
        let next = tokens.get(k + 1);
        // A comma before a bracket that closes is for broken lines only.
        if token.is(",") && next.is_some_and(|next| next.is(")") || next.is("]")) {
            continue;
        }
        if last.is_some_and(|last| spaced(last, token)) {
            line.push(' ');
        }
        line.push_str(token.text.trim_end());
        last = Some(token);
    }
    line
}

/// How long the tokens are on one line. A text over several lines counts as its quotes.
fn width(tokens: &[Token<'_>]) -> usize {
    let raw: usize = tokens
        .iter()
        .filter(|token| token.kind == Kind::Raw)
        .map(|token| token.text.trim_end().chars().count().saturating_sub(3))
        .sum();
    flat(tokens).chars().count().saturating_sub(raw)
}

/// Whether something in these tokens ends a line.
fn needs_lines(tokens: &[Token<'_>]) -> bool {
    tokens.iter().any(|token| matches!(token.kind, Kind::Comment | Kind::Raw))
}

/// A part of a broken list.
struct Part<'t, 'a> {
    tokens: &'t [Token<'a>],
    separator: Option<&'t Token<'a>>,
    /// Comments on lines of their own before it.
    before: Vec<&'t Token<'a>>,
    /// Comments at the end of its line.
    after: Vec<&'t Token<'a>>,
}

impl<'a> Printer<'a> {
    fn document(&mut self, tokens: &[Token<'a>]) {
        let mut indent = 0usize;
        let mut line: Vec<Token<'a>> = Vec::new();
        for token in tokens {
            match token.kind {
                Kind::Newline => {
                    // After a comma the line goes on.
                    let last = line.iter().rev().find(|token| token.kind != Kind::Comment);
                    if last.is_some_and(|last| last.is(",")) {
                        continue;
                    }
                    self.line(&mut line, indent);
                    self.blank |= token.text.matches('\n').count() > 1;
                }
                Kind::End => self.line(&mut line, indent),
                Kind::Sign if token.text == "{" => {
                    line.push(*token);
                    self.line(&mut line, indent);
                    self.blank = false;
                    indent = (indent + INDENT).min(WIDTH);
                }
                Kind::Sign if token.text == "}" => {
                    self.line(&mut line, indent);
                    self.blank = false;
                    indent = indent.saturating_sub(INDENT);
                    line.push(*token);
                }
                _ => line.push(*token),
            }
        }
    }

    fn line(&mut self, line: &mut Vec<Token<'a>>, indent: usize) {
        if line.is_empty() {
            return;
        }
        if std::mem::take(&mut self.blank) && !self.out.is_empty() {
            self.out.push('\n');
        }
        self.start(indent);
        self.tokens(line, indent, 0);
        self.end();
        line.clear();
    }

    fn start(&mut self, indent: usize) {
        self.out.extend(std::iter::repeat_n(' ', indent));
        self.column = indent;
    }

    fn end(&mut self) {
        self.out.truncate(self.out.trim_end_matches(' ').len());
        self.out.push('\n');
        self.column = 0;
    }

    fn put(&mut self, text: &str) {
        self.out.push_str(text);
        self.column += text.chars().count();
    }

    /// Tokens from here on, on one line if they fit; `extra` characters follow them.
    fn tokens(&mut self, tokens: &[Token<'a>], indent: usize, extra: usize) {
        let (comment, plain) = match tokens.split_last() {
            Some((last, rest)) if last.kind == Kind::Comment => (Some(last), rest),
            _ => (None, tokens),
        };
        let text = if needs_lines(plain) { None } else { Some(flat(plain)) };
        match text.filter(|text| self.column + text.chars().count() + extra <= WIDTH) {
            Some(text) => self.put(&text),
            None => self.broken(plain, indent),
        }
        if let Some(comment) = comment {
            if !plain.is_empty() {
                self.put(" ");
            }
            self.put(comment.text.trim_end());
        }
    }

    /// The lists to be broken: those that must be, and then the longest until the rest fits.
    fn choose(&self, tokens: &[Token<'a>]) -> Vec<(usize, usize)> {
        let mut groups = Vec::new();
        let mut k = 0;
        while let Some(token) = tokens.get(k) {
            if token.is("(") || token.is("[") {
                let end = closing(tokens, k);
                // One list, or one text, between round brackets keeps them close.
                let inner = tokens.get(k + 1);
                if inner.is_some_and(|t| t.is("[")) && closing(tokens, k + 1) + 1 == end {
                    groups.push((k + 1, end - 1));
                } else if !(inner.is_some_and(|t| t.kind == Kind::Raw) && end == k + 2) {
                    groups.push((k, end));
                }
                k = end;
            }
            k += 1;
        }
        let length = |(a, b): &(usize, usize)| tokens.get(*a..*b).map_or(0, width);
        let (mut chosen, mut rest): (Vec<_>, Vec<_>) =
            groups.into_iter().partition(|(a, b)| tokens.get(*a..*b).is_some_and(needs_lines));
        // An index, or brackets around one thing, are not worth lines of their own.
        rest.retain(|(a, b)| b - a > 2);
        // The members of a group are what makes its line long.
        if tokens.first().is_some_and(|first| first.is_word("group")) {
            rest.clear();
        }
        rest.sort_by_key(length);
        let mut left = self.column + width(tokens);
        left = left.saturating_sub(chosen.iter().map(length).sum());
        while left > WIDTH {
            let Some(group) = rest.pop() else { break };
            left = left.saturating_sub(length(&group));
            chosen.push(group);
        }
        chosen.sort_unstable();
        chosen
    }

    fn broken(&mut self, tokens: &[Token<'a>], indent: usize) {
        let chosen = self.choose(tokens);
        // A list without brackets: the members of a group, the outputs of a script.
        let open = chosen.is_empty();
        let mut last: Option<&Token<'a>> = None;
        let mut k = 0;
        while let Some(token) = tokens.get(k) {
            let mut blank = last.is_some_and(|last| spaced(last, token));
            let after_comma = open && last.is_some_and(|last| last.is(",") || last.kind == Kind::Comment);
            let word: usize = tokens
                .get(k..)
                .unwrap_or_default()
                .iter()
                .take_while(|t| !t.is(",") && t.kind != Kind::Comment)
                .map(|t| t.text.chars().count() + 1)
                .sum();
            let ended = last.is_some_and(|last| last.kind == Kind::Comment);
            if ended || after_comma && token.kind != Kind::Comment && self.column + word > WIDTH {
                self.end();
                self.start(indent + INDENT);
                blank = false;
            }
            if blank {
                self.put(" ");
            }
            if let Some((_, end)) = chosen.iter().find(|(start, _)| *start == k) {
                self.group(tokens.get(k..=*end).or(tokens.get(k..)).unwrap_or_default(), indent);
                k = *end;
            } else if token.kind == Kind::Raw {
                self.raw(token, indent);
            } else {
                self.put(token.text.trim_end());
            }
            last = tokens.get(k);
            k += 1;
        }
    }

    fn raw(&mut self, token: &Token<'a>, indent: usize) {
        let margin = if self.column == indent { indent } else { indent + INDENT };
        match text::unraw(token.text) {
            Ok(inside) => self.put(&text::raw(&inside, margin)),
            Err(_) => self.put(token.text),
        }
    }

    /// A list over several lines: round ones a part a line, square ones as many as fit.
    fn group(&mut self, tokens: &[Token<'a>], indent: usize) {
        let (Some(open), Some((close, inside))) =
            (tokens.first(), tokens.get(1..).and_then(<[Token<'a>]>::split_last))
        else {
            return;
        };
        let round = open.is("(");
        let parts = self.parts(inside);
        let commented = parts.iter().any(|part| !part.before.is_empty() || !part.after.is_empty());
        let one_a_line = round || commented || needs_lines(inside);
        self.put(open.text);
        self.end();
        let inner = indent + INDENT;
        self.start(inner);
        let count = parts.len();
        for (k, part) in parts.iter().enumerate() {
            for comment in &part.before {
                self.put(comment.text.trim_end());
                self.end();
                self.start(inner);
            }
            let length = flat(part.tokens).chars().count() + 1;
            if !one_a_line && k > 0 {
                if self.column + 1 + length > WIDTH {
                    self.end();
                    self.start(inner);
                } else {
                    self.put(" ");
                }
            }
            self.tokens(part.tokens, inner, 1);
            match part.separator {
                Some(separator) if round || k + 1 < count || separator.is(";") => self.put(separator.text),
                None if round && !part.tokens.is_empty() => self.put(","),
                _ => {}
            }
            for comment in &part.after {
                self.put(" ");
                self.put(comment.text.trim_end());
            }
            if one_a_line && k + 1 < count {
                self.end();
                self.start(inner);
            }
        }
        self.end();
        self.start(indent);
        self.put(close.text);
    }

    /// The parts between the commas.
    fn parts<'t>(&self, tokens: &'t [Token<'a>]) -> Vec<Part<'t, 'a>> {
        let mut parts: Vec<Part<'t, 'a>> = Vec::new();
        let (mut start, mut k) = (0, 0);
        let (mut before, mut after): (Vec<&Token<'a>>, Vec<&Token<'a>>) = (Vec::new(), Vec::new());
        let part = |start: usize, end: usize, separator, before, after| Part {
            tokens: tokens.get(start..end).unwrap_or_default(),
            separator,
            before,
            after,
        };
        while let Some(token) = tokens.get(k) {
            if token.is("(") || token.is("[") {
                k = closing(tokens, k);
            } else if token.kind == Kind::Comment {
                // At the end of the line of the part before, or on a line of its own.
                let behind = k.checked_sub(1).and_then(|k| tokens.get(k)).map_or(0, |t| t.at + t.text.len());
                let own_line = k == 0 || self.source.get(behind..token.at).is_some_and(|s| s.contains('\n'));
                if start < k {
                    after.push(token);
                    parts.push(part(start, k, None, std::mem::take(&mut before), std::mem::take(&mut after)));
                    // The comma, if it comes next, belongs to the part.
                    if let (Some(next), Some(last)) = (tokens.get(k + 1), parts.last_mut())
                        && (next.is(",") || next.is(";"))
                    {
                        last.separator = Some(next);
                        k += 1;
                    }
                } else if let (false, Some(last)) = (own_line || !before.is_empty(), parts.last_mut()) {
                    last.after.push(token);
                } else {
                    before.push(token);
                }
                start = k + 1;
            } else if token.is(",") || token.is(";") {
                parts.push(part(start, k, Some(token), std::mem::take(&mut before), Vec::new()));
                start = k + 1;
            }
            k += 1;
        }
        if start < tokens.len() || !before.is_empty() {
            parts.push(part(start.min(tokens.len()), tokens.len(), None, before, after));
        }
        parts
    }
}
