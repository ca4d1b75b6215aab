//! .NET's syntax of regular expressions as that of `fancy-regex`.

use std::iter::Peekable;
use std::str::Chars;

/// `RegexOptions` that change how a pattern is read.
mod option {
    pub(super) const IGNORE_CASE: i32 = 1;
    pub(super) const MULTILINE: i32 = 2;
    pub(super) const EXPLICIT_CAPTURE: i32 = 4;
    pub(super) const SINGLELINE: i32 = 16;
    pub(super) const IGNORE_WHITESPACE: i32 = 32;
    pub(super) const RIGHT_TO_LEFT: i32 = 64;
    pub(super) const ECMASCRIPT: i32 = 256;
}

/// Why a pattern is not taken.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum Fault {
    /// It is wrong in .NET too.
    Wrong(String),
    /// It is right in .NET.
    NotSupported(String),
}

/// A pattern in the other syntax.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Translated {
    pub(super) text: String,
    /// For each group as .NET counts them its number in the text, and its name: those with names come last.
    pub(super) groups: Vec<(usize, Option<String>)>,
}

struct Translator<'a> {
    chars: Peekable<Chars<'a>>,
    out: String,
    /// Names of capturing groups in the order of the text, none for a group without a name.
    captures: Vec<Option<String>>,
    /// Options inside each group that is open.
    options: Vec<i32>,
    /// Places in the output where the number of a group is missing, with .NET's number.
    numbers: Vec<(usize, usize)>,
}

/// Translates a pattern.
pub(super) fn translate(pattern: &str, options: i32) -> Result<Translated, Fault> {
    if options & option::RIGHT_TO_LEFT != 0 {
        return Err(Fault::NotSupported("RegexOptions.RightToLeft".to_owned()));
    }
    if options & option::ECMASCRIPT != 0 {
        return Err(Fault::NotSupported("RegexOptions.ECMAScript".to_owned()));
    }
    let mut t = Translator {
        chars: pattern.chars().peekable(),
        out: String::new(),
        captures: Vec::new(),
        options: vec![options],
        numbers: Vec::new(),
    };
    t.flags(options);
    while let Some(c) = t.chars.next() {
        t.piece(c)?;
    }
    if t.options.len() != 1 {
        return Err(Fault::Wrong("Not enough )'s.".to_owned()));
    }
    t.finish()
}

