//! The text of a rich text string: what is left when its control words and tables are taken out.

/// Groups of these control words hold no text.
const TABLES: [&str; 8] = ["fonttbl", "colortbl", "stylesheet", "info", "pict", "object", "header", "footer"];

/// The text without formatting; a string that is not in rich text format is plain already.
pub(super) fn of(text: &str) -> String {
    if !text.get(..6).is_some_and(|start| start.eq_ignore_ascii_case("{\\rtf1")) {
        return text.to_owned();
    }
    let mut parser = Parser { rest: text, out: String::new(), groups: Vec::new(), fallback: 1, skip: 0 };
    parser.run();
    // A paragraph mark at the end ends the last line and begins no other.
    parser.out.trim_end_matches(['\r', '\n']).to_owned()
}

/// What holds inside a pair of braces.
#[derive(Clone, Copy)]
struct Group {
    /// Whether its text is none.
    hidden: bool,
    /// How many characters stand in for one that is written as a number.
    fallback: usize,
}

struct Parser<'a> {
    rest: &'a str,
    out: String,
    groups: Vec<Group>,
    fallback: usize,
    /// Characters to pass over behind a number.
    skip: usize,
}

/// The depth of braces beyond which nothing is read.
const DEEPEST: usize = 1000;

impl Parser<'_> {
    fn run(&mut self) {
        while let Some(c) = self.next() {
            match c {
                '{' if self.groups.len() < DEEPEST => {
                    let hidden = self.hidden();
                    self.groups.push(Group { hidden, fallback: self.fallback });
                    self.skip = 0;
                }
                '{' => return,
                '}' => {
                    let Some(group) = self.groups.pop() else { return };
                    self.fallback = group.fallback;
                    self.skip = 0;
                }
                '\\' => self.control(),
                '\r' | '\n' => {}
                c => self.put(c),
            }
        }
    }

    fn next(&mut self) -> Option<char> {
        let mut chars = self.rest.chars();
        let c = chars.next();
        self.rest = chars.as_str();
        c
    }

    fn hidden(&self) -> bool {
        self.groups.last().is_some_and(|group| group.hidden)
    }

    fn put(&mut self, c: char) {
        if self.skip > 0 {
            self.skip -= 1;
        } else if !self.hidden() {
            self.out.push(c);
        }
    }

    fn hide(&mut self) {
        if let Some(group) = self.groups.last_mut() {
            group.hidden = true;
        }
    }

    /// What follows a backslash.
    fn control(&mut self) {
        let letters = self.rest.bytes().take_while(u8::is_ascii_alphabetic).count();
        if letters == 0 {
            return self.symbol();
        }
        let (word, rest) = self.rest.split_at(letters);
        let signed = usize::from(rest.starts_with('-'));
        let digits = rest.bytes().skip(signed).take_while(u8::is_ascii_digit).count();
        let length = if digits > 0 { signed + digits } else { 0 };
        let (number, rest) = rest.split_at(length);
        // One blank belongs to the control word.
        self.rest = rest.strip_prefix(' ').unwrap_or(rest);
        let number: Option<i64> = number.parse().ok();
        match word {
            "par" | "line" => "\r\n".chars().for_each(|c| self.put(c)),
            "tab" => self.put('\t'),
            "uc" => self.fallback = number.and_then(|n| usize::try_from(n).ok()).unwrap_or(1),
            "u" => {
                let code = number.map_or(0, |n| if n < 0 { n + 0x1_0000 } else { n });
                self.put(
                    u32::try_from(code).ok().and_then(char::from_u32).unwrap_or(char::REPLACEMENT_CHARACTER),
                );
                self.skip = self.fallback;
            }
            table if TABLES.contains(&table) => self.hide(),
            _ => {}
        }
    }

    /// A backslash and a character that is no letter.
    fn symbol(&mut self) {
        match self.next() {
            Some(c @ ('\\' | '{' | '}')) => self.put(c),
            Some('~') => self.put('\u{A0}'),
            Some('_') => self.put('\u{2011}'),
            Some('*') => self.hide(),
            Some('\'') => {
                let (digits, rest) = self.rest.split_at_checked(2).unwrap_or((self.rest, ""));
                self.rest = rest;
                // Taken for Latin-1; the code page is not followed.
                if let Ok(code) = u8::from_str_radix(digits, 16) {
                    self.put(char::from(code));
                }
            }
            Some('\r' | '\n') => "\r\n".chars().for_each(|c| self.put(c)),
            _ => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::of;

    #[test]
    fn control_words_and_tables_are_no_text() {
        let text = "{\\rtf1\\deff0{\\fonttbl{\\f0 Arial;}}\\f0 \\fs18{\\f0 90.0\\u176?\\par}}";
        assert_eq!(of(text), "90.0°");
        assert_eq!(of("plain {text}"), "plain {text}");
        assert_eq!(of("{\\rtf1 a\\par b\\{\\'e9\\u-10179?\\u-8704?}"), "a\r\nb{é\u{FFFD}\u{FFFD}");
        assert_eq!(of("{\\rtf1{\\*\\generator x;}{\\b y} z}"), "y z");
    }

    #[test]
    fn broken_text_ends() {
        for text in [
            "{\\rtf1",
            "{\\rtf1\\",
            "{\\rtf1\\'",
            "{\\rtf1\\'é",
            "{\\rtf1\\u",
            "{\\rtf1}}}}a",
            "{\\rtf1\\u99999999999999999999?",
        ] {
            of(text);
        }
        of(&format!("{{\\rtf1{}", "{".repeat(100_000)));
    }
}
