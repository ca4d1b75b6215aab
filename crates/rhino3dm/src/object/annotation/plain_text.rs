//! The text of an annotation without its formatting, as the official reader gives it.
//!
//! That reader takes every text for rich text format, with or without its head, and breaks a line at a paragraph
//! mark only where a brace follows it before the next character. What programs write has that form.

/// Groups that begin with these control words hold no text.
const TABLES: [&str; 8] = ["fonttbl", "colortbl", "stylesheet", "info", "pict", "object", "header", "footer"];
/// Control words that stand for a character.
const CHARACTERS: [(&str, char); 7] = [
    ("emdash", '—'),
    ("endash", '–'),
    ("bullet", '•'),
    ("lquote", '‘'),
    ("rquote", '’'),
    ("ldblquote", '“'),
    ("rdblquote", '”'),
];
/// The characters 0x80 to 0x9F of code page 1252; those it does not have are left as they are.
const CODE_PAGE: [char; 32] = [
    '€', '\u{81}', '‚', 'ƒ', '„', '…', '†', '‡', 'ˆ', '‰', 'Š', '‹', 'Œ', '\u{8D}', 'Ž', '\u{8F}', '\u{90}',
    '‘', '’', '“', '”', '•', '–', '—', '˜', '™', 'š', '›', 'œ', '\u{9D}', 'ž', 'Ÿ',
];
const TAB: &str = "        ";
const LINE_END: &str = "\r\n";
/// The depth of braces beyond which nothing is read.
const DEEPEST: usize = 1000;

/// The text without formatting.
pub(super) fn of(text: &str) -> String {
    let rich = text.get(..5).is_some_and(|start| start.eq_ignore_ascii_case("{\\rtf"));
    let mut parser = Parser { rest: text, rich, ..Parser::default() };
    parser.run();
    parser.out
}

#[derive(Default)]
struct Parser<'a> {
    rest: &'a str,
    /// Whether the text has the head of rich text, so that line ends in it mean nothing.
    rich: bool,
    out: String,
    /// Of each open brace whether its text is none.
    hidden: Vec<bool>,
    line_end: LineEnd,
    lines: usize,
    /// The first half of a character that takes two numbers.
    half: Option<u16>,
    /// Whether a bracketed fraction is open.
    stacked: bool,
}

/// A line end that was read but not written.
#[derive(Default, Clone, Copy, PartialEq)]
enum LineEnd {
    #[default]
    None,
    /// It counts when a brace follows.
    Waiting,
    /// It counts when anything follows.
    Due,
}

