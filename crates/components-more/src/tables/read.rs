//! Spreadsheets read.

use katydid_component::{Context, Message};

use super::{Cell, Table, Which};

/// The bytes that .xlsx files begin with: those of a zip archive.
const ZIP: &[u8] = b"PK\x03\x04";
/// The bytes that .xls files begin with: those of a compound file.
const COMPOUND: &[u8] = &[0xd0, 0xcf, 0x11, 0xe0];
/// About how many bytes a cell takes.
const CELL: usize = 32;
/// A table is dense: one with a cell far out, or one long row, is refused when it would have more cells than this.
const MOST_CELLS: usize = 20_000_000;

pub(super) fn read(context: &Context<'_>, path: &str, which: &Which) -> Result<Table, Message> {
    let bytes = context.read_file(path)?;
    let read = if bytes.starts_with(ZIP) {
        workbook::xlsx(context, bytes, which)
    } else if bytes.starts_with(COMPOUND) {
        workbook::xls(context, bytes, which)
    } else if path.trim().to_lowercase().ends_with(".csv") || path.trim().to_lowercase().ends_with(".txt") {
        csv(context, &bytes)
    } else {
        return Err(Message::error(format!(
            "{path} is no spreadsheet: .xlsx, .xlsm, .xls and .csv files are read"
        )));
    };
    read.map_err(|why| Message { text: format!("{path}: {}", why.text), ..why })
}

/// Cells apart by commas, or by semicolons where the first line has those and no comma; in quotes where they hold such a sign.
fn csv(context: &Context<'_>, bytes: &[u8]) -> Result<Table, Message> {
    let text = String::from_utf8_lossy(bytes);
    let text = text.trim_start_matches('\u{feff}');
    let first = text.lines().next().unwrap_or_default();
    let sign = [(',', b','), (';', b';'), ('\t', b'\t')].into_iter().find(|(sign, _)| first.contains(*sign));
    let mut reader = csv::ReaderBuilder::new();
    reader.has_headers(false).flexible(true).delimiter(sign.map_or(b',', |(_, byte)| byte));
    let mut rows = Vec::new();
    for record in reader.from_reader(text.as_bytes()).records() {
        let record = record.map_err(|error| Message::error(format!("it cannot be read: {error}")))?;
        context.check()?;
        context.items(record.len())?;
        context.bytes(record.len().saturating_mul(CELL))?;
        rows.push(record.iter().map(cell).collect());
    }
    squared(context, rows)
}

/// A number, a truth, or a text.
fn cell(field: &str) -> Cell {
    let plain = field.trim();
    if plain.is_empty() {
        return Cell::Empty;
    }
    // Words such as `inf` and `nan` are texts.
    let is_number = plain.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c))
        && plain.ends_with(|c: char| c.is_ascii_digit() || c == '.');
    match plain.parse::<f64>() {
        Ok(number) if is_number && number.is_finite() => Cell::Number(number),
        _ if plain.eq_ignore_ascii_case("true") => Cell::Boolean(true),
        _ if plain.eq_ignore_ascii_case("false") => Cell::Boolean(false),
        _ => Cell::Text(field.into()),
    }
}

/// Asks for room for all cells of a table before it is made.
fn fits(context: &Context<'_>, rows: usize, width: usize) -> Result<(), Message> {
    let count = rows.saturating_mul(width);
    if count > MOST_CELLS {
        return Err(Message::error(format!("it cannot be read: {rows} rows of {width} cells are too many")));
    }
    context.items(count)?;
    context.bytes(count.saturating_mul(CELL))
}

/// Rows of one length.
fn squared(context: &Context<'_>, mut rows: Vec<Vec<Cell>>) -> Result<Table, Message> {
    let width = rows.iter().map(Vec::len).max().unwrap_or(0);
    fits(context, rows.len(), width)?;
    rows.iter_mut().for_each(|row| row.resize(width, Cell::Empty));
    Ok(Table { rows })
}

#[cfg(feature = "spreadsheets")]
mod workbook {
    use std::io::{Cursor, Read};

    use calamine::{Data, DataRef, Reader, Xls, Xlsx};
    use katydid_component::{Context, Message};
    use katydid_data::DateTime;

    use super::{CELL, fits, squared};
    use crate::tables::{Cell, Table, Which};

    /// All that is packed in a file may take so many bytes: more is an attack rather than a table.
    const MOST_INFLATED: u64 = 1 << 28;
    /// The cells of the largest .xls sheet, 65,536 rows of 256; the reader makes all up to the last one.
    const XLS_CELLS: usize = 65_536 * 256;

    fn problem(why: impl std::fmt::Display) -> Message {
        Message::error(format!("it cannot be read: {why}"))
    }

    /// An .xlsx file: cell by cell, so that its size is known before there is room for it.
    pub(super) fn xlsx(context: &Context<'_>, bytes: Vec<u8>, which: &Which) -> Result<Table, Message> {
        measured(context, &bytes)?;
        let mut book: Xlsx<_> = Xlsx::new(Cursor::new(bytes)).map_err(problem)?;
        let names = book.sheet_names();
        let place = which.find(&names)?;
        let name = names.get(place).map_or("", String::as_str);
        let mut cells = book.worksheet_cells_reader(name).map_err(problem)?;
        let mut found = Vec::new();
        let mut size = [0_usize; 2];
        while let Some(cell) = cells.next_cell().map_err(problem)? {
            let made = made(cell.get_value());
            if made == Cell::Empty {
                continue;
            }
            context.bytes(CELL)?;
            context.check()?;
            let (row, column) = cell.get_position();
            let at = [row, column].map(|n| usize::try_from(n).unwrap_or(usize::MAX));
            size = [size[0].max(at[0].saturating_add(1)), size[1].max(at[1].saturating_add(1))];
            found.push((at, made));
        }
        fits(context, size[0], size[1])?;
        let mut rows = vec![vec![Cell::Empty; size[1]]; size[0]];
        for ([row, column], cell) in found {
            if let Some(slot) = rows.get_mut(row).and_then(|row| row.get_mut(column)) {
                *slot = cell;
            }
        }
        Ok(Table { rows })
    }

