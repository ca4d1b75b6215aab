use std::fmt;

/// What is wrong at one place of a text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Problem {
    /// The line, from 1.
    pub line: usize,
    /// The column in characters, from 1.
    pub column: usize,
    /// What is wrong, and what was expected.
    pub message: String,
    /// What may help: the nearest name, the ports there are.
    pub hint: Option<String>,
    /// The line, cut to a readable length.
    pub quoted: String,
    /// How many blanks stand before the caret under [`quoted`](Self::quoted).
    pub caret: usize,
    /// How many characters are marked.
    pub width: usize,
}

/// Why a text could not be read: everything that is wrong with it, in the order of the text.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub struct Problems {
    /// The problems; at least one.
    pub list: Vec<Problem>,
}

/// A problem before line and column are counted.
#[derive(Debug, Clone)]
pub(super) struct Fault {
    /// Where in the text, in bytes.
    pub(super) at: usize,
    /// How many bytes are meant.
    pub(super) len: usize,
    pub(super) message: String,
    pub(super) hint: Option<String>,
}

/// No more problems than this are told: after so many the text is something else.
const MOST: usize = 50;
/// The longest part of a line that is quoted, in characters.
const WIDEST: usize = 100;

impl Fault {
    pub(super) fn new(at: usize, len: usize, message: impl Into<String>) -> Self {
        Self { at, len, message: message.into(), hint: None }
    }

    pub(super) fn hint(mut self, hint: impl Into<String>) -> Self {
        self.hint = Some(hint.into());
        self
    }
}

impl Problems {
    /// Counts lines and columns. There must be at least one fault.
    pub(super) fn of(text: &str, mut faults: Vec<Fault>) -> Self {
        faults.sort_by_key(|fault| fault.at);
        faults.dedup_by(|a, b| a.at == b.at && a.message == b.message);
        let mut list = Vec::new();
        let (mut line, mut start, mut from) = (1, 0, 0);
        for fault in faults.iter().take(MOST) {
            let at = floor(text, fault.at);
            for (k, _) in text.get(from..at).unwrap_or_default().match_indices('\n') {
                line += 1;
                start = from + k + 1;
            }
            from = at;
            list.push(problem(text, fault, line, start, at));
        }
        Self { list }
    }
}

fn problem(text: &str, fault: &Fault, line: usize, start: usize, at: usize) -> Problem {
    let before: Vec<char> = text.get(start..at).unwrap_or_default().chars().collect();
    let rest = text.get(at..).unwrap_or_default();
    let rest = rest.split(['\n', '\r']).next().unwrap_or_default();
    // A caret far to the right of a long line: only what stands near it is quoted.
    let skipped = before.len().saturating_sub(WIDEST - 30);
    let shown = before.iter().copied().skip(skipped).chain(rest.chars()).take(WIDEST);
    let quoted: String = shown.map(|c| if c.is_control() { ' ' } else { c }).collect();
    let quoted = quoted.trim_end().to_owned();
    let end = floor(text, at.saturating_add(fault.len));
    let marked = text.get(at..end).unwrap_or_default().split('\n').next().unwrap_or_default();
    let caret = before.len() - skipped;
    Problem {
        line,
        column: before.len() + 1,
        message: fault.message.clone(),
        hint: fault.hint.clone(),
        quoted,
        caret,
        width: marked.trim_end().chars().count().clamp(1, WIDEST.saturating_sub(caret).max(1)),
    }
}

/// The start of the character that this byte belongs to.
fn floor(text: &str, at: usize) -> usize {
    let mut at = at.min(text.len());
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "line {}, column {}: {}", self.line, self.column, self.message)?;
        let number = self.line.to_string();
        writeln!(f, "  {number} | {}", self.quoted)?;
        let blanks = " ".repeat(number.len());
        write!(f, "  {blanks} | {}{}", " ".repeat(self.caret), "^".repeat(self.width))?;
        match &self.hint {
            Some(hint) => write!(f, " {hint}"),
            None => Ok(()),
        }
    }
}

impl fmt::Display for Problems {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (k, problem) in self.list.iter().enumerate() {
            if k > 0 {
                writeln!(f)?;
            }
            write!(f, "{problem}")?;
        }
        Ok(())
    }
}

/// The name among these that looks most like `name`, where one comes near enough to be meant.
pub(super) fn nearest<'a>(name: &str, names: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let wanted: Vec<char> = name.to_lowercase().chars().take(60).collect();
    let most = (wanted.len() / 3).max(1);
    names
        .into_iter()
        .filter_map(|other| {
            let letters: Vec<char> = other.to_lowercase().chars().take(60).collect();
            let d = distance(&wanted, &letters);
            (d <= most).then_some((d, other))
        })
        .min_by_key(|(d, _)| *d)
        .map(|(_, other)| other)
}

/// The number of letters to add, remove, replace or swap with a neighbour (optimal string alignment).
fn distance(a: &[char], b: &[char]) -> usize {
    let mut rows = [vec![0; b.len() + 1], (0..=b.len()).collect::<Vec<_>>(), vec![0; b.len() + 1]];
    for (i, x) in a.iter().enumerate() {
        let [before, last, row] = &mut rows;
        row.clear();
        row.push(i + 1);
        for (j, y) in b.iter().enumerate() {
            let at = |row: &[usize], j: usize| row.get(j).copied().unwrap_or(usize::MAX / 2);
            let mut d = (at(last, j) + usize::from(x != y)).min(at(last, j + 1) + 1).min(at(row, j) + 1);
            let swapped = i > 0 && j > 0 && a.get(i - 1) == Some(y) && b.get(j - 1) == Some(x);
            if swapped {
                d = d.min(at(before, j - 1) + 1);
            }
            row.push(d);
        }
        rows.rotate_left(1);
    }
    let [_, last, _] = &rows;
    last.last().copied().unwrap_or(usize::MAX)
}

#[cfg(test)]
mod tests {
    use super::{Fault, Problems, nearest};

    #[test]
    fn the_caret_stands_under_the_word() {
        let text = "katydid 1\n  é = Mvoe(A)\n";
        let at = text.find("Mvoe").unwrap_or(0);
        let problems = Problems::of(text, vec![Fault::new(at, 4, "no such component").hint("Move?")]);
        assert_eq!(
            problems.to_string(),
            "line 2, column 7: no such component\n  2 |   é = Mvoe(A)\n    |       ^^^^ Move?"
        );
    }

    #[test]
    fn typos_find_their_word() {
        let names = ["Move", "Merge", "Divide Curve", "Construct Point"];
        assert_eq!(nearest("Mvoe", names), Some("Move"));
        assert_eq!(nearest("construct pont", names), Some("Construct Point"));
        assert_eq!(nearest("Octree", names), None);
        assert_eq!(nearest("", names), None);
    }
}
