//! Spreadsheets.

use std::sync::Arc as Shared;

use katydid_component::{Context, Message, component};
use katydid_data::{Tree, Value};

use crate::model_objects::{first, is_true};
use crate::tables::{Cell, Table, Which, save};

/// Reads a sheet of a spreadsheet: a branch for each column, as Excel Write takes them; cells without anything are null. .xlsx,
/// .xlsm, .xls and .csv files are read, be they open in Excel or not. Which files may be read is set where the definition runs.
/// Stands for LunchBox's Excel Reader; that its branches are columns is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1b41",
    name = "Excel Reader",
    nick = "ExcelRead",
    at = "LunchBox/Workflow"
)]
#[output("Exceptions", "out", "How many rows were read.", kind = Text)]
#[output("Excel Data", "Data", "A branch for each column.", kind = Generic)]
fn read(
    context: &Context<'_>,
    /// Whether to read.
    #[port("Read Excel Data", "Read", kind = Boolean, optional)]
    read: &Tree,
    /// The path of the file.
    #[port("Workbook Path", "Path", kind = Text)]
    path: &Tree,
    /// The name of the sheet, or its number; the first one when nothing is given.
    #[port("Worksheet Name", "Worksheet", kind = Generic, optional)]
    sheet: &Tree,
) -> Result<(Tree, Tree), Message> {
    if !read.is_empty() && !is_true(Some(read)) {
        return Ok((Tree::item(Value::text("Nothing is read")), Tree::empty()));
    }
    let Some(Value::Text(path)) = first(path) else { return Ok((Tree::empty(), Tree::empty())) };
    let table = Table::read(context, &path, &Which::of(first(sheet).as_ref()))?;
    let told = format!("{} rows", table.rows.len());
    Ok((Tree::item(Value::text(told)), table.turned().tree(Cell::value)))
}

/// Writes a sheet of a spreadsheet: a column for each branch, under its heading. The name of the file ends in .xlsx or .csv. Stands
/// for LunchBox's Excel Write. Files are written by `katydid run --write FOLDER`, into that folder; a file is always made anew.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1b42",
    name = "Excel Write",
    nick = "ExcelWrite",
    at = "LunchBox/Workflow"
)]
#[output("Exceptions", "out", "What was written.", kind = Text)]
fn write(
    context: &Context<'_>,
    /// Whether to write.
    #[port("Write Excel Data", "Write", kind = Boolean)]
    write: &Tree,
    /// The path of the file, of which the name counts.
    #[port("Workbook Path", "Path", kind = Text)]
    path: &Tree,
    /// The name of the sheet.
    #[port("Worksheet Name", "Worksheet", kind = Text, optional)]
    sheet: &Tree,
    /// The headings of the columns.
    #[port("Column Headings", "Headings", kind = Text, optional)]
    headings: &Tree,
    /// A branch for each column.
    #[port("Data", "Data", kind = Generic, optional)]
    data: &Tree,
    /// Whether what is on the sheet goes first; it always does.
    #[port("Clear Sheet", "Clear", kind = Boolean, optional)]
    _clear: &Tree,
) -> Result<Tree, Message> {
    if !is_true(Some(write)) {
        return Ok(Tree::item(Value::text("Nothing is written")));
    }
    let Some(Value::Text(path)) = first(path) else { return Ok(Tree::empty()) };
    let sheet = match first(sheet) {
        Some(Value::Text(name)) => name,
        _ => Shared::from("Sheet1"),
    };
    let mut table = Table::from_columns(context, data);
    if !headings.is_empty() {
        let row = (0..headings.item_count()).map(|at| Cell::of(headings.column().get(at).as_ref(), context));
        table.rows.insert(0, row.collect());
    }
    save(context, &path, &[(sheet.to_string(), table)])
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use katydid_component::testing::Trial;
    use katydid_component::{Files, Outbox};

    fn written(write: bool, outbox: &Arc<Outbox>) -> Vec<String> {
        Trial::of("Excel Write")
            .item(write)
            .item("D:\\work\\doors.csv")
            .default()
            .list(["name", "width"])
            .branches([("{0}", ["north", "south"]), ("{1}", ["0.9", "1.2"])])
            .default()
            .outbox(outbox)
            .texts(0)
    }

    #[test]
    fn columns_are_written_and_read() {
        let outbox = Arc::new(Outbox::default());
        assert_eq!(written(false, &outbox), ["{0}: Nothing is written"]);
        assert!(outbox.take().is_empty());
        assert_eq!(written(true, &outbox), ["{0}: Spreadsheet saved to: doors.csv"]);
        let file = outbox.take().swap_remove(0);
        assert_eq!(file.bytes, b"name,width\r\nnorth,0.9\r\nsouth,1.2\r\n");
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("doors.csv"), &file.bytes).unwrap();
        let read = |on: bool, k: usize| {
            let files = Files::Inside(folder.path().to_path_buf());
            Trial::of("Excel Reader").item(on).item("doors.csv").default().files(files).texts(k)
        };
        assert_eq!(read(true, 1), ["{0}: name, north, south", "{1}: width, 0.9, 1.2"]);
        assert_eq!(read(true, 0), ["{0}: 3 rows"]);
        assert_eq!(read(false, 0), ["{0}: Nothing is read"]);
        assert!(read(false, 1).is_empty());
    }
}
