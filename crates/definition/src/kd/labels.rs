//! The names that objects go by in the text.

use std::collections::HashMap;
use std::fmt;

use super::lexer::{Kind, lex};
use super::parse_parts::{MADE, TIME};
use super::parser::RESERVED;
use super::text;
use crate::document::Object;

/// A name for an object, unique in its document.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Label {
    text: String,
    quoted: bool,
    suffix: Option<u32>,
}

impl Label {
    /// What the object is found by.
    pub(super) fn key(&self) -> String {
        match self.suffix {
            Some(n) => format!("{}'{n}", self.text),
            None => self.text.clone(),
        }
    }
}

impl Label {
    /// The label before a point and a number: `a 0` and `.1` would read as 0.1 without quotes.
    pub(super) fn before_number(&self) -> Self {
        let ends_in_digit = self.suffix.is_none() && self.text.ends_with(|c: char| c.is_ascii_digit());
        Self { quoted: self.quoted || ends_in_digit && self.text.contains(' '), ..self.clone() }
    }
}

impl fmt::Display for Label {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.quoted {
            f.write_str(&text::quote(&self.text, '`'))?
        } else {
            f.write_str(&self.text)?
        }
        self.suffix.map_or(Ok(()), |n| write!(f, "'{n}"))
    }
}

/// Whether a name can stand without quotes: words with one blank between them.
fn is_bare(name: &str) -> bool {
    // Most names are one plain word.
    let plain = name.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_');
    if plain && name.starts_with(|c: char| c.is_ascii_alphabetic()) {
        return !RESERVED.contains(&name) && name != "inside";
    }
    let (tokens, faults) = lex(name);
    let Some((_, tokens)) = tokens.split_last() else { return false };
    let word = |(k, token): (usize, &super::lexer::Token<'_>)| match token.kind {
        Kind::Word => !RESERVED.contains(&token.text) && token.text != "inside",
        Kind::Number => k > 0 && token.text.bytes().all(|b| b.is_ascii_digit()),
        _ => false,
    };
    let joined: Vec<&str> = tokens.iter().map(|token| token.text).collect();
    faults.is_empty() && !tokens.is_empty() && tokens.iter().enumerate().all(word) && joined.join(" ") == name
}

/// A component's or port's name, in quotes where it needs them.
pub(super) fn name(name: &str) -> String {
    let made = MADE.contains(&name) || [TIME, "guid", "_"].contains(&name);
    if is_bare(name) && !made { name.to_owned() } else { text::quote(name, '`') }
}

/// An archive's name for something, in quotes unless it is one word.
pub(super) fn one_word(name: &str) -> String {
    let bare = is_bare(name) && !name.contains(' ');
    if bare { name.to_owned() } else { text::quote(name, '`') }
}

/// A label for each object. Of those with the same name the first in the order of the text has it, and the others get
/// a number.
pub(super) fn assign(objects: &[Object], order: &[usize]) -> Vec<Label> {
    let mut labels: Vec<Option<Label>> = vec![None; objects.len()];
    let mut used: HashMap<String, u32> = HashMap::new();
    for at in order {
        let Some(object) = objects.get(*at) else { continue };
        let mut label = stem(object);
        let n = used.entry(label.text.clone()).or_insert(0);
        *n += 1;
        label.suffix = (*n > 1).then_some(*n);
        if let Some(place) = labels.get_mut(*at) {
            *place = Some(label);
        }
    }
    labels
        .into_iter()
        .map(|label| label.unwrap_or(Label { text: String::new(), quoted: true, suffix: None }))
        .collect()
}

fn stem(object: &Object) -> Label {
    let nickname = &object.nickname;
    if !nickname.is_empty() {
        let quoted = nickname.starts_with('_') || !is_bare(nickname);
        return Label { text: nickname.clone(), quoted, suffix: None };
    }
    // A name of the text's own, after the component.
    let mut text = "_".to_owned();
    for c in object.name.chars().take(40) {
        if c.is_alphanumeric() {
            text.extend(c.to_lowercase());
        } else if !text.ends_with('_') {
            text.push('_');
        }
    }
    let text = text.trim_end_matches('_');
    let text = if text.is_empty() || !is_bare(text) { "_object" } else { text };
    Label { text: text.to_owned(), quoted: false, suffix: None }
}

#[cfg(test)]
mod tests {
    use super::name;

    #[test]
    fn names_need_quotes_only_where_they_would_be_misread() {
        for bare in ["A", "attractor x", "column 2", "2D", "Divide Domain²", "größe"] {
            assert_eq!(name(bare), bare);
        }
        for quoted in
            ["", "3", "a  b", " a", "C# Script", "true", "x else y", "A+B", "a.b", "point", "x\ny", "1e5"]
        {
            assert!(name(quoted).starts_with('`'), "{quoted}");
        }
    }
}
