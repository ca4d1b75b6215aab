//! Points that are the rows of a CSV or Parquet file.

use std::fs::File;
use std::path::Path;

use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::{Field, Row};

use crate::{Cell, StudyError};

/// Rows, each with the cells of the chosen columns.
type Rows = Box<dyn Iterator<Item = Result<Vec<Cell>, StudyError>> + Send>;

fn is_parquet(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("parquet"))
}

/// The names of the columns, and the number of rows.
///
/// # Errors
/// The file cannot be read.
pub(crate) fn look(path: &Path) -> Result<(Vec<String>, u64), StudyError> {
    let failed = |error: &dyn std::fmt::Display| StudyError::file(path, error);
    if is_parquet(path) {
        let file = File::open(path).map_err(|error| failed(&error))?;
        let reader = SerializedFileReader::new(file).map_err(|error| failed(&error))?;
        let meta = reader.metadata().file_metadata();
        let fields = meta.schema_descr().root_schema().get_fields();
        let header = fields.iter().map(|field| field.name().to_owned()).collect();
        return Ok((header, u64::try_from(meta.num_rows()).unwrap_or(0)));
    }
    let mut reader = csv::ReaderBuilder::new().from_path(path).map_err(|error| failed(&error))?;
    let header = reader.headers().map_err(|error| failed(&error))?.iter().map(str::to_owned).collect();
    let mut record = csv::StringRecord::new();
    let mut count = 0;
    while reader.read_record(&mut record).map_err(|error| failed(&error))? {
        count += 1;
    }
    Ok((header, count))
}

/// The columns that are inputs, with the names of the inputs: those of the plan's inputs; where it has none, those that begin
/// with `in:` or `in.`; where no column does, all.
///
/// # Errors
/// An input has no column.
pub(crate) fn columns(header: &[String], wanted: &[&str]) -> Result<Vec<(usize, String)>, StudyError> {
    let plain = |name: &str| {
        let (mark, rest) = name.split_at_checked(3)?;
        (mark.eq_ignore_ascii_case("in:") || mark.eq_ignore_ascii_case("in.")).then(|| rest.to_owned())
    };
    if !wanted.is_empty() {
        let find = |name: &&str| {
            let same = |column: &String| column == name || plain(column).as_deref() == Some(name);
            let column = header.iter().position(same);
            let column =
                column.ok_or_else(|| StudyError::Plan(format!("the file has no column '{name}'")))?;
            Ok((column, (*name).to_owned()))
        };
        return wanted.iter().map(find).collect();
    }
    let marked: Vec<(usize, String)> =
        header.iter().enumerate().filter_map(|(k, name)| Some((k, plain(name)?))).collect();
    let found = if marked.is_empty() { header.iter().cloned().enumerate().collect() } else { marked };
    if found.is_empty() { Err(StudyError::Plan("the file has no columns".to_owned())) } else { Ok(found) }
}

/// The rows, one after another.
///
/// # Errors
/// The file cannot be read; so may each row.
pub(crate) fn read(path: &Path, columns: Vec<usize>) -> Result<Rows, StudyError> {
    let owned = path.to_path_buf();
    if is_parquet(path) {
        let file = File::open(path).map_err(|error| StudyError::file(path, error))?;
        let reader = SerializedFileReader::new(file).map_err(|error| StudyError::file(path, error))?;
        let rows = reader.into_iter();
        return Ok(Box::new(rows.map(move |row| {
            let row = row.map_err(|error| StudyError::file(&owned, error))?;
            Ok(chosen(&row, &columns))
        })));
    }
    let reader = csv::ReaderBuilder::new().from_path(path).map_err(|error| StudyError::file(path, error))?;
    Ok(Box::new(reader.into_records().map(move |record| {
        let record = record.map_err(|error| StudyError::file(&owned, error))?;
        Ok(columns.iter().map(|column| record.get(*column).map_or(Cell::Null, Cell::of_text)).collect())
    })))
}

fn chosen(row: &Row, columns: &[usize]) -> Vec<Cell> {
    let fields: Vec<(&String, &Field)> = row.get_column_iter().collect();
    columns.iter().map(|column| fields.get(*column).map_or(Cell::Null, |(_, field)| cell(field))).collect()
}

#[allow(clippy::cast_precision_loss, reason = "inputs are numbers")]
fn cell(field: &Field) -> Cell {
    match field {
        Field::Null => Cell::Null,
        Field::Bool(on) => Cell::Boolean(*on),
        Field::Byte(x) => Cell::Number(f64::from(*x)),
        Field::Short(x) => Cell::Number(f64::from(*x)),
        Field::Int(x) => Cell::Number(f64::from(*x)),
        Field::Long(x) => Cell::Number(*x as f64),
        Field::UByte(x) => Cell::Number(f64::from(*x)),
        Field::UShort(x) => Cell::Number(f64::from(*x)),
        Field::UInt(x) => Cell::Number(f64::from(*x)),
        Field::ULong(x) => Cell::Number(*x as f64),
        Field::Float(x) => Cell::Number(f64::from(*x)),
        Field::Double(x) => Cell::Number(*x),
        Field::Str(text) => Cell::Text(text.clone()),
        other => Cell::Text(other.to_string()),
    }
}
