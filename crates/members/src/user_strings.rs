//! User strings: texts by key that geometry carries along.

use std::sync::Arc;

use crate::Fault;

/// The most user strings of one object.
const MOST: usize = 100_000;

/// The texts that an object carries, in the order in which they were set. No key stands twice. Copies share them.
///
/// What was never given any is told apart from what has none any more: a result without strings of its own leaves those of
/// the object that it replaces.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct UserStrings(Option<Arc<Vec<(String, String)>>>);

impl UserStrings {
    /// The pairs of a key and a text.
    pub fn pairs(&self) -> &[(String, String)] {
        self.0.as_deref().map_or(&[], Vec::as_slice)
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.pairs().is_empty()
    }

    /// Whether strings were ever set: also where all were deleted since.
    pub(crate) fn is_known(&self) -> bool {
        self.0.is_some()
    }

    /// The text of a key.
    pub fn get(&self, key: &str) -> Option<&str> {
        self.pairs().iter().find_map(|(own, text)| (own == key).then_some(text.as_str()))
    }

    /// Puts a text under a key, in the place of what was there.
    ///
    /// # Errors
    /// The object has too many.
    pub(crate) fn set(&mut self, key: &str, text: String) -> Result<(), Fault> {
        let pairs = self.changed();
        if let Some((_, old)) = pairs.iter_mut().find(|(own, _)| own == key) {
            *old = text;
            return Ok(());
        }
        if pairs.len() >= MOST {
            return Err(Fault::too_large(format!("an object has more than {MOST} user strings")));
        }
        pairs.push((key.to_owned(), text));
        Ok(())
    }

    /// Takes a key out; whether it was there.
    pub(crate) fn remove(&mut self, key: &str) -> bool {
        let pairs = self.changed();
        let before = pairs.len();
        pairs.retain(|(own, _)| own != key);
        pairs.len() < before
    }

    /// Takes all of them out.
    pub(crate) fn clear(&mut self) {
        self.changed().clear();
    }

    fn changed(&mut self) -> &mut Vec<(String, String)> {
        Arc::make_mut(self.0.get_or_insert_default())
    }
}

impl FromIterator<(String, String)> for UserStrings {
    /// Of pairs whose keys differ.
    fn from_iter<I: IntoIterator<Item = (String, String)>>(pairs: I) -> Self {
        Self(Some(Arc::new(pairs.into_iter().collect())))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_key_stands_once_and_copies_are_apart() {
        let mut strings = UserStrings::default();
        assert!(strings.is_empty() && !strings.is_known());
        assert!(strings.set("a", "1".into()).is_ok() && strings.set("b", "2".into()).is_ok());
        let copy = strings.clone();
        assert!(strings.set("a", "3".into()).is_ok());
        assert_eq!((strings.get("a"), copy.get("a")), (Some("3"), Some("1")));
        assert_eq!(strings.pairs().len(), 2);
        assert!(strings.remove("a") && !strings.remove("a"));
        strings.clear();
        assert!(strings.is_empty() && strings.is_known());
    }
}