impl Parser<'_> {
    fn run(&mut self) {
        while let Some(c) = self.next() {
            match c {
                '{' => {
                    if self.hidden.len() >= DEEPEST {
                        break;
                    }
                    self.hidden.push(self.is_hidden());
                    self.brace();
                }
                '}' => {
                    self.hidden.pop();
                    self.brace();
                }
                '\\' => self.control(),
                '\n' if !self.rich => self.end_line(LineEnd::Due),
                '\r' | '\n' | '\t' => {}
                '[' if self.eat("[") => self.stacked = true,
                ']' if self.stacked && self.eat("]") => self.stacked = false,
                c => self.put(c),
            }
        }
        // A last line end that is the only one ends the text and is none.
        if self.line_end != LineEnd::None && self.lines > 0 {
            self.out.push_str(LINE_END);
        }
    }

    fn next(&mut self) -> Option<char> {
        let mut chars = self.rest.chars();
        let c = chars.next();
        self.rest = chars.as_str();
        c
    }

    fn eat(&mut self, what: &str) -> bool {
        let found = self.rest.strip_prefix(what);
        self.rest = found.unwrap_or(self.rest);
        found.is_some()
    }

    fn is_hidden(&self) -> bool {
        self.hidden.last().copied().unwrap_or(false)
    }

    fn hide(&mut self) {
        if let Some(hidden) = self.hidden.last_mut() {
            *hidden = true;
        }
    }

    fn brace(&mut self) {
        if self.line_end == LineEnd::Waiting {
            self.line_end = LineEnd::Due;
        }
    }

    fn end_line(&mut self, how: LineEnd) {
        self.flush();
        self.line_end = how;
    }

    /// Writes the line end that is due and forgets one that waits.
    fn flush(&mut self) {
        if self.line_end == LineEnd::Due {
            self.out.push_str(LINE_END);
            self.lines += 1;
        }
        self.line_end = LineEnd::None;
    }

    fn put(&mut self, c: char) {
        if !self.is_hidden() {
            self.flush();
            self.out.push(c);
        }
    }

    /// What follows a backslash.
    fn control(&mut self) {
        let letters = self.rest.bytes().take_while(u8::is_ascii_alphabetic).count();
        if letters == 0 {
            return self.symbol();
        }
        let (word, rest) = self.rest.split_at(letters);
        let sign = usize::from(rest.starts_with('-'));
        let digits = rest.bytes().skip(sign).take_while(u8::is_ascii_digit).count();
        let (number, rest) = rest.split_at(if digits > 0 { sign + digits } else { 0 });
        // One blank belongs to the control word.
        self.rest = rest.strip_prefix(' ').unwrap_or(rest);
        match word {
            "par" if !self.is_hidden() => self.end_line(LineEnd::Waiting),
            "tab" => TAB.chars().for_each(|c| self.put(c)),
            "u" => {
                self.unicode(number.parse().unwrap_or_default());
                self.eat("?");
            }
            table if TABLES.contains(&table) => self.hide(),
            word => {
                if let Some((_, c)) = CHARACTERS.iter().find(|(name, _)| *name == word) {
                    self.put(*c);
                }
            }
        }
    }

    /// A character by its number; numbers are signed and of 16 bits, and large characters take two.
    fn unicode(&mut self, number: i64) {
        let Ok(unit) = u16::try_from(number.rem_euclid(0x1_0000)) else { return };
        let halves = self.half.take().into_iter().chain([unit]);
        for c in char::decode_utf16(halves) {
            match c {
                Ok(c) => self.put(c),
                Err(broken) if broken.unpaired_surrogate() == unit && unit < 0xDC00 => self.half = Some(unit),
                Err(_) => self.put(char::REPLACEMENT_CHARACTER),
            }
        }
    }

    /// A backslash and a character that is no letter.
    fn symbol(&mut self) {
        match self.next() {
            Some(c @ ('\\' | '{' | '}')) => self.put(c),
            Some('~') => self.put(' '),
            Some('_') => self.put('-'),
            Some('*') => self.hide(),
            Some('\'') => {
                let (digits, rest) = self.rest.split_at_checked(2).unwrap_or((self.rest, ""));
                self.rest = rest;
                if let Ok(code) = u8::from_str_radix(digits, 16) {
                    let special = code.checked_sub(0x80).and_then(|i| CODE_PAGE.get(usize::from(i)));
                    self.put(special.copied().unwrap_or(char::from(code)));
                }
            }
            _ => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::of;

    /// What rhino3dm 8.35 gives for each.
    #[test]
    fn text_is_what_the_official_reader_gives() {
        let head = "{\\rtf1\\deff0{\\fonttbl{\\f0 Arial;}}\\f0 ";
        for (rich, plain) in [
            ("{\\f0 a\\par}}", "a"),
            ("{\\f0 a\\par}{\\f0 b}}", "a\r\nb"),
            ("{\\f0 a\\par}{\\f0 b\\par}}", "a\r\nb\r\n"),
            ("\\fs18{\\f0 90.0\\u176?\\par}}", "90.0°"),
            ("a\\par b\\par c}", "abc"),
            ("{\\f0 a\\par}\\par{\\f0 b}}", "a\r\n\r\nb"),
            ("x{\\f0 a\\par}y}", "xa\r\ny"),
            ("{a\\par}{b\\par}{\\par}{c}}", "a\r\nb\r\n\r\nc"),
            ("{a}\\par {b}\\par {c}\\par}", "a\r\nb\r\nc\r\n"),
            ("{{\\i a\\par}} b}", "a\r\n b"),
            ("a\\tab b}", "a        b"),
            ("a\\~b\\_c\\-d}", "a b-cd"),
            ("a\\'e9b\\'80\\'93}", "aéb€“"),
            ("a\\u8364?b \\u-10179?\\u-8704?c}", "a€b 😀c"),
            ("\\u8364 b}", "€b"),
            ("\\{x\\}\\\\}", "{x}\\"),
            ("{\\*\\x y} z}", " z"),
            ("a\r\nb}", "ab"),
            ("[[1/2]]x}", "1/2x"),
            ("x\\emdash y\\bullet z\\lquote q\\rquote}", "x—y•z‘q’"),
        ] {
            assert_eq!(of(&format!("{head}{rich}")), plain, "{rich}");
        }
        for (text, plain) in [
            ("plain\nnext", "plain\r\nnext"),
            ("x\r\n\r\ny", "x\r\n\r\ny"),
            ("x\n", "x"),
            ("\nx", "\r\nx"),
            ("a}b", "ab"),
            ("a\\\\b", "a\\b"),
            ("a\\P b", "ab"),
            ("[[a", "a"),
            ("a]]b", "a]]b"),
            ("%<area(\"x\")>% end", "%<area(\"x\")>% end"),
        ] {
            assert_eq!(of(text), plain, "{text}");
        }
    }

    #[test]
    fn broken_text_ends() {
        for text in
            ["{\\rtf1", "\\", "\\'", "\\'é", "\\u", "\\u-55296\\u-55296", "}}}", "\\u99999999999999999999?"]
        {
            of(text);
        }
        of(&"{".repeat(100_000));
    }
}
