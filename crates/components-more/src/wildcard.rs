//! Patterns of names.

/// Whether a pattern takes a text: `*` stands for any text, `?` for one character; capitals do not matter. The last star is
/// stretched until the rest fits, in O(n m) for a pattern of n characters and a text of m.
pub(crate) fn takes(pattern: &str, text: &str) -> bool {
    let small = |text: &str| text.chars().flat_map(char::to_lowercase).collect::<Vec<char>>();
    let (pattern, text) = (small(pattern), small(text));
    let (mut p, mut t) = (0, 0);
    // Where to go on in pattern and text when what follows the last star does not fit.
    let mut star: Option<(usize, usize)> = None;
    while t < text.len() {
        match pattern.get(p) {
            Some('*') => {
                star = Some((p + 1, t));
                p += 1;
            }
            Some(c) if *c == '?' || text.get(t) == Some(c) => {
                p += 1;
                t += 1;
            }
            _ => {
                let Some((after, from)) = star else { return false };
                star = Some((after, from + 1));
                (p, t) = (after, from + 1);
            }
        }
    }
    pattern.get(p..).is_some_and(|rest| rest.iter().all(|c| *c == '*'))
}

#[cfg(test)]
mod tests {
    use super::takes;

    #[test]
    fn patterns() {
        for (pattern, text, wanted) in [
            ("Walls", "walls", true),
            ("W*s", "Walls", true),
            ("W?lls", "Walls", true),
            ("W?ls", "Walls", false),
            ("*", "", true),
            ("", "a", false),
            ("*a*b", "xaxbxb", true),
            ("*a*b", "xaxbxc", false),
        ] {
            assert_eq!(takes(pattern, text), wanted, "{pattern} {text}");
        }
    }
}
