//! Masks: which paths, and which items in them, are meant.
//!
//! ```text
//! mask  = path [items] | items | "*"
//! path  = "{" rule { ";" rule } "}"          items = "[" rule "]"
//! rule  = term { ("and" | "or") term }       "and" binds more than "or"
//! term  = "*" | "?" | ["!"] ( integer | "(" set ")" | set )
//! set   = integer "to" integer | integer { "," integer } [ "," "..." [ "," integer ] ]
//! ```
//!
//! `*` alone between two `;` stands for any number of path elements, `?` for exactly one. Dots go on with the
//! step of the last two integers before them, up to the integer behind them.

use katydid_component::Message;

/// A mask that was read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Mask {
    /// The rules for path elements; `None` for any path.
    path: Option<Vec<Element>>,
    /// The rule for the index of an item; `None` for all items.
    items: Option<Rule>,
}

#[derive(Debug, Clone, PartialEq, Eq)]
enum Element {
    /// Any number of elements.
    Any,
    /// One element.
    One(Rule),
}

/// Alternatives, each a list of terms that must all hold.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Rule(Vec<Vec<Term>>);

#[derive(Debug, Clone, PartialEq, Eq)]
enum Term {
    Anything,
    In(Set),
    NotIn(Set),
}

#[derive(Debug, Clone, PartialEq, Eq)]
enum Set {
    /// From one integer to another, both included.
    Range(i64, i64),
    /// Single integers, and perhaps a run behind them.
    List(Vec<i64>, Option<Run>),
}

/// `from`, `from + step` and so on, up to `end`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Run {
    from: i64,
    step: i64,
    end: Option<i64>,
}

impl Set {
    fn contains(&self, x: i64) -> bool {
        match self {
            Self::Range(low, high) => (*low.min(high)..=*low.max(high)).contains(&x),
            Self::List(integers, run) => {
                integers.contains(&x)
                    || run.is_some_and(|run| {
                        x >= run.from && run.end.is_none_or(|end| x <= end) && (x - run.from) % run.step == 0
                    })
            }
        }
    }
}

impl Rule {
    fn holds(&self, x: i64) -> bool {
        let term = |term: &Term| match term {
            Term::Anything => true,
            Term::In(set) => set.contains(x),
            Term::NotIn(set) => !set.contains(x),
        };
        self.0.iter().any(|all| all.iter().all(term))
    }
}

impl Mask {
    /// Reads a mask.
    ///
    /// # Errors
    /// What was expected and where, in a sentence for the user.
    pub(super) fn parse(text: &str) -> Result<Self, Message> {
        let mut reader = Reader { text, tokens: tokens(text)?, at: 0 };
        let mask = reader.mask()?;
        match reader.peek() {
            None => Ok(mask),
            Some(_) => Err(reader.expected("the end")),
        }
    }

    /// Whether the mask tells items of one branch apart.
    pub(super) fn has_items(&self) -> bool {
        self.items.is_some()
    }

    /// The path of a mask that only one path fits.
    pub(super) fn only_path(&self) -> Option<Vec<i32>> {
        let only = |element: &Element| match element {
            Element::One(Rule(any)) => match any.as_slice() {
                [all] => match all.as_slice() {
                    [Term::In(Set::List(integers, None))] => match integers.as_slice() {
                        [one] => i32::try_from(*one).ok(),
                        _ => None,
                    },
                    _ => None,
                },
                _ => None,
            },
            Element::Any => None,
        };
        self.path.as_ref()?.iter().map(only).collect()
    }

    /// Whether a path fits.
    pub(super) fn fits_path(&self, path: &[i32]) -> bool {
        let Some(rules) = &self.path else { return true };
        // The usual matching with wildcards: on a misfit the last `*` takes one element more.
        let (mut rule, mut at) = (0, 0);
        let mut retry: Option<(usize, usize)> = None;
        loop {
            match (rules.get(rule), path.get(at)) {
                (None, None) => return true,
                (Some(Element::Any), _) => {
                    retry = Some((rule + 1, at));
                    rule += 1;
                    continue;
                }
                (Some(Element::One(one)), Some(&x)) if one.holds(i64::from(x)) => {
                    rule += 1;
                    at += 1;
                    continue;
                }
                _ => {}
            }
            match &mut retry {
                Some((after, start)) if *start < path.len() => {
                    *start += 1;
                    (rule, at) = (*after, *start);
                }
                _ => return false,
            }
        }
    }

