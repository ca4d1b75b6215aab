//! Offsets: the way from an item of a tree to its partner, `{0;+1}[-1]`.

use katydid_component::Message;
use katydid_data::Path;

/// An offset that was read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Offset {
    /// What is added to the last elements of the path.
    pub(super) path: Vec<i32>,
    /// What is added to the index of the item.
    pub(super) item: i32,
}

impl Offset {
    /// Reads an offset: signed integers for the last path elements in braces, one for the index in brackets.
    /// Either part may be missing.
    ///
    /// # Errors
    /// With the text, when it is no offset.
    pub(super) fn parse(text: &str) -> Result<Self, Message> {
        Self::read(text.trim()).ok_or_else(|| {
            let text: String = text.chars().take(80).collect();
            Message::error(format!("'{text}' is no offset such as {{0;+1}}[-1]"))
        })
    }

    fn read(text: &str) -> Option<Self> {
        // A sign may stand apart from its digits.
        let integer = |text: &str| text.split_whitespace().collect::<String>().parse::<i32>().ok();
        let (path, item) = match text.split_once('[') {
            Some((path, item)) => (path.trim(), integer(item.trim().strip_suffix(']')?)?),
            None => (text, 0),
        };
        if path.is_empty() {
            return text.contains('[').then_some(Self { path: Vec::new(), item });
        }
        let inner = match path.strip_prefix('{') {
            Some(rest) => rest.strip_suffix('}')?,
            None => path,
        };
        let path = inner.split(';').map(integer).collect::<Option<Vec<i32>>>()?;
        Some(Self { path, item })
    }

    /// The path of the partner; `None` when the path has fewer elements than the offset, or a sum is no integer.
    pub(super) fn apply(&self, path: &Path) -> Option<Vec<i32>> {
        let mut elements = path.elements().to_vec();
        let first = elements.len().checked_sub(self.path.len())?;
        for (element, by) in elements.iter_mut().skip(first).zip(&self.path) {
            *element = element.checked_add(*by)?;
        }
        Some(elements)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn offsets_are_read() {
        for (text, path, item) in [
            ("{+1}[+1]", &[1][..], 1),
            ("{0}[+1]", &[0], 1),
            ("{0;+1}[0]", &[0, 1], 0),
            (" { 1 ; - 2 } [ -3 ] ", &[1, -2], -3),
            ("{-1}", &[-1], 0),
            ("[2]", &[], 2),
        ] {
            assert_eq!(Offset::parse(text).unwrap(), Offset { path: path.to_vec(), item }, "{text}");
        }
        for text in ["", "{", "{a}", "{1}[", "{1}[x]", "{}[1]", "[]", "{1;}"] {
            assert!(Offset::parse(text).is_err(), "{text}");
        }
    }

    #[test]
    fn offsets_move_the_last_elements() {
        let apply = |text: &str, path: &[i32]| Offset::parse(text).unwrap().apply(&Path::from(path));
        assert_eq!(apply("{+1}", &[0, 0, 5]), Some(vec![0, 0, 6]));
        assert_eq!(apply("{1;-1}", &[4, 5]), Some(vec![5, 4]));
        assert_eq!(apply("{1;1}", &[4]), None);
        assert_eq!(apply("{1}", &[i32::MAX]), None);
    }
}