impl Translator<'_> {
    fn on(&self, bit: i32) -> bool {
        self.options.last().is_some_and(|options| options & bit != 0)
    }

    /// Options that both know are set inline; the others are seen to here.
    fn flags(&mut self, options: i32) {
        let words = [(option::IGNORE_CASE, 'i'), (option::SINGLELINE, 's')];
        let set: String = words.iter().filter(|(bit, _)| options & bit != 0).map(|(_, c)| *c).collect();
        if !set.is_empty() {
            self.out.push_str(&format!("(?{set})"));
        }
    }

    fn piece(&mut self, c: char) -> Result<(), Fault> {
        match c {
            '\\' => return self.escape(),
            '[' => return self.class(),
            '(' => return self.group(),
            ')' => {
                if self.options.len() < 2 {
                    return Err(Fault::Wrong("Too many )'s.".to_owned()));
                }
                self.options.pop();
                self.out.push(')');
            }
            '$' => self.out.push_str(if self.on(option::MULTILINE) { r"(?=\n|\z)" } else { r"(?=\n?\z)" }),
            '^' => self.out.push_str(if self.on(option::MULTILINE) { "(?m:^)" } else { r"\A" }),
            '{' => {
                // A brace that is no repetition is itself.
                let rest: String = self.chars.clone().take_while(|c| *c != '}').collect();
                let (least, most) = rest.split_once(',').unwrap_or((&rest, "0"));
                let number = |text: &str| !text.is_empty() && text.chars().all(|c| c.is_ascii_digit());
                let is_count = number(least) && (number(most) || most.is_empty());
                let closed = self.chars.clone().any(|c| c == '}');
                self.out.push_str(if is_count && closed { "{" } else { r"\{" });
                if is_count && closed {
                    self.out.push_str(&rest);
                    self.out.push('}');
                    for _ in rest.chars() {
                        self.chars.next();
                    }
                    self.chars.next();
                }
            }
            '}' => self.out.push_str(r"\}"),
            ']' => self.out.push_str(r"\]"),
            c if self.on(option::IGNORE_WHITESPACE) && c.is_whitespace() => {}
            '#' if self.on(option::IGNORE_WHITESPACE) => {
                for c in self.chars.by_ref() {
                    if c == '\n' {
                        break;
                    }
                }
            }
            '#' | '&' | '~' | '-' => {
                self.out.push('\\');
                self.out.push(c);
            }
            c => self.out.push(c),
        }
        Ok(())
    }

    fn hex(&mut self, digits: usize) -> Result<(), Fault> {
        let code: String = self.chars.by_ref().take(digits).collect();
        if code.len() != digits || !code.chars().all(|c| c.is_ascii_hexdigit()) {
            return Err(Fault::Wrong("Insufficient hexadecimal digits.".to_owned()));
        }
        self.out.push_str(&format!("\\x{{{code}}}"));
        Ok(())
    }

    /// What stands for a character, in a class and outside of it; false where it is something else.
    fn character(&mut self, c: char) -> Result<bool, Fault> {
        match c {
            'u' => self.hex(4)?,
            'x' => self.hex(2)?,
            'e' => self.out.push_str(r"\x1B"),
            'a' => self.out.push_str(r"\x07"),
            'v' => self.out.push_str(r"\x0B"),
            'f' => self.out.push_str(r"\x0C"),
            'n' | 'r' | 't' => self.out.push_str(&format!("\\{c}")),
            '0' => self.out.push_str(r"\x00"),
            'c' => {
                let Some(letter) = self.chars.next().filter(char::is_ascii_alphabetic) else {
                    return Err(Fault::Wrong("Unrecognized control character.".to_owned()));
                };
                self.out.push_str(&format!("\\x{:02X}", letter.to_ascii_uppercase() as u32 - 64));
            }
            'd' | 'D' | 'w' | 'W' | 's' | 'S' => self.out.push_str(&format!("\\{c}")),
            'p' | 'P' => {
                self.out.push('\\');
                self.out.push(c);
            }
            c if c.is_ascii_alphanumeric() => return Ok(false),
            c if c.is_ascii() && !c.is_ascii_control() && c != ' ' => self.out.push_str(&format!("\\{c}")),
            c => self.out.push(c),
        }
        Ok(true)
    }

    fn escape(&mut self) -> Result<(), Fault> {
        let Some(c) = self.chars.next() else {
            return Err(Fault::Wrong("Illegal \\ at end of pattern.".to_owned()));
        };
        match c {
            'Z' => self.out.push_str(r"(?=\n?\z)"),
            'A' | 'z' | 'b' | 'B' | 'G' => self.out.push_str(&format!("\\{c}")),
            'k' => {
                let open = self.chars.next();
                let close = if open == Some('\'') { '\'' } else { '>' };
                let name: String = self.chars.by_ref().take_while(|c| *c != close).collect();
                match name.parse() {
                    Ok(number) => self.numbers.push((self.out.len(), number)),
                    Err(_) => self.out.push_str(&format!("\\k<{name}>")),
                }
            }
            '1'..='9' => {
                let mut number = c as usize - '0' as usize;
                while let Some(digit) = self.chars.peek().and_then(|c| c.to_digit(10))
                    && number < 1000
                {
                    self.chars.next();
                    number = number * 10 + digit as usize;
                }
                self.numbers.push((self.out.len(), number));
            }
            c => {
                if !self.character(c)? {
                    return Err(Fault::Wrong(format!("Unrecognized escape sequence \\{c}.")));
                }
            }
        }
        Ok(())
    }

    /// `[...]`, with `-[...]` that takes away.
    fn class(&mut self) -> Result<(), Fault> {
        self.out.push('[');
        if self.chars.next_if_eq(&'^').is_some() {
            self.out.push('^');
        }
        let mut first = true;
        loop {
            let Some(c) = self.chars.next() else {
                return Err(Fault::Wrong("Unterminated [] set.".to_owned()));
            };
            match c {
                ']' if !first => {
                    self.out.push(']');
                    return Ok(());
                }
                '-' if self.chars.peek() == Some(&'[') && !first => {
                    self.chars.next();
                    self.out.push_str("--");
                    self.class()?;
                }
                '\\' => match self.chars.next() {
                    Some('b') => self.out.push_str(r"\x08"),
                    Some(c) => {
                        if !self.character(c)? {
                            return Err(Fault::Wrong(format!("Unrecognized escape sequence \\{c}.")));
                        }
                    }
                    None => return Err(Fault::Wrong("Illegal \\ at end of pattern.".to_owned())),
                },
                '-' => self.out.push('-'),
                c if c.is_ascii_punctuation() => self.out.push_str(&format!("\\{c}")),
                c => self.out.push(c),
            }
            first = false;
        }
    }

    fn group(&mut self) -> Result<(), Fault> {
        let inner = *self.options.last().unwrap_or(&0);
        if self.chars.next_if_eq(&'?').is_none() {
            if inner & option::EXPLICIT_CAPTURE != 0 {
                self.out.push_str("(?:");
            } else {
                self.out.push('(');
                self.captures.push(None);
            }
            self.options.push(inner);
            return Ok(());
        }
        let Some(c) = self.chars.next() else {
            return Err(Fault::Wrong("Unrecognized grouping construct.".to_owned()));
        };
        match c {
            ':' | '=' | '!' | '>' => self.out.push_str(&format!("(?{c}")),
            '<' if matches!(self.chars.peek(), Some('=' | '!')) => {
                let c = self.chars.next().unwrap_or('=');
                self.out.push_str(&format!("(?<{c}"));
            }
            '<' | '\'' => self.named(if c == '<' { '>' } else { '\'' })?,
            '#' => {
                for c in self.chars.by_ref() {
                    if c == ')' {
                        return Ok(());
                    }
                }
                return Err(Fault::Wrong("Unterminated (?#...) comment.".to_owned()));
            }
            '(' => return Err(Fault::NotSupported("A condition in a regular expression".to_owned())),
            c => return self.inline(c, inner),
        }
        self.options.push(inner);
        Ok(())
    }

    fn named(&mut self, close: char) -> Result<(), Fault> {
        let name: String = self.chars.by_ref().take_while(|c| *c != close).collect();
        if name.contains('-') {
            return Err(Fault::NotSupported("A balancing group in a regular expression".to_owned()));
        }
        if name.chars().all(|c| c.is_ascii_digit()) {
            return Err(Fault::NotSupported("A group of a regular expression with a number".to_owned()));
        }
        if !name.chars().all(|c| c.is_alphanumeric() || c == '_') {
            return Err(Fault::Wrong(
                "Invalid group name: Group names must begin with a word character.".to_owned(),
            ));
        }
        self.out.push_str(&format!("(?<{name}>"));
        self.captures.push(Some(name));
        Ok(())
    }

    /// `(?i-m)` to the end of the group around, or `(?i:...)`.
    fn inline(&mut self, first: char, outer: i32) -> Result<(), Fault> {
        let (mut options, mut on, mut c) = (outer, true, first);
        loop {
            let bit = match c {
                '-' => {
                    on = false;
                    0
                }
                'i' => option::IGNORE_CASE,
                'm' => option::MULTILINE,
                'n' => option::EXPLICIT_CAPTURE,
                's' => option::SINGLELINE,
                'x' => option::IGNORE_WHITESPACE,
                ':' | ')' => break,
                _ => return Err(Fault::Wrong("Unrecognized grouping construct.".to_owned())),
            };
            options = if on { options | bit } else { options & !bit };
            let Some(next) = self.chars.next() else {
                return Err(Fault::Wrong("Unrecognized grouping construct.".to_owned()));
            };
            c = next;
        }
        let word = |bit, c| if options & bit != 0 { (c, "") } else { ("", c) };
        let (i, no_i) = word(option::IGNORE_CASE, "i");
        let (s, no_s) = word(option::SINGLELINE, "s");
        let off = if no_i.is_empty() && no_s.is_empty() { "" } else { "-" };
        self.out.push_str(&format!("(?{i}{s}{off}{no_i}{no_s}{c}"));
        if c == ':' {
            self.options.push(options);
        } else if let Some(last) = self.options.last_mut() {
            *last = options;
        }
        Ok(())
    }

    /// Groups as .NET counts them: those without names first.
    fn finish(self) -> Result<Translated, Fault> {
        let mut groups = vec![(0, None)];
        let numbered =
            |named: bool| self.captures.iter().enumerate().filter(move |(_, name)| name.is_some() == named);
        groups.extend(numbered(false).map(|(i, _)| (i + 1, None)));
        for (i, name) in numbered(true) {
            if groups.iter().any(|(_, n)| n == name) {
                return Err(Fault::NotSupported(
                    "Two groups of a regular expression with one name".to_owned(),
                ));
            }
            groups.push((i + 1, name.clone()));
        }
        let mut text = String::new();
        let mut done = 0;
        for (at, number) in &self.numbers {
            let Some((group, _)) = groups.get(*number) else {
                return Err(Fault::Wrong(format!("Reference to undefined group number {number}.")));
            };
            text.push_str(&self.out[done..*at]);
            // The name in brackets keeps a digit behind it apart.
            text.push_str(&format!("(?:\\{group})"));
            done = *at;
        }
        text.push_str(&self.out[done..]);
        Ok(Translated { text, groups })
    }
}

