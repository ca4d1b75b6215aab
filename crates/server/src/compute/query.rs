//! What stands behind the question mark of an address.

/// Names and values, unpacked.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(crate) struct Query(Vec<(String, String)>);

impl Query {
    pub(crate) fn read(text: &str) -> Self {
        let pairs = text.split('&').filter(|pair| !pair.is_empty());
        Self(
            pairs
                .map(|pair| {
                    let (name, value) = pair.split_once('=').unwrap_or((pair, ""));
                    (unpacked(name), unpacked(value))
                })
                .collect(),
        )
    }

    /// The first value of that name, in whatever case the name is written.
    pub(crate) fn get(&self, name: &str) -> Option<&str> {
        self.0.iter().find(|(own, _)| own.eq_ignore_ascii_case(name)).map(|(_, value)| value.as_str())
    }

    /// Names and values as they came.
    pub(crate) fn pairs(&self) -> impl Iterator<Item = (&str, &str)> {
        self.0.iter().map(|(name, value)| (name.as_str(), value.as_str()))
    }
}

/// A text out of the form that addresses have. What is no such form stands for itself.
fn unpacked(text: &str) -> String {
    let bytes = text.as_bytes();
    let mut out = Vec::with_capacity(bytes.len());
    let mut at = 0;
    while let Some(&byte) = bytes.get(at) {
        let digit = |at: usize| char::from(*bytes.get(at)?).to_digit(16);
        match (byte, digit(at + 1).zip(digit(at + 2))) {
            (b'%', Some((high, low))) => {
                out.push((high * 16 + low) as u8);
                at += 2;
            }
            (b'+', _) => out.push(b' '),
            _ => out.push(byte),
        }
        at += 1;
    }
    String::from_utf8_lossy(&out).into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_in_any_case_and_values_unpacked() {
        let query = Query::read("Pointer=http%3A%2F%2Fa%2Fb+c%zz%&x&&=1&y=%E6%BC%A2%ff");
        assert_eq!(query.get("pointer"), Some("http://a/b c%zz%"));
        assert_eq!((query.get("X"), query.get("none")), (Some(""), None));
        assert_eq!(query.get("y"), Some("漢\u{fffd}"));
        assert_eq!(Query::read("%+1=a").get("% 1"), Some("a"));
    }
}
