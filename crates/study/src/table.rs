//! The tables of a study: Parquet for programs, CSV for Design Explorer and people.

use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use katydid_session::{OutputFile, remove_unfinished};
use parquet::basic::{Compression, LogicalType, Repetition, Type as Physical};
use parquet::data_type::{ByteArray, ByteArrayType, DoubleType, Int64Type};
use parquet::errors::ParquetError;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::Type;

use crate::record::Kept;
use crate::thresholds::ROWS_A_GROUP;
use crate::{Cell, Plan, StudyError};

/// Gives what is kept of a point.
type Get<'a> = dyn FnMut(&[Cell]) -> Result<Option<Kept>, StudyError> + 'a;

/// A column of results or inputs.
struct Column {
    name: String,
    /// Whether all its cells are numbers or nothing.
    is_number: bool,
}

/// The columns between the number of a row and its status.
struct Columns {
    inputs: Vec<Column>,
    outputs: Vec<Column>,
}

/// Writes all tables; gives their paths, and how many rows have no usable result.
///
/// # Errors
/// A file cannot be read or written.
pub(crate) fn write(
    plan: &Plan,
    folder: &Path,
    get: &mut Get<'_>,
) -> Result<(Vec<PathBuf>, u64), StudyError> {
    let columns = columns(plan, get)?;
    // What a sweep that was ended in the middle of this has left: the study's file is locked, so that nobody else writes them.
    for name in ["table.parquet", "data.csv", "failed.csv", "times.csv"] {
        let path = folder.join(name);
        remove_unfinished(&path).map_err(|error| StudyError::file(&path, error))?;
    }
    let mut parquet = Parquet::create(&folder.join("table.parquet"), &columns)?;
    let mut explorer = Csv::create(&folder.join("data.csv"))?;
    let mut failed = Csv::create(&folder.join("failed.csv"))?;
    let mut times = Csv::create(&folder.join("times.csv"))?;
    let inputs: Vec<String> = columns.inputs.iter().map(|column| format!("in:{}", column.name)).collect();
    let outputs: Vec<String> = columns.outputs.iter().map(|column| format!("out:{}", column.name)).collect();
    let mut header = [inputs.clone(), outputs].concat();
    header.extend(["point", "status", "reason"].map(str::to_owned));
    // Design Explorer looks for the beginning of a name, `img`, and draws what it finds there.
    header.extend(plan.pictures.then(|| "img".to_owned()));
    header.extend(plan.geometry.is_some().then(|| "geometry".to_owned()));
    explorer.row(&header)?;
    failed
        .row(&[vec!["point".to_owned()], inputs, vec!["status".to_owned(), "reason".to_owned()]].concat())?;
    times.row(&["point".to_owned(), "milliseconds".to_owned()])?;
    let mut failures = 0;
    for (number, point) in plan.points()?.enumerate() {
        let point = point?;
        let kept = get(&point)?.ok_or_else(|| StudyError::Unfit(format!("point {number} was not solved")))?;
        let number = number.to_string();
        let status = kept.outcome.status.word().to_owned();
        let texts = |cells: &[Cell]| -> Vec<String> { cells.iter().map(ToString::to_string).collect() };
        let end = [status, kept.outcome.reason.clone()];
        let mut row =
            [texts(&point), texts(&kept.outcome.cells), vec![number.clone()], end.to_vec()].concat();
        let [picture, geometry] = kept.files.clone();
        row.extend(plan.pictures.then_some(picture));
        row.extend(plan.geometry.is_some().then_some(geometry));
        explorer.row(&row)?;
        if !kept.outcome.status.is_good() {
            failures += 1;
            failed.row(&[vec![number.clone()], texts(&point), end.to_vec()].concat())?;
        }
        times.row(&[number, (kept.outcome.time.as_secs_f64() * 1e3).to_string()])?;
        parquet.row(point, kept)?;
    }
    let paths = vec![parquet.finish()?, explorer.finish()?, failed.finish()?, times.finish()?];
    Ok((paths, failures))
}