    /// Whether an item of a path that fits is meant.
    pub(super) fn fits_item(&self, index: usize) -> bool {
        self.items.as_ref().is_none_or(|rule| i64::try_from(index).is_ok_and(|i| rule.holds(i)))
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Token {
    Sign(char),
    Integer(i64),
    Dots,
    To,
    And,
    Or,
}

/// The tokens with their places, counted in characters from 1.
fn tokens(text: &str) -> Result<Vec<(Token, usize)>, Message> {
    let mut tokens = Vec::new();
    let mut rest = text.char_indices().enumerate().peekable();
    let shown = || text.chars().take(80).collect::<String>();
    while let Some((place, (start, c))) = rest.next() {
        let token = match c {
            c if c.is_whitespace() => continue,
            '{' | '}' | '[' | ']' | '(' | ')' | ';' | ',' | '!' | '*' | '?' => Token::Sign(c),
            '…' => Token::Dots,
            '.' => {
                while rest.next_if(|&(_, (_, c))| c == '.').is_some() {}
                Token::Dots
            }
            '-' | '+' | '0'..='9' => {
                let mut end = start + 1;
                while let Some((_, (at, _))) = rest.next_if(|&(_, (_, c))| c.is_ascii_digit()) {
                    end = at + 1;
                }
                let digits = text.get(start..end).unwrap_or_default();
                let integer = digits.parse::<i32>().map_err(|_| {
                    Message::error(format!("Mask '{}': '{digits}' is not an integer of 32 bits", shown()))
                })?;
                Token::Integer(integer.into())
            }
            c if c.is_alphabetic() => {
                let mut word = c.to_lowercase().to_string();
                while let Some((_, (_, c))) = rest.next_if(|&(_, (_, c))| c.is_alphabetic()) {
                    word.extend(c.to_lowercase());
                }
                match word.as_str() {
                    "to" => Token::To,
                    "and" => Token::And,
                    "or" => Token::Or,
                    _ => {
                        return Err(Message::error(format!("Mask '{}': '{word}' means nothing", shown())));
                    }
                }
            }
            c => return Err(Message::error(format!("Mask '{}': '{c}' means nothing", shown()))),
        };
        tokens.push((token, place + 1));
    }
    Ok(tokens)
}

struct Reader<'a> {
    text: &'a str,
    tokens: Vec<(Token, usize)>,
    at: usize,
}

impl Reader<'_> {
    fn peek(&self) -> Option<Token> {
        self.tokens.get(self.at).map(|&(token, _)| token)
    }

    fn eat(&mut self, token: Token) -> bool {
        let found = self.peek() == Some(token);
        self.at += usize::from(found);
        found
    }

    fn integer(&mut self) -> Option<i64> {
        let Some(Token::Integer(x)) = self.peek() else { return None };
        self.at += 1;
        Some(x)
    }

    fn expected(&self, what: &str) -> Message {
        let text: String = self.text.chars().take(80).collect();
        let place = match self.tokens.get(self.at) {
            Some((_, place)) => format!("at character {place}"),
            None => "at its end".to_owned(),
        };
        Message::error(format!("Mask '{text}': {what} is expected {place}"))
    }

    fn mask(&mut self) -> Result<Mask, Message> {
        let path = match self.peek() {
            Some(Token::Sign('[')) => None,
            Some(Token::Sign('{')) => {
                self.at += 1;
                let path = self.path()?;
                if !self.eat(Token::Sign('}')) {
                    return Err(self.expected("'}'"));
                }
                Some(path)
            }
            _ => Some(self.path()?),
        };
        let mut items = None;
        if self.eat(Token::Sign('[')) {
            items = match self.element()? {
                Element::Any => None,
                Element::One(rule) => Some(rule),
            };
            if !self.eat(Token::Sign(']')) {
                return Err(self.expected("']'"));
            }
        }
        Ok(Mask { path, items })
    }

    fn path(&mut self) -> Result<Vec<Element>, Message> {
        let mut elements = vec![self.element()?];
        while self.eat(Token::Sign(';')) {
            elements.push(self.element()?);
        }
        Ok(elements)
    }

    fn element(&mut self) -> Result<Element, Message> {
        if self.eat(Token::Sign('*')) {
            match self.peek() {
                Some(Token::And | Token::Or) => self.at -= 1,
                _ => return Ok(Element::Any),
            }
        }
        let mut rule = vec![vec![self.term()?]];
        loop {
            if self.eat(Token::And) {
                let term = self.term()?;
                if let Some(all) = rule.last_mut() {
                    all.push(term);
                }
            } else if self.eat(Token::Or) {
                rule.push(vec![self.term()?]);
            } else {
                return Ok(Element::One(Rule(rule)));
            }
        }
    }

    fn term(&mut self) -> Result<Term, Message> {
        if self.eat(Token::Sign('*')) || self.eat(Token::Sign('?')) {
            return Ok(Term::Anything);
        }
        let not = self.eat(Token::Sign('!'));
        let bracket = self.eat(Token::Sign('('));
        let set = self.set()?;
        if bracket && !self.eat(Token::Sign(')')) {
            return Err(self.expected("')'"));
        }
        Ok(if not { Term::NotIn(set) } else { Term::In(set) })
    }

