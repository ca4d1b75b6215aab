//! Spreadsheets.

use katydid_component::{Context, ManyTrees, Message, component};
use katydid_data::{Tree, Value};

use crate::model_objects::first;
use crate::tables::{Table, Which, save};

/// Reads a sheet of a spreadsheet: a branch for each row, with the text of each of its cells up to the last column that is used.
/// .xlsx, .xlsm, .xls and .csv files are read. Which files may be read is set where the definition runs. Stands for gHowl's
/// Spreadsheet Reader.
#[component(
    "73cb7ac5-de4f-486e-8243-e797fbcb45b0",
    name = "Spreadsheet Reader",
    nick = "#R",
    at = "gHowl/Spreadsheet"
)]
#[output("Message", "M", "Nothing.", kind = Text)]
#[output("Data", "D", "A branch for each row.", kind = Text)]
fn read(
    context: &Context<'_>,
    /// The path of the file.
    #[port("Path", "P", kind = Text)]
    path: &Tree,
    /// The number of the sheet, the first one is 1.
    #[port("Sheet", "S", kind = Integer, optional)]
    sheet: &Tree,
) -> Result<(Tree, Tree), Message> {
    let Some(Value::Text(path)) = first(path) else { return Ok((Tree::empty(), Tree::empty())) };
    let table = Table::read(context, &path, &Which::of(first(sheet).as_ref()))?;
    Ok((Tree::empty(), table.tree(|cell| Some(Value::Text(cell.text(context))))))
}

/// Writes a spreadsheet with a sheet for each input, whose short name is that of the sheet: a row for each branch. The name of the
/// file ends in .xlsx, or in .csv for the first sheet alone. Stands for gHowl's Spreadsheet Writer. Files are written by
/// `katydid run --write FOLDER`, into that folder.
#[component(
    "70e5b445-4391-4609-a822-0834fc544fa3",
    name = "Spreadsheet Writer",
    nick = "#W",
    at = "gHowl/Spreadsheet",
    also("85d972f4-1d45-4f5a-b0c1-da90a4d94f55")
)]
#[output("Info", "I", "What was written.", kind = Text)]
fn write(
    context: &Context<'_>,
    /// The path of the file, of which the name counts.
    #[port("Path", "P", kind = Text)]
    path: &Tree,
    /// The rows of a sheet; any number of inputs.
    #[port("Sheet Data 1", "Sheet 1", kind = Generic, optional)]
    sheets: ManyTrees<'_>,
) -> Result<Tree, Message> {
    let Some(Value::Text(path)) = first(path) else { return Ok(Tree::empty()) };
    let named = |(place, tree): (usize, &&Tree)| {
        let name = context.input_name(place + 1).trim();
        let name = if name.is_empty() { format!("Sheet {}", place + 1) } else { name.to_owned() };
        (name, Table::from_rows(context, tree))
    };
    let sheets: Vec<(String, Table)> = sheets.iter().enumerate().map(named).collect();
    save(context, &path, &sheets)
}