/// Looks through all rows for the types of the columns.
fn columns(plan: &Plan, get: &mut Get<'_>) -> Result<Columns, StudyError> {
    let new = |name: &String| Column { name: name.clone(), is_number: true };
    let mut inputs: Vec<Column> = plan.variables().iter().map(|variable| new(&variable.name)).collect();
    let mut outputs: Vec<Column> = plan.outputs().iter().map(|output| new(&output.name)).collect();
    let look = |columns: &mut [Column], cells: &[Cell]| {
        for (column, cell) in columns.iter_mut().zip(cells) {
            column.is_number &= matches!(cell, Cell::Number(_) | Cell::Null);
        }
    };
    for point in plan.points()? {
        let point = point?;
        look(&mut inputs, &point);
        if let Some(kept) = get(&point)? {
            look(&mut outputs, &kept.outcome.cells);
        }
    }
    Ok(Columns { inputs, outputs })
}

struct Csv {
    path: PathBuf,
    writer: csv::Writer<BufWriter<OutputFile>>,
}

impl Csv {
    fn create(path: &Path) -> Result<Self, StudyError> {
        let file = OutputFile::create(path).map_err(|error| StudyError::file(path, error))?;
        Ok(Self { path: path.to_path_buf(), writer: csv::Writer::from_writer(BufWriter::new(file)) })
    }

    fn row(&mut self, cells: &[String]) -> Result<(), StudyError> {
        self.writer.write_record(cells).map_err(|error| StudyError::file(&self.path, error))
    }

    fn finish(self) -> Result<PathBuf, StudyError> {
        let failed = |error: &dyn std::fmt::Display| StudyError::file(&self.path, error);
        let buffered = self.writer.into_inner().map_err(|error| failed(&error))?;
        let file = buffered.into_inner().map_err(|error| failed(&error))?;
        file.finish().map_err(|error| failed(&error))?;
        Ok(self.path)
    }
}

/// A Parquet file with rows that wait for their group.
struct Parquet {
    path: PathBuf,
    writer: SerializedFileWriter<BufWriter<OutputFile>>,
    /// Whether each column of inputs and outputs has numbers.
    numbers: Vec<bool>,
    rows: Vec<(Vec<Cell>, Kept)>,
    written: usize,
}

impl Parquet {
    fn create(path: &Path, columns: &Columns) -> Result<Self, StudyError> {
        let failed = |error: ParquetError| StudyError::file(path, error);
        let file = OutputFile::create(path).map_err(|error| StudyError::file(path, error))?;
        let schema = schema(columns).map_err(failed)?;
        let properties = WriterProperties::builder()
            .set_compression(Compression::SNAPPY)
            // The same bytes for the same rows, whichever version of the library wrote them.
            .set_created_by("katydid".to_owned())
            .build();
        let writer = SerializedFileWriter::new(BufWriter::new(file), Arc::new(schema), Arc::new(properties))
            .map_err(failed)?;
        let numbers = columns.inputs.iter().chain(&columns.outputs).map(|column| column.is_number).collect();
        Ok(Self { path: path.to_path_buf(), writer, numbers, rows: Vec::new(), written: 0 })
    }

    fn row(&mut self, point: Vec<Cell>, kept: Kept) -> Result<(), StudyError> {
        self.rows.push((point, kept));
        if self.rows.len() < ROWS_A_GROUP { Ok(()) } else { self.flush() }
    }

    fn flush(&mut self) -> Result<(), StudyError> {
        let rows = std::mem::take(&mut self.rows);
        let first = self.written;
        self.written += rows.len();
        group(&mut self.writer, &self.numbers, &rows, first)
            .map_err(|error| StudyError::file(&self.path, error))
    }

    fn finish(mut self) -> Result<PathBuf, StudyError> {
        if !self.rows.is_empty() {
            self.flush()?;
        }
        let failed = |error: &dyn std::fmt::Display| StudyError::file(&self.path, error);
        let buffered = self.writer.into_inner().map_err(|error| failed(&error))?;
        let file = buffered.into_inner().map_err(|error| failed(&error))?;
        file.finish().map_err(|error| failed(&error))?;
        Ok(self.path)
    }
}

