//! Rows of a study as they are shown: at most so many, chosen evenly from all.

use crate::thresholds::MOST_SHOWN_BYTES;
use crate::{Cell, Status};

/// Whether a column was given to the definition or came out of it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Given.
    Input,
    /// Came out.
    Output,
}

/// A column of inputs or outputs.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Column {
    /// Its name without a mark.
    pub name: String,
    /// Which of both it is.
    pub kind: Kind,
    /// Whether all cells that were read so far are numbers, or nothing; NaN and infinity are numbers.
    pub is_number: bool,
}

/// A point with what it gave.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// The number of the point in its plan.
    pub point: u64,
    /// A cell for each column.
    pub cells: Vec<Cell>,
    /// The word for how it came out; empty where the table has none.
    pub status: String,
    /// Why, where it did not come out well.
    pub reason: String,
    /// Its picture, in the study's folder; empty where it has none.
    pub picture: String,
    /// Its geometry, likewise.
    pub geometry: String,
}

impl Row {
    /// Whether it has results that can be used.
    pub fn is_good(&self) -> bool {
        self.status.is_empty() || Status::of_word(&self.status).is_some_and(Status::is_good)
    }

    /// The finite number in a column.
    pub fn number(&self, column: usize) -> Option<f64> {
        self.cells.get(column)?.number().filter(|x| x.is_finite())
    }
}

/// Rows chosen evenly from all that come: the first, then every second, fourth, eighth and so on as more come than there is
/// room for.
#[derive(Debug, Clone, Default)]
pub(super) struct Thinned {
    pub(super) columns: Vec<Column>,
    pub(super) rows: Vec<Row>,
    /// How many came.
    pub(super) seen: u64,
    /// Goes up when rows that were here are gone.
    pub(super) generation: u64,
    every: u64,
    most: usize,
}

impl Thinned {
    pub(super) fn new(most: usize) -> Self {
        Self { most: most.max(1), every: 1, ..Self::default() }
    }

    /// Begins anew, with these columns.
    pub(super) fn clear(&mut self, columns: Vec<Column>) {
        self.columns = columns;
        self.rows = Vec::new();
        (self.seen, self.every) = (0, 1);
        self.generation += 1;
    }

    pub(super) fn push(&mut self, mut row: Row) {
        row.cells.resize(self.columns.len(), Cell::Null);
        for (cell, column) in row.cells.iter_mut().zip(&mut self.columns) {
            column.is_number &= is_number(cell);
        }
        if self.seen.is_multiple_of(self.every) {
            row.cells.iter_mut().for_each(shorten);
            self.rows.push(row);
        }
        self.seen += 1;
        if self.rows.len() > self.most {
            let mut at = 0_usize;
            self.rows.retain(|_| {
                at += 1;
                at % 2 == 1
            });
            self.every = self.every.saturating_mul(2);
            self.generation += 1;
        }
    }
}

/// In tables of texts, NaN and infinity are words.
fn is_number(cell: &Cell) -> bool {
    match cell {
        Cell::Null | Cell::Number(_) => true,
        Cell::Boolean(_) => false,
        Cell::Text(text) => matches!(text.as_str(), "NaN" | "inf" | "-inf"),
    }
}

/// Long lists are told by their beginnings.
fn shorten(cell: &mut Cell) {
    if let Cell::Text(text) = cell
        && text.len() > MOST_SHOWN_BYTES
    {
        let end = (0..=MOST_SHOWN_BYTES).rev().find(|at| text.is_char_boundary(*at)).unwrap_or(0);
        text.truncate(end);
        text.push('\u{2026}');
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(point: u64) -> Row {
        #[allow(clippy::cast_precision_loss, reason = "small")]
        let cells = vec![Cell::Number(point as f64)];
        let empty = String::new;
        Row { point, cells, status: empty(), reason: empty(), picture: empty(), geometry: empty() }
    }

    #[test]
    fn rows_that_are_kept_are_evenly_spaced() {
        for (count, most) in [(0, 4), (4, 4), (5, 4), (1000, 7), (1023, 64), (1, 1), (9, 1)] {
            let mut thinned = Thinned::new(most);
            thinned.clear(vec![Column { name: "x".to_owned(), kind: Kind::Input, is_number: true }]);
            (0..count).for_each(|k| thinned.push(row(k)));
            let kept: Vec<u64> = thinned.rows.iter().map(|row| row.point).collect();
            let wanted: Vec<u64> = (0..count).step_by(usize::try_from(thinned.every).unwrap()).collect();
            assert_eq!(kept, wanted, "{count} {most}");
            assert!(kept.len() <= most && thinned.seen == count);
            assert!(count <= most as u64 || kept.len() > most / 2, "{count} {most}: {}", kept.len());
        }
    }

    #[test]
    fn a_column_is_of_numbers_until_a_text_comes() {
        let mut thinned = Thinned::new(9);
        thinned.clear(vec![Column { name: "x".to_owned(), kind: Kind::Output, is_number: true }]);
        for (cell, is_number) in [
            (Cell::Null, true),
            (Cell::Number(f64::NAN), true),
            (Cell::Text("-inf".to_owned()), true),
            (Cell::Text("[1,2]".to_owned()), false),
            (Cell::Number(1.0), false),
        ] {
            thinned.push(Row { cells: vec![cell], ..row(0) });
            assert_eq!(thinned.columns[0].is_number, is_number);
        }
        thinned.push(Row { cells: vec![Cell::Text("\u{e9}".repeat(MOST_SHOWN_BYTES))], ..row(0) });
        assert!(matches!(&thinned.rows[5].cells[0], Cell::Text(text) if text.len() < MOST_SHOWN_BYTES + 4));
    }
}
