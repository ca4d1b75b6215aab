//! Blocks of `key: value` lines.

use crate::fault::Fault;

/// A value with its line in the file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Entry {
    pub(crate) key: String,
    pub(crate) value: String,
    pub(crate) line: usize,
}

/// The lines of a block.
#[derive(Debug, Clone)]
pub(crate) struct Block {
    pub(crate) file: String,
    /// The line of its fence.
    pub(crate) line: usize,
    entries: Vec<Entry>,
}

impl Block {
    /// Reads the text between the fences; `line` is that of the first fence. Keys must be among `known`.
    pub(crate) fn read(file: &str, line: usize, text: &str, known: &[&str]) -> Result<Self, Fault> {
        let mut entries: Vec<Entry> = Vec::new();
        for (offset, text) in text.lines().enumerate() {
            let at = line + 1 + offset;
            if text.trim().is_empty() {
                continue;
            }
            if text.starts_with([' ', '\t']) {
                let Some(last) = entries.last_mut() else {
                    return Err(Fault::new(
                        file,
                        at,
                        "a line that begins with blanks goes on with the line before it",
                    ));
                };
                last.value.push('\n');
                last.value.push_str(text.trim());
                continue;
            }
            let Some((key, value)) = text.split_once(':') else {
                return Err(Fault::new(file, at, format!("'{text}' is not `key: value`")));
            };
            let key = key.trim();
            if !known.contains(&key) {
                let why = format!("there is no key '{key}' here: known are {}", known.join(", "));
                return Err(Fault::new(file, at, why));
            }
            if key != "check" && entries.iter().any(|entry| entry.key == key) {
                return Err(Fault::new(file, at, format!("'{key}' is said twice")));
            }
            entries.push(Entry { key: key.to_owned(), value: value.trim().to_owned(), line: at });
        }
        Ok(Self { file: file.to_owned(), line, entries })
    }

    pub(crate) fn get(&self, key: &str) -> Option<&str> {
        self.entries.iter().find(|entry| entry.key == key).map(|entry| entry.value.as_str())
    }

    pub(crate) fn all<'a>(&'a self, key: &'a str) -> impl Iterator<Item = &'a Entry> {
        self.entries.iter().filter(move |entry| entry.key == key)
    }

    /// The line of a key, or that of the block.
    pub(crate) fn line_of(&self, key: &str) -> usize {
        self.all(key).next().map_or(self.line, |entry| entry.line)
    }

    pub(crate) fn needed(&self, key: &str) -> Result<&str, Fault> {
        self.get(key)
            .filter(|value| !value.is_empty())
            .ok_or_else(|| self.fault(key, format!("it has no {key}")))
    }

    pub(crate) fn fault(&self, key: &str, text: impl Into<String>) -> Fault {
        Fault::new(&self.file, self.line_of(key), text)
    }

    /// The parts of a list with commas between them; commas in brackets divide nothing.
    pub(crate) fn list(&self, key: &str) -> Vec<String> {
        self.get(key).map(parts).unwrap_or_default()
    }

    /// The words of this block in place of those of the other, and all else of the other: a page in another language.
    pub(crate) fn over(&self, other: &Self, words: &[&str]) -> Self {
        let is_own = |key: &str| words.contains(&key);
        let own = self.entries.iter().filter(|entry| is_own(&entry.key));
        let rest =
            other.entries.iter().filter(|entry| !(is_own(&entry.key) && self.get(&entry.key).is_some()));
        Self { file: self.file.clone(), line: self.line, entries: own.chain(rest).cloned().collect() }
    }
}

/// The parts between commas that stand in no brackets.
pub(crate) fn parts(text: &str) -> Vec<String> {
    let (mut depth, mut part, mut all) = (0_usize, String::new(), Vec::new());
    for c in text.chars() {
        match c {
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth = depth.saturating_sub(1),
            ',' if depth == 0 => {
                all.push(std::mem::take(&mut part));
                continue;
            }
            _ => {}
        }
        part.push(if c == '\n' { ' ' } else { c });
    }
    all.push(part);
    all.into_iter().map(|part| part.trim().to_owned()).filter(|part| !part.is_empty()).collect()
}