    fn set(&mut self) -> Result<Set, Message> {
        let first = self.integer().ok_or_else(|| self.expected("'*', '?' or an integer"))?;
        if self.eat(Token::To) {
            let last = self.integer().ok_or_else(|| self.expected("an integer"))?;
            return Ok(Set::Range(first, last));
        }
        let mut integers = vec![first];
        while self.eat(Token::Sign(',')) {
            if let Some(next) = self.integer() {
                integers.push(next);
                continue;
            }
            if !self.eat(Token::Dots) {
                return Err(self.expected("an integer or '...'"));
            }
            let [.., a, from] = integers.as_slice() else {
                return Err(self.expected("a second integer before '...'"));
            };
            let (from, step) = (*from, from - a);
            if step < 1 {
                return Err(self.expected("a growing series before '...'"));
            }
            let end = if self.eat(Token::Sign(',')) {
                Some(self.integer().ok_or_else(|| self.expected("an integer"))?)
            } else {
                None
            };
            return Ok(Set::List(integers, Some(Run { from, step, end })));
        }
        Ok(Set::List(integers, None))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fits(mask: &str, path: &[i32]) -> bool {
        Mask::parse(mask).unwrap().fits_path(path)
    }

    /// The integers from 0 to 12 that a rule for one element lets through.
    fn through(rule: &str) -> Vec<i32> {
        (0..=12).filter(|&i| fits(&format!("{{{rule}}}"), &[i])).collect()
    }

    #[test]
    fn rules_for_one_element() {
        let all: Vec<i32> = (0..=12).collect();
        let but = |no: &[i32]| all.iter().copied().filter(|i| !no.contains(i)).collect::<Vec<_>>();
        assert_eq!(through("*"), all);
        assert_eq!(through("?"), all);
        assert_eq!(through("6"), [6]);
        assert_eq!(through("!6"), but(&[6]));
        assert_eq!(through("(2,6,7)"), [2, 6, 7]);
        assert_eq!(through("!(2,6,7)"), but(&[2, 6, 7]));
        assert_eq!(through("(2 to 5)"), [2, 3, 4, 5]);
        assert_eq!(through("5 to 2"), [2, 3, 4, 5]);
        assert_eq!(through("!(2 to 20)"), [0, 1]);
        assert_eq!(through("(0,2,...)"), [0, 2, 4, 6, 8, 10, 12]);
        assert_eq!(through("0,2,...,7"), [0, 2, 4, 6]);
        assert_eq!(through("(1, 3, 6, …, 9)"), [1, 3, 6, 9]);
        assert_eq!(through("!(3,5,...)"), [0, 1, 2, 4, 6, 8, 10, 12]);
        assert_eq!(through("(0 to 6) and !(1,3,...) or 11"), [0, 2, 4, 6, 11]);
        assert_eq!(through("* and !3"), but(&[3]));
    }

    #[test]
    fn rules_for_paths() {
        for (mask, path, fit) in [
            ("{*}", &[0, 1, 2][..], true),
            ("*", &[][..], true),
            ("{0;?}", &[0, 7], true),
            ("{0;?}", &[0], false),
            ("{0;?}", &[0, 1, 2], false),
            ("{0;*}", &[0], true),
            ("{0;*}", &[0, 1, 2], true),
            ("{*;3}", &[1, 3, 2, 3], true),
            ("{*;3}", &[3], true),
            ("{*;3}", &[3, 4], false),
            ("{*;1;*;2}", &[0, 1, 1, 5, 2], true),
            ("{*;1;*;2}", &[0, 2, 2], false),
            ("{ 0 ; (1,2) }", &[0, 2], true),
            ("0;1", &[0, 1], true),
            ("{-1}", &[-1], true),
        ] {
            assert_eq!(fits(mask, path), fit, "{mask} on {path:?}");
        }
    }

    #[test]
    fn rules_for_items() {
        let mask = Mask::parse("{0;*}[0,2,...]").unwrap();
        assert!(mask.has_items() && mask.fits_item(4) && !mask.fits_item(3));
        let all = Mask::parse("{0}[*]").unwrap();
        assert!(!all.has_items() && all.fits_item(9));
        let any_path = Mask::parse("[1]").unwrap();
        assert!(any_path.fits_path(&[7, 7]) && any_path.fits_item(1) && !any_path.fits_item(0));
    }

    #[test]
    fn what_is_no_mask_says_why() {
        for (text, reason) in [
            ("", "Mask '': '*', '?' or an integer is expected at its end"),
            ("{0;1", "Mask '{0;1': '}' is expected at its end"),
            ("{0;;1}", "Mask '{0;;1}': '*', '?' or an integer is expected at character 4"),
            ("{a}", "Mask '{a}': 'a' means nothing"),
            ("{0}x", "Mask '{0}x': 'x' means nothing"),
            ("{0}{1}", "Mask '{0}{1}': the end is expected at character 4"),
            ("{(1,2}", "Mask '{(1,2}': ')' is expected at character 6"),
            ("{0,...}", "Mask '{0,...}': a second integer before '...' is expected at character 7"),
            ("{4,2,...}", "Mask '{4,2,...}': a growing series before '...' is expected at character 9"),
            ("{99999999999}", "Mask '{99999999999}': '99999999999' is not an integer of 32 bits"),
            ("{0}[", "Mask '{0}[': '*', '?' or an integer is expected at its end"),
            ("{3 to}", "Mask '{3 to}': an integer is expected at character 6"),
        ] {
            assert_eq!(Mask::parse(text).unwrap_err().text, reason);
        }
    }
}