fn schema(columns: &Columns) -> Result<Type, ParquetError> {
    let text = |name: &str| -> Result<Arc<Type>, ParquetError> {
        let builder = Type::primitive_type_builder(name, Physical::BYTE_ARRAY)
            .with_logical_type(Some(LogicalType::String));
        Ok(Arc::new(builder.with_repetition(Repetition::OPTIONAL).build()?))
    };
    let cells = |mark: &str, column: &Column| -> Result<Arc<Type>, ParquetError> {
        let name = format!("{mark}.{}", column.name);
        if !column.is_number {
            return text(&name);
        }
        let builder = Type::primitive_type_builder(&name, Physical::DOUBLE);
        Ok(Arc::new(builder.with_repetition(Repetition::OPTIONAL).build()?))
    };
    let number = Type::primitive_type_builder("point", Physical::INT64)
        .with_repetition(Repetition::REQUIRED)
        .build()?;
    let mut fields = vec![Arc::new(number)];
    for (mark, columns) in [("in", &columns.inputs), ("out", &columns.outputs)] {
        for column in columns {
            fields.push(cells(mark, column)?);
        }
    }
    for name in ["status", "reason", "hash", "img", "geometry"] {
        fields.push(text(name)?);
    }
    Type::group_type_builder("study").with_fields(fields).build()
}

/// Writes a group of rows, column by column in the order of the schema.
fn group<W: Write + Send>(
    writer: &mut SerializedFileWriter<W>,
    numbers: &[bool],
    rows: &[(Vec<Cell>, Kept)],
    first: usize,
) -> Result<(), ParquetError> {
    let mut group = writer.next_row_group()?;
    let missing = || ParquetError::General("a column is missing".to_owned());
    let mut column = group.next_column()?.ok_or_else(missing)?;
    let places: Vec<i64> =
        (first..first + rows.len()).map(|n| i64::try_from(n).unwrap_or(i64::MAX)).collect();
    column.typed::<Int64Type>().write_batch(&places, None, None)?;
    column.close()?;
    for (at, is_number) in numbers.iter().enumerate() {
        let cell = |(point, kept): &(Vec<Cell>, Kept)| -> Cell {
            let output = at.checked_sub(point.len()).and_then(|k| kept.outcome.cells.get(k));
            point.get(at).or(output).cloned().unwrap_or(Cell::Null)
        };
        let mut column = group.next_column()?.ok_or_else(missing)?;
        if *is_number {
            let (values, levels) = given(rows.iter().map(|row| cell(row).number()));
            column.typed::<DoubleType>().write_batch(&values, Some(&levels), None)?;
        } else {
            let texts = rows.iter().map(|row| match cell(row) {
                Cell::Null => None,
                cell => Some(ByteArray::from(cell.to_string().into_bytes())),
            });
            let (values, levels) = given(texts);
            column.typed::<ByteArrayType>().write_batch(&values, Some(&levels), None)?;
        }
        column.close()?;
    }
    let texts: [&dyn Fn(&Kept) -> String; 5] = [
        &|kept| kept.outcome.status.word().to_owned(),
        &|kept| kept.outcome.reason.clone(),
        &|kept| kept.name.iter().map(|byte| format!("{byte:02x}")).collect(),
        &|kept| kept.files[0].clone(),
        &|kept| kept.files[1].clone(),
    ];
    for text in texts {
        let mut column = group.next_column()?.ok_or_else(missing)?;
        let texts = rows.iter().map(|(_, kept)| Some(text(kept)).filter(|text| !text.is_empty()));
        let (values, levels) = given(texts.map(|text| text.map(|text| ByteArray::from(text.into_bytes()))));
        column.typed::<ByteArrayType>().write_batch(&values, Some(&levels), None)?;
        column.close()?;
    }
    group.close().map(drop)
}

/// The values that are there, and for each row whether it has one.
fn given<T>(cells: impl Iterator<Item = Option<T>>) -> (Vec<T>, Vec<i16>) {
    let mut levels = Vec::new();
    let values = cells.inspect(|cell| levels.push(i16::from(cell.is_some()))).flatten().collect();
    (values, levels)
}
