//! Patterns with wildcards, as the `Like` operator of Visual Basic has them.

use katydid_component::Message;

/// One place of a pattern.
#[derive(Debug, Clone, PartialEq)]
enum Place {
    /// `*`: any run of characters, or none.
    Any,
    /// `?`: one character.
    One,
    /// `#`: one digit.
    Digit,
    /// `[a-z]`, or `[!a-z]` for none of them.
    Set { none: bool, ranges: Vec<(char, char)> },
    /// A character that stands for itself.
    Character(char),
}

/// How often a long search asks whether it may go on.
const CHECK_EVERY: usize = 1 << 20;

/// A pattern, which fits a whole text or not.
#[derive(Debug)]
pub(super) struct Pattern {
    places: Vec<Place>,
    case: bool,
}

/// A character with its capital taken off.
fn small(c: char) -> char {
    let mut lower = c.to_lowercase();
    match (lower.len(), lower.next()) {
        (1, Some(lower)) => lower,
        _ => c,
    }
}

impl Pattern {
    /// Reads a pattern. With `case`, capital and small letters differ. A `[` without its `]` stands for itself.
    pub(super) fn new(text: &str, case: bool) -> Self {
        let fold = |c| if case { c } else { small(c) };
        let characters: Vec<char> = text.chars().map(fold).collect();
        let mut places = Vec::new();
        let mut rest = characters.as_slice();
        while let [c, tail @ ..] = rest {
            rest = tail;
            places.push(match c {
                // Several in a row are one.
                '*' if places.last() == Some(&Place::Any) => continue,
                '*' => Place::Any,
                '?' => Place::One,
                '#' => Place::Digit,
                '[' => match tail.iter().position(|c| *c == ']') {
                    Some(end) => {
                        rest = tail.get(end + 1..).unwrap_or_default();
                        set(tail.get(..end).unwrap_or_default())
                    }
                    None => Place::Character('['),
                },
                c => Place::Character(*c),
            });
        }
        Self { places, case }
    }

    /// Whether it fits the whole of `text`. `check` is asked now and then whether to go on.
    ///
    /// # Errors
    /// What `check` says.
    pub(super) fn fits(&self, text: &str, check: impl Fn() -> Result<(), Message>) -> Result<bool, Message> {
        let fold = |c| if self.case { c } else { small(c) };
        let text: Vec<char> = text.chars().map(fold).collect();
        let (mut at, mut place) = (0, 0);
        // After the last `*`: where the pattern goes on, and up to where the `*` has swallowed the text.
        let mut star: Option<(usize, usize)> = None;
        let mut steps = 0usize;
        while let Some(c) = text.get(at) {
            steps += 1;
            if steps.is_multiple_of(CHECK_EVERY) {
                check()?;
            }
            match self.places.get(place) {
                Some(Place::Any) => {
                    place += 1;
                    star = Some((place, at));
                }
                Some(p) if p.holds(*c) => {
                    place += 1;
                    at += 1;
                }
                _ => match &mut star {
                    Some((behind, swallowed)) => {
                        *swallowed += 1;
                        (place, at) = (*behind, *swallowed);
                    }
                    None => return Ok(false),
                },
            }
        }
        Ok(self.places.get(place..).is_some_and(|rest| rest.iter().all(|p| *p == Place::Any)))
    }
}

/// The characters between `[` and `]`.
fn set(inside: &[char]) -> Place {
    let (none, mut rest) = match inside {
        ['!', rest @ ..] => (true, rest),
        all => (false, all),
    };
    let mut ranges = Vec::new();
    while let [first, tail @ ..] = rest {
        (rest, _) = match tail {
            ['-', last, tail @ ..] => (tail, ranges.push((*first, *last))),
            tail => (tail, ranges.push((*first, *first))),
        };
    }
    Place::Set { none, ranges }
}

impl Place {
    fn holds(&self, c: char) -> bool {
        match self {
            Self::Any => false,
            Self::One => true,
            Self::Digit => c.is_ascii_digit(),
            Self::Set { none, ranges } => ranges.iter().any(|(a, b)| (*a..=*b).contains(&c)) != *none,
            Self::Character(own) => *own == c,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fits(pattern: &str, text: &str) -> bool {
        Pattern::new(pattern, true).fits(text, || Ok(())).unwrap()
    }

    #[test]
    fn wildcards() {
        for (pattern, text) in [
            ("", ""),
            ("*", ""),
            ("**", "abc"),
            ("a*c", "abbc"),
            ("a*c", "acbc"),
            ("?b?", "abc"),
            ("*open space*", "the open space here"),
            ("Configuration changed *", "Configuration changed by hand"),
            ("/*", "/home"),
            ("v#.#", "v1.2"),
            ("[a-cx]z", "xz"),
            ("[!a-c]", "d"),
            ("a[b", "a[b"),
            ("[-]", "-"),
        ] {
            assert!(fits(pattern, text), "{pattern} {text}");
        }
        for (pattern, text) in [
            ("", "a"),
            ("a", ""),
            ("a*c", "ab"),
            ("?", ""),
            ("#", "x"),
            ("[a-c]", "d"),
            ("[!a-c]", "b"),
            ("Box", "a Box"),
        ] {
            assert!(!fits(pattern, text), "{pattern} {text}");
        }
        assert!(Pattern::new("ÄB*", false).fits("äbC", || Ok(())).unwrap());
    }

    #[test]
    fn a_hostile_pattern_asks_whether_to_go_on() {
        let stop = || Err(Message::error("stop"));
        assert!(
            Pattern::new(&"*a".repeat(500), true).fits(&"a".repeat(400), || Ok(())).is_ok_and(|fit| !fit)
        );
        let long = Pattern::new("*aaaaaaaaaaaaaaaaab", true).fits(&"a".repeat(200_000), stop);
        assert_eq!(long, Err(Message::error("stop")));
    }
}
