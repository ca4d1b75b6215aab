//! The keys of branches, in every spelling that clients have.

use katydid_data::Path;

/// The most numbers that a path may have. Grasshopper's own stay below ten.
const MOST_ELEMENTS: usize = 100;

/// Reads `{0;1}`, `0;1`, `{ 0; 1; }`: blanks and outer braces do not matter, nor does a semicolon too many.
///
/// # Errors
/// What is wrong with it: no number at all, a number below 0 or beyond 32 bits, too many of them.
pub(crate) fn parse(key: &str) -> Result<Path, String> {
    let wrong = |why: &str| format!("'{}' is no path of a branch such as {{0;1}}: {why}", shown(key));
    let mut inner = key.trim();
    inner = inner.strip_prefix('{').unwrap_or(inner);
    inner = inner.strip_suffix('}').unwrap_or(inner);
    let elements = inner.split(';').map(str::trim).filter(|element| !element.is_empty());
    let mut path = Vec::new();
    for element in elements {
        let number: i32 = element.parse().map_err(|_| wrong("it has to be made of whole numbers"))?;
        if number < 0 {
            return Err(wrong("its numbers begin at 0"));
        }
        if path.len() == MOST_ELEMENTS {
            return Err(wrong("it has too many numbers"));
        }
        path.push(number);
    }
    if path.is_empty() { Err(wrong("it has no number")) } else { Ok(Path::from(path.as_slice())) }
}

/// The beginning of a text, for messages.
pub(crate) fn shown(text: &str) -> String {
    const MOST: usize = 60;
    match text.char_indices().nth(MOST) {
        Some((at, _)) => format!("{}…", text.get(..at).unwrap_or_default()),
        None => text.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_spelling_is_read() {
        for key in ["0;1", "{0;1}", "{ 0; 1; }", " {0 ;1} ", "{;0;;1;}", "0;1}"] {
            assert_eq!(parse(key), Ok(Path::from([0, 1])), "{key}");
        }
        assert_eq!(parse("0"), Ok(Path::zero()));
    }

    #[test]
    fn what_is_no_path_is_refused() {
        let long = format!("{{{}}}", vec!["0"; 10_000].join(";"));
        for key in
            ["{}", "", " ", ";", "{-1}", "{99999999999}", "0;a", "{0}{1}", "{{0}}", "0,1", "1.5", &long]
        {
            assert!(parse(key).is_err(), "{key}");
        }
        assert!(parse(&long).unwrap_err().len() < 200);
    }
}
