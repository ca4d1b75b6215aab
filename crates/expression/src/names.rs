//! Constants, and the nearest known name to a mistyped one.

use crate::Variant;

/// The golden ratio, (1 + √5)/2.
const GOLDEN_RATIO: f64 = 1.618_033_988_749_895;

/// The names that stand for a value unless a variable hides them.
const CONSTANTS: [&str; 7] = ["pi", "π", "e", "phi", "φ", "null", "nothing"];

/// The value of a constant; the name in lower case.
pub(crate) fn constant(name: &str) -> Option<Variant> {
    Some(match name {
        "pi" | "π" => Variant::Number(std::f64::consts::PI),
        "e" => Variant::Number(std::f64::consts::E),
        "phi" | "φ" => Variant::Number(GOLDEN_RATIO),
        "null" | "nothing" => Variant::Null,
        _ => return None,
    })
}

/// The constants' names.
pub(crate) fn constants<'a>() -> impl Iterator<Item = &'a str> {
    CONSTANTS.into_iter()
}

/// The candidate with the fewest typing mistakes between, if few enough: one in short names, two in longer ones.
pub(crate) fn nearest<'a>(name: &str, candidates: impl Iterator<Item = &'a str>) -> Option<String> {
    let typed: Vec<char> = crate::lexer::lower_case(name).chars().collect();
    let allowed = match typed.len() {
        0 | 1 => return None,
        2..=4 => 1,
        5..=40 => 2,
        _ => return None,
    };
    candidates
        .map(|c| (distance(&typed, &crate::lexer::lower_case(c)), c))
        .filter(|(mistakes, _)| *mistakes <= allowed)
        .min_by_key(|(mistakes, c)| (*mistakes, c.len()))
        .map(|(_, c)| crate::lexer::lower_case(c))
}

/// Levenshtein's distance, with a swap of neighbours counted once (optimal string alignment).
fn distance(a: &[char], b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut two_back: Vec<usize> = Vec::new();
    let mut last: Vec<usize> = (0..=b.len()).collect();
    for (i, &ca) in a.iter().enumerate() {
        let mut row = Vec::with_capacity(last.len());
        row.push(i + 1);
        for (j, &cb) in b.iter().enumerate() {
            let cell = |r: &Vec<usize>, k: usize| r.get(k).copied().unwrap_or(usize::MAX / 2);
            let mut best = (cell(&last, j) + usize::from(ca != cb)).min(cell(&last, j + 1) + 1);
            best = best.min(cell(&row, j) + 1);
            if i > 0 && j > 0 && a.get(i - 1) == Some(&cb) && b.get(j - 1) == Some(&ca) {
                best = best.min(cell(&two_back, j - 1) + 1);
            }
            row.push(best);
        }
        two_back = std::mem::replace(&mut last, row);
    }
    last.last().copied().unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_name() {
        let names = ["sin", "sinh", "cos", "Floor"];
        assert_eq!(nearest("sinn", names.into_iter()).as_deref(), Some("sin"));
        assert_eq!(nearest("csoh", names.into_iter()), None);
        assert_eq!(nearest("FLOR", names.into_iter()).as_deref(), Some("floor"));
        assert_eq!(nearest("ocs", names.into_iter()).as_deref(), Some("cos"));
        assert_eq!(nearest("q", names.into_iter()), None);
    }
}
