//! The words of the interface.

use std::collections::BTreeMap;

use crate::fault::{Fault, Faults};
use crate::files::Files;

const ENGLISH: &str = include_str!("../assets/words.txt");

/// The words of one language, by their keys.
#[derive(Debug, Clone)]
pub(crate) struct Words(BTreeMap<String, String>);

impl Words {
    /// Those of the book's own language: the English ones, or what `words.txt` in the given folder says instead.
    pub(crate) fn read(files: &Files, folder: &str, faults: &mut Faults) -> Self {
        let mut words =
            Self(pairs(ENGLISH).map(|(key, word, _)| (key.to_owned(), word.to_owned())).collect());
        let path = if folder.is_empty() { "words.txt".to_owned() } else { format!("{folder}/words.txt") };
        let Some(text) = files.text(&path) else { return words };
        let Some(text) = faults.keep(text.map_err(|why| Fault::new(&path, 0, why))) else { return words };
        for (key, word, line) in pairs(text) {
            if words.0.insert(key.to_owned(), word.to_owned()).is_none() {
                faults.add(&path, line, format!("there is no word '{key}'"));
            }
        }
        words
    }

    pub(crate) fn get(&self, key: &'static str) -> &str {
        self.0.get(key).map_or(key, String::as_str)
    }

    /// All of them, for the page's script.
    pub(crate) fn to_json(&self) -> serde_json::Value {
        serde_json::json!(self.0)
    }
}

fn pairs(text: &str) -> impl Iterator<Item = (&str, &str, usize)> {
    text.lines().enumerate().filter_map(|(line, text)| {
        let (key, word) = text.split_once('=')?;
        Some((key.trim(), word.trim(), line + 1))
    })
}
