use std::cmp::Ordering;
use std::fmt;
use std::str::FromStr;

use smallvec::SmallVec;

/// The address of a branch: a list of integers, written `{0;1;2}`.
///
/// Paths order element by element, and a path stands before every longer one that it begins.
#[derive(Debug, Clone, PartialEq, Eq, Hash, Default)]
pub struct Path(SmallVec<[i32; 4]>);

impl Path {
    /// `{0}`, where a single list lives.
    pub fn zero() -> Self {
        Self::from([0])
    }

    /// The integers of the path.
    pub fn elements(&self) -> &[i32] {
        &self.0
    }

    /// This path with one more element at its end.
    #[must_use]
    pub fn child(&self, index: usize) -> Self {
        let mut elements = self.0.clone();
        elements.push(i32::try_from(index).unwrap_or(i32::MAX));
        Self(elements)
    }

    /// This path without its last element.
    #[must_use]
    pub fn parent(&self) -> Self {
        let mut elements = self.0.clone();
        elements.pop();
        Self(elements)
    }

    /// The number of elements.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether the path has no elements; written `{}`.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

impl<const N: usize> From<[i32; N]> for Path {
    fn from(elements: [i32; N]) -> Self {
        Self(SmallVec::from_slice(&elements))
    }
}

impl From<&[i32]> for Path {
    fn from(elements: &[i32]) -> Self {
        Self(SmallVec::from_slice(elements))
    }
}

impl FromIterator<i32> for Path {
    fn from_iter<I: IntoIterator<Item = i32>>(iter: I) -> Self {
        Self(iter.into_iter().collect())
    }
}

impl PartialOrd for Path {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Path {
    fn cmp(&self, other: &Self) -> Ordering {
        self.elements().cmp(other.elements())
    }
}

impl fmt::Display for Path {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("{")?;
        for (i, element) in self.0.iter().enumerate() {
            if i > 0 {
                f.write_str(";")?;
            }
            write!(f, "{element}")?;
        }
        f.write_str("}")
    }
}

/// A text that is no path.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("'{0}' is not a path such as {{0;1}}")]
pub struct ParsePathError(String);

impl FromStr for Path {
    type Err = ParsePathError;

    /// Reads `{0;1}`, with blanks anywhere and the braces optional (`88` is `{88}`).
    fn from_str(text: &str) -> Result<Self, ParsePathError> {
        let error = || ParsePathError(text.chars().take(80).collect());
        let trimmed = text.trim();
        let inner = match trimmed.strip_prefix('{') {
            Some(rest) => rest.strip_suffix('}').ok_or_else(error)?,
            None => trimmed,
        };
        if inner.trim().is_empty() {
            return if trimmed.starts_with('{') { Ok(Self::default()) } else { Err(error()) };
        }
        inner.split(';').map(|e| e.trim().parse::<i32>().map_err(|_| error())).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_are_written_and_read() {
        for (text, path) in [
            ("{0;0;17}", Path::from([0, 0, 17])),
            (" { 1 ; -2 } ", Path::from([1, -2])),
            ("88", Path::from([88])),
        ] {
            assert_eq!(text.parse::<Path>().unwrap(), path);
        }
        assert_eq!(Path::from([0, 1]).to_string(), "{0;1}");
        for bad in ["", "{", "{0", "{a}", "0;", "{0,1}"] {
            assert!(bad.parse::<Path>().is_err(), "{bad}");
        }
    }

    #[test]
    fn a_shorter_path_stands_before_the_longer_it_begins() {
        assert!(Path::from([0]) < Path::from([0, 0]));
        assert!(Path::from([0, 9]) < Path::from([1]));
        assert!(Path::from([0, 2]) < Path::from([0, 10]));
    }
}