    /// Unpacks all that is in a zip archive, to know that it has an end: what sizes it states may be wrong.
    fn measured(context: &Context<'_>, bytes: &[u8]) -> Result<(), Message> {
        let mut archive = zip::ZipArchive::new(Cursor::new(bytes)).map_err(problem)?;
        let mut left = MOST_INFLATED;
        let mut piece = vec![0_u8; 1 << 16];
        for place in 0..archive.len() {
            let mut file = archive.by_index(place).map_err(problem)?;
            loop {
                context.check()?;
                let read = file.read(&mut piece).map_err(problem)?;
                if read == 0 {
                    break;
                }
                let read = u64::try_from(read).unwrap_or(u64::MAX);
                left = left.checked_sub(read).ok_or_else(|| problem("unpacked, it is too large"))?;
            }
        }
        // Texts and cells take some times the room of what they are made of.
        context.bytes(usize::try_from((MOST_INFLATED - left).saturating_mul(2)).unwrap_or(usize::MAX))
    }

    /// An .xls file of Excel 97 to 2003.
    pub(super) fn xls(context: &Context<'_>, bytes: Vec<u8>, which: &Which) -> Result<Table, Message> {
        context.bytes(XLS_CELLS.saturating_mul(CELL))?;
        let mut book: Xls<_> = Xls::new(Cursor::new(bytes)).map_err(problem)?;
        let names = book.sheet_names();
        let place = which.find(&names)?;
        let range = book.worksheet_range(names.get(place).map_or("", String::as_str)).map_err(problem)?;
        let Some((row, column)) = range.start() else { return Ok(Table::default()) };
        // The range begins with the first cell that is used; the table with the first one.
        let [above, before] = [row, column].map(|n| usize::try_from(n).unwrap_or(usize::MAX));
        let width = before.saturating_add(range.width());
        let count = above.saturating_add(range.height()).saturating_mul(width);
        if count > XLS_CELLS {
            return Err(problem("it has too many cells"));
        }
        let mut rows = vec![Vec::new(); above];
        for row in range.rows() {
            context.check()?;
            let mut cells = vec![Cell::Empty; before];
            cells.extend(row.iter().map(|cell| made(&lent(cell))));
            rows.push(cells);
        }
        squared(context, rows)
    }

    fn lent(cell: &Data) -> DataRef<'_> {
        match cell {
            Data::Int(number) => DataRef::Int(*number),
            Data::Float(number) => DataRef::Float(*number),
            Data::String(text) | Data::DateTimeIso(text) | Data::DurationIso(text) => {
                DataRef::SharedString(text)
            }
            Data::Bool(yes) => DataRef::Bool(*yes),
            Data::DateTime(moment) => DataRef::DateTime(*moment),
            Data::Error(error) => DataRef::Error(error.clone()),
            Data::Empty => DataRef::Empty,
        }
    }

    fn made(cell: &DataRef<'_>) -> Cell {
        match cell {
            DataRef::Empty => Cell::Empty,
            DataRef::Int(number) => Cell::Number(*number as f64),
            DataRef::Float(number) => Cell::Number(*number),
            DataRef::String(text) => Cell::Text(text.as_str().into()),
            DataRef::SharedString(text) => Cell::Text((*text).into()),
            DataRef::Bool(yes) => Cell::Boolean(*yes),
            DataRef::DateTime(moment) if moment.is_datetime() => {
                let (year, month, day, hour, minute, second, milli) = moment.to_ymd_hms_milli();
                let date = DateTime::on([year.into(), month.into(), day.into()]);
                let seconds = (i64::from(hour) * 60 + i64::from(minute)) * 60 + i64::from(second);
                let ticks = seconds * DateTime::SECOND + i64::from(milli) * (DateTime::SECOND / 1000);
                // Excel counts a day that never was, 1900-02-29.
                date.map_or(Cell::Number(moment.as_f64()), |date| {
                    Cell::Moment(DateTime { ticks: date.ticks + ticks })
                })
            }
            DataRef::DateTime(duration) => Cell::Number(duration.as_f64()),
            DataRef::DateTimeIso(text) | DataRef::DurationIso(text) => Cell::Text(text.as_str().into()),
            DataRef::Error(error) => Cell::Text(error.to_string().into()),
        }
    }
}

#[cfg(not(feature = "spreadsheets"))]
mod workbook {
    use katydid_component::{Context, Message};

    use crate::tables::{Table, Which};

    pub(super) fn xlsx(_: &Context<'_>, _: Vec<u8>, _: &Which) -> Result<Table, Message> {
        Err(Message::error("this program reads no Excel files, only .csv"))
    }

    pub(super) fn xls(_: &Context<'_>, _: Vec<u8>, _: &Which) -> Result<Table, Message> {
        Err(Message::error("this program reads no Excel files, only .csv"))
    }
}
