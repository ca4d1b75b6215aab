//! Where the values of a column stand on an axis.

use std::ops::Range;

use plotters::coord::ranged1d::{BoldPoints, Ranged};
use plotters::coord::types::RangedCoordf64;

use crate::thresholds::MOST_WORDS;
use crate::{Cell, Row, StudyError, StudyFolder};

/// Letters that have room beside an axis.
pub(super) const LETTERS: usize = 18;

/// The axis of a column.
#[derive(Debug, Clone)]
pub(super) struct Axis {
    pub(super) column: usize,
    pub(super) name: String,
    /// What its ends stand for.
    pub(super) range: Range<f64>,
    /// The texts at 0, 1, 2 and so on, where it has no numbers.
    words: Option<Vec<String>>,
}

impl Axis {
    /// The axis of a column.
    ///
    /// # Errors
    /// It has neither numbers nor a few different texts.
    pub(super) fn of(folder: &StudyFolder, column: usize) -> Result<Self, StudyError> {
        let about = folder.columns().get(column);
        let name = about.map(|about| printable(&about.name)).unwrap_or_default();
        let unfit = |why: String| StudyError::Unfit(format!("'{name}' {why}"));
        let texts = || {
            folder.rows().iter().filter_map(|row| row.cells.get(column)).filter(|cell| **cell != Cell::Null)
        };
        if about.is_some_and(|about| about.is_number) {
            let numbers = || folder.rows().iter().filter_map(|row| row.number(column));
            let (least, most) =
                (numbers().fold(f64::INFINITY, f64::min), numbers().fold(f64::NEG_INFINITY, f64::max));
            if least > most {
                return Err(unfit("has no finite number in any point".to_owned()));
            }
            return Ok(Self { column, name, range: widened(least, most), words: None });
        }
        let mut words: Vec<String> = texts().map(ToString::to_string).collect();
        words.sort_unstable();
        words.dedup();
        if words.len() > MOST_WORDS {
            let count = words.len();
            return Err(unfit(format!("has {count} different texts: an axis has at most {MOST_WORDS}")));
        }
        #[allow(clippy::cast_precision_loss, reason = "few words")]
        let range = -0.5..words.len() as f64 - 0.5;
        Ok(Self { column, name, range, words: Some(words) })
    }

    /// The number that a row stands at; `None` where it has none.
    #[allow(clippy::cast_precision_loss, reason = "few words")]
    pub(super) fn at(&self, row: &Row) -> Option<f64> {
        let Some(words) = &self.words else { return row.number(self.column) };
        let cell = row.cells.get(self.column).filter(|cell| **cell != Cell::Null)?.to_string();
        words.binary_search(&cell).ok().map(|at| at as f64)
    }

    /// Whether it has texts in place of numbers.
    pub(super) fn has_words(&self) -> bool {
        self.words.is_some()
    }

    /// The same from 0 to 1.
    pub(super) fn share(&self, row: &Row) -> Option<f64> {
        Some(self.share_of(self.at(row)?))
    }

    fn share_of(&self, x: f64) -> f64 {
        let Range { start, end } = self.range;
        // Both are halved, so that the distance of the largest numbers is finite.
        ((x / 2.0 - start / 2.0) / (end / 2.0 - start / 2.0)).clamp(0.0, 1.0)
    }

    /// At most so many places from 0 to 1 with what stands there.
    pub(super) fn ticks(&self, most: usize) -> Vec<(f64, String)> {
        if self.has_words() {
            return self.words(LETTERS).into_iter().map(|(x, word)| (self.share_of(x), word)).collect();
        }
        let places = RangedCoordf64::from(self.range.clone()).key_points(BoldPoints(most));
        places.into_iter().map(|x| (self.share_of(x), number(x))).collect()
    }

    /// What stands beside a number; empty on an axis of words, which stand at [`words`](Self::words).
    pub(super) fn label(&self, x: f64) -> String {
        if self.has_words() { String::new() } else { number(x) }
    }

    /// The places of the words with the words, each of which has room for so many letters.
    #[allow(clippy::cast_precision_loss, reason = "few words")]
    pub(super) fn words(&self, letters: usize) -> Vec<(f64, String)> {
        let words = self.words.iter().flatten().enumerate();
        words.map(|(at, word)| (at as f64, short(&printable(word), letters))).collect()
    }
}

/// A range that has a length, and some room about what is in it.
pub(super) fn widened(least: f64, most: f64) -> Range<f64> {
    /// The part of the range that is left free at either end.
    const ROOM: f64 = 0.03;
    let room = (most * ROOM - least * ROOM).max(least.abs().max(most.abs()) * f64::EPSILON * 64.0);
    let room = if room > 0.0 { room } else { 1.0 };
    (least - room).max(f64::MIN / 2.0)..(most + room).min(f64::MAX / 2.0)
}

/// A number in a few digits.
pub(super) fn number(x: f64) -> String {
    if x == 0.0 {
        return "0".to_owned();
    }
    if !(1e-4..1e7).contains(&x.abs()) {
        return format!("{x:.2e}");
    }
    let text = format!("{x:.4}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// A text without what XML does not take.
pub(super) fn printable(text: &str) -> String {
    text.chars()
        .map(|c| if c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}') { ' ' } else { c })
        .collect()
}

/// The beginning of a long text.
pub(super) fn short(text: &str, letters: usize) -> String {
    if text.chars().count() <= letters {
        return text.to_owned();
    }
    text.chars().take(letters.saturating_sub(1)).chain(['\u{2026}']).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_have_a_length_whatever_is_in_them() {
        for (least, most) in
            [(0.0, 0.0), (1.0, 1.0), (-1e300, 1e300), (1e16, 1e16), (f64::MIN, f64::MAX), (0.0, 5e-324)]
        {
            let range = widened(least, most);
            assert!(
                range.start < range.end && (range.end - range.start).is_finite(),
                "{least} {most} {range:?}"
            );
        }
        assert_eq!([0.0, 1.5, -2.0, 1e9, 1e-9].map(number), ["0", "1.5", "-2", "1.00e9", "1.00e-9"]);
    }
}
