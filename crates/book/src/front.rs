//! What stands between two lines of `---` at the head of a page.

use std::collections::BTreeMap;

use crate::fault::Fault;

/// The head of a page, and the line on which the text after it begins.
#[derive(Debug, Clone, Default)]
pub(crate) struct Front {
    pub(crate) values: BTreeMap<String, String>,
    /// How many lines the head takes.
    pub(crate) lines: usize,
}

impl Front {
    /// Reads the head; gives it with the text behind it.
    pub(crate) fn read<'a>(file: &str, text: &'a str) -> Result<(Self, &'a str), Fault> {
        let mut front = Self::default();
        let mut rest = text;
        let mut is_first = true;
        loop {
            let Some((line, after)) = rest.split_once('\n') else {
                return Err(Fault::new(file, 1, "a page begins with a head between two lines of ---"));
            };
            front.lines += 1;
            rest = after;
            let line = line.trim_end();
            match (is_first, line) {
                (true, "---") => is_first = false,
                (true, _) => {
                    return Err(Fault::new(file, 1, "a page begins with a head between two lines of ---"));
                }
                (false, "---") => return Ok((front, rest)),
                (false, "") => {}
                (false, line) => {
                    let Some((key, value)) = line.split_once(':') else {
                        let why = format!("'{line}' is not `key: value`");
                        return Err(Fault::new(file, front.lines, why));
                    };
                    front.values.insert(key.trim().to_owned(), value.trim().to_owned());
                }
            }
        }
    }

    /// A value that must be there.
    pub(crate) fn needed(&self, file: &str, key: &str) -> Result<String, Fault> {
        match self.values.get(key).filter(|value| !value.is_empty()) {
            Some(value) => Ok(value.clone()),
            None => Err(Fault::new(file, 1, format!("the head has no {key}"))),
        }
    }
}
