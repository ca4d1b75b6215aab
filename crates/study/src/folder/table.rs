//! Rows of a study's table: Katydid's own, in Parquet or CSV, or a CSV file that was written for Design Explorer.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

use super::rows::{Column, Kind, Row, Thinned};
use crate::plan::rows;
use crate::thresholds::{MOST_COLUMNS, MOST_TABLE_ROWS};
use crate::{Cell, StudyError};

/// What a column of the file is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Part {
    /// An input or output.
    Cell,
    Point,
    Status,
    Reason,
    Picture,
    Geometry,
    /// What is not shown.
    Other,
}

/// Reads a table; what was in `into` is replaced, unless the file cannot be read.
///
/// # Errors
/// The file cannot be read or is damaged.
pub(super) fn read(path: &Path, into: &mut Thinned, most: usize) -> Result<(), StudyError> {
    // A library that meets a damaged file where it did not expect one panics.
    let read = catch_unwind(AssertUnwindSafe(|| whole(path, most)));
    let found = read.map_err(|_| StudyError::file(path, "it is damaged"))??;
    let generation = into.generation;
    *into = found;
    into.generation += generation;
    Ok(())
}

fn whole(path: &Path, most: usize) -> Result<Thinned, StudyError> {
    let (header, _) = rows::look(path)?;
    if header.len() > MOST_COLUMNS {
        let count = header.len();
        return Err(StudyError::file(path, format!("{count} columns are more than {MOST_COLUMNS}")));
    }
    let mut columns = Vec::new();
    let mut parts = Vec::new();
    for name in &header {
        let (part, column) = part(name);
        // The first of several pictures is shown.
        let is_known = part != Part::Cell && part != Part::Other && parts.contains(&part);
        parts.push(if is_known { Part::Other } else { part });
        columns.extend(column);
    }
    let mut found = Thinned::new(most);
    found.clear(columns);
    for (number, cells) in rows::read(path, (0..header.len()).collect())?.enumerate() {
        if number >= MOST_TABLE_ROWS {
            return Err(StudyError::file(path, format!("it has more than {MOST_TABLE_ROWS} rows")));
        }
        found.push(row(number as u64, &parts, cells?));
    }
    Ok(found)
}

fn part(name: &str) -> (Part, Option<Column>) {
    let lower = name.to_lowercase();
    let marked = |mark: &str| {
        let rest = lower.strip_prefix(mark)?;
        (rest.starts_with([':', '.'])).then(|| name.get(mark.len() + 1..).unwrap_or(name).to_owned())
    };
    let cell = |name: String, kind| (Part::Cell, Some(Column { name, kind, is_number: true }));
    if let Some(name) = marked("in") {
        return cell(name, Kind::Input);
    }
    if let Some(name) = marked("out") {
        return cell(name, Kind::Output);
    }
    match lower.as_str() {
        "point" => (Part::Point, None),
        "status" => (Part::Status, None),
        "reason" => (Part::Reason, None),
        "geometry" => (Part::Geometry, None),
        "hash" => (Part::Other, None),
        // Design Explorer looks for the beginnings of these.
        _ if lower.starts_with("img") => (Part::Picture, None),
        _ if lower.starts_with("threed") => (Part::Other, None),
        _ => cell(name.to_owned(), Kind::Output),
    }
}

fn row(number: u64, parts: &[Part], cells: Vec<Cell>) -> Row {
    let mut row = Row {
        point: number,
        cells: Vec::new(),
        status: String::new(),
        reason: String::new(),
        picture: String::new(),
        geometry: String::new(),
    };
    for (part, cell) in parts.iter().zip(cells) {
        match part {
            Part::Cell => row.cells.push(cell),
            Part::Point => row.point = whole_number(&cell).unwrap_or(number),
            Part::Status => row.status = cell.to_string(),
            Part::Reason => row.reason = cell.to_string(),
            Part::Picture => row.picture = cell.to_string(),
            Part::Geometry => row.geometry = cell.to_string(),
            Part::Other => {}
        }
    }
    row
}

#[allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "the number is whole and in range"
)]
fn whole_number(cell: &Cell) -> Option<u64> {
    /// Larger whole numbers have no digits after which a double would hold them all.
    const MOST: f64 = 9_007_199_254_740_992.0;
    cell.number().filter(|x| (0.0..MOST).contains(x) && x.fract() == 0.0).map(|x| x as u64)
}