#[cfg(test)]
mod tests {
    use super::{Fault, translate};

    fn text(pattern: &str) -> String {
        translate(pattern, 0).map(|t| t.text).unwrap_or_default()
    }

    #[test]
    fn what_differs_is_translated() {
        assert_eq!(text(r"^a$"), r"\Aa(?=\n?\z)");
        assert_eq!(text(r"[a-z-[aeiou]]"), r"[a-z--[aeiou]]");
        assert_eq!(text(r"[[&]"), r"[\[\&]");
        assert_eq!(text(r"\u00e9{2}"), r"\x{00e9}{2}");
        assert_eq!(text(r"a{,3}"), r"a\{,3\}");
        assert_eq!(text(r"(?'n'x)\k<n>"), r"(?<n>x)\k<n>");
    }

    #[test]
    fn groups_with_names_are_counted_last() {
        let made = translate(r"(?<y>a)(b)\1", 0).map(|t| (t.text, t.groups));
        let groups = vec![(0, None), (2, None), (1, Some("y".to_owned()))];
        assert_eq!(made, Ok((r"(?<y>a)(b)(?:\2)".to_owned(), groups)));
    }

    #[test]
    fn faults_are_told_apart() {
        assert!(matches!(translate("(a", 0), Err(Fault::Wrong(_))));
        assert!(matches!(translate("[a", 0), Err(Fault::Wrong(_))));
        assert!(matches!(translate(r"(?<a-b>x)", 0), Err(Fault::NotSupported(_))));
        assert!(matches!(translate("a", 64), Err(Fault::NotSupported(_))));
    }
}
