//! The order of texts in the invariant culture: letters by the alphabet whatever their case, small ones first among
//! equals, digits before letters and signs before digits; `-` and `'` count last of all.

use std::cmp::Ordering;

/// A weight of the first level: what kind of character, and where in it.
fn weight(unit: u16) -> (u8, u32) {
    const SIGNS: &str = "_-,;:!?./'\"()[]{}@*\\&#%`^+<=>|~$";
    let c = char::from_u32(unit.into()).unwrap_or('\u{fffd}');
    if c.is_whitespace() {
        return (0, unit.into());
    }
    if c.is_ascii_digit() {
        return (2, unit.into());
    }
    if c.is_alphabetic() {
        let lower = c.to_lowercase().next().unwrap_or(c);
        return (3, base(lower) as u32 * 4);
    }
    (1, SIGNS.find(c).map_or(1000 + u32::from(unit), |i| i as u32))
}

/// A Latin letter without its accent.
fn base(c: char) -> char {
    match c {
        'à'..='å' => 'a',
        'ç' => 'c',
        'è'..='ë' => 'e',
        'ì'..='ï' => 'i',
        'ñ' => 'n',
        'ò'..='ö' | 'ø' => 'o',
        'ù'..='ü' => 'u',
        'ý' | 'ÿ' => 'y',
        other => other,
    }
}

/// `-` and `'` are looked at only when nothing else tells two texts apart.
fn is_ignored(unit: &u16) -> bool {
    matches!(*unit, 0x2d | 0x27)
}

/// Compares two texts.
pub(super) fn compare(a: &[u16], b: &[u16], ignore_case: bool) -> Ordering {
    let main = |s: &[u16]| s.iter().filter(|u| !is_ignored(u)).map(|u| weight(*u)).collect::<Vec<_>>();
    let first = main(a).cmp(&main(b));
    if first != Ordering::Equal {
        return first;
    }
    let accent = |s: &[u16]| {
        s.iter()
            .filter(|u| !is_ignored(u))
            .map(|u| {
                char::from_u32((*u).into()).map_or(0, |c| {
                    let lower = c.to_lowercase().next().unwrap_or(c);
                    if base(lower) == lower { 0 } else { lower as u32 }
                })
            })
            .collect::<Vec<_>>()
    };
    let second = accent(a).cmp(&accent(b));
    if second != Ordering::Equal {
        return second;
    }
    if !ignore_case {
        let case = |s: &[u16]| {
            s.iter()
                .filter(|u| !is_ignored(u))
                .map(|u| char::from_u32((*u).into()).is_some_and(char::is_uppercase))
                .collect::<Vec<_>>()
        };
        let third = case(a).cmp(&case(b));
        if third != Ordering::Equal {
            return third;
        }
    }
    // The text whose sign comes later is less.
    let signs = |s: &[u16]| {
        s.iter().enumerate().filter(|(_, u)| is_ignored(u)).map(|(i, u)| (i, *u)).collect::<Vec<_>>()
    };
    signs(a).len().cmp(&signs(b).len()).then_with(|| signs(a).cmp(&signs(b)))
}
