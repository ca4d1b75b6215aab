//! Spreadsheets written.

use std::sync::Arc as Shared;

use katydid_component::{Context, Message};
use katydid_data::{Tree, Value};

use super::{Cell, Table};

/// Writes sheets, and tells what was written.
pub(crate) fn save(context: &Context<'_>, path: &str, sheets: &[(String, Table)]) -> Result<Tree, Message> {
    if !context.writes_files() {
        context.write_file(path, Vec::new())?;
        return Ok(Tree::empty());
    }
    let cells: usize = sheets.iter().map(|(_, table)| table.size()).sum();
    // What is written takes some times the room of its cells.
    context.bytes(cells.saturating_mul(200))?;
    let name = context.write_file(path, written(path, sheets)?)?;
    Ok(name.map_or_else(Tree::empty, |name| {
        let told: Shared<str> = format!("Spreadsheet saved to: {name}").into();
        Tree::item(Value::Text(told))
    }))
}

/// Sheets as a file of the kind that its name says: .csv of the first sheet, else .xlsx.
///
/// # Errors
/// The message to show when a name or a size is none that the format takes.
fn written(path: &str, sheets: &[(String, Table)]) -> Result<Vec<u8>, Message> {
    if path.trim().to_lowercase().ends_with(".csv") {
        return sheets.first().map_or_else(|| Ok(Vec::new()), |(_, table)| csv(table));
    }
    workbook::xlsx(sheets)
}

/// Lines of cells apart by commas, by RFC 4180.
fn csv(table: &Table) -> Result<Vec<u8>, Message> {
    let problem = |why: String| Message::error(format!("The table cannot be written: {why}"));
    let mut writer = csv::WriterBuilder::new();
    writer.flexible(true).terminator(csv::Terminator::CRLF);
    let mut writer = writer.from_writer(Vec::new());
    for row in &table.rows {
        writer.write_record(row.iter().map(field)).map_err(|error| problem(error.to_string()))?;
    }
    writer.into_inner().map_err(|error| problem(error.to_string()))
}

fn field(cell: &Cell) -> String {
    match cell {
        Cell::Empty => String::new(),
        Cell::Text(text) => text.to_string(),
        Cell::Number(number) => number.to_string(),
        Cell::Boolean(yes) => if *yes { "TRUE" } else { "FALSE" }.to_owned(),
        Cell::Moment(moment) => {
            let [year, month, day] = moment.date();
            let seconds = moment.time_of_day() / katydid_data::DateTime::SECOND;
            let [hour, minute, second] = [seconds / 3600, seconds / 60 % 60, seconds % 60];
            format!("{year:04}-{month:02}-{day:02} {hour:02}:{minute:02}:{second:02}")
        }
    }
}

#[cfg(feature = "spreadsheets")]
mod workbook {
    use katydid_component::Message;
    use katydid_data::DateTime;
    use rust_xlsxwriter::{DocProperties, ExcelDateTime, Format, Workbook, Worksheet, XlsxError};

    use crate::tables::{Cell, Table};

    fn problem(error: &XlsxError) -> Message {
        Message::error(format!("The spreadsheet cannot be written: {error}"))
    }

    /// The sheets as an .xlsx file; the same tables give the same bytes.
    pub(super) fn xlsx(sheets: &[(String, Table)]) -> Result<Vec<u8>, Message> {
        fill(sheets).map_err(|error| problem(&error))
    }

    fn fill(sheets: &[(String, Table)]) -> Result<Vec<u8>, XlsxError> {
        let mut book = Workbook::new();
        // A file tells when it was made; here that is always the same day.
        let day = ExcelDateTime::from_ymd(2000, 1, 1)?;
        book.set_properties(&DocProperties::new().set_creation_datetime(&day));
        let date = Format::new().set_num_format("yyyy-mm-dd hh:mm:ss");
        for (name, table) in sheets {
            let sheet = book.add_worksheet();
            sheet.set_name(name)?;
            for (row, cells) in (0_u32..).zip(&table.rows) {
                for (column, cell) in cells.iter().enumerate() {
                    // A number that is too large is an error of the library.
                    let column = u16::try_from(column).unwrap_or(u16::MAX);
                    write(sheet, [row, column.into()], cell, &date)?;
                }
            }
        }
        book.save_to_buffer()
    }

    fn write(sheet: &mut Worksheet, at: [u32; 2], cell: &Cell, date: &Format) -> Result<(), XlsxError> {
        let (row, column) = (at[0], u16::try_from(at[1]).unwrap_or(u16::MAX));
        match cell {
            Cell::Empty => return Ok(()),
            Cell::Text(text) => sheet.write_string(row, column, text.as_ref())?,
            Cell::Number(number) => sheet.write_number(row, column, *number)?,
            Cell::Boolean(yes) => sheet.write_boolean(row, column, *yes)?,
            Cell::Moment(moment) => sheet.write_number_with_format(row, column, serial(*moment), date)?,
        };
        Ok(())
    }

    /// The days since 1899-12-30, as Excel counts from 1900-03-01 on.
    fn serial(moment: DateTime) -> f64 {
        let zero = DateTime::on([1899, 12, 30]).unwrap_or_default();
        (moment.ticks - zero.ticks) as f64 / DateTime::DAY as f64
    }
}

#[cfg(not(feature = "spreadsheets"))]
mod workbook {
    use katydid_component::Message;

    use crate::tables::Table;

    pub(super) fn xlsx(_: &[(String, Table)]) -> Result<Vec<u8>, Message> {
        Err(Message::error("This program writes no Excel files, only .csv"))
    }
}
