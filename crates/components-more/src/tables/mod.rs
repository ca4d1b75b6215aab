//! Tables of spreadsheets: read from .xlsx, .xls and .csv files, written as .xlsx and .csv.

mod read;
#[cfg(test)]
mod tests;
mod write;

use std::sync::Arc as Shared;

use katydid_component::{Context, Message};
use katydid_data::{DateTime, Path, Tree, TreeBuilder, Value, text};

pub(crate) use write::save;

/// What a cell holds.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Cell {
    Empty,
    Text(Shared<str>),
    Number(f64),
    Boolean(bool),
    Moment(DateTime),
}

/// The rows of a sheet; each is as long as the longest.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Table {
    pub(crate) rows: Vec<Vec<Cell>>,
}

/// Which sheet of a file is meant.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Which {
    /// By its number, the first one is 1.
    Number(i32),
    /// By its name, whatever the case of letters.
    Name(Shared<str>),
}

impl Which {
    /// The sheet that an item names: a number, a text of digits, or a name.
    pub(crate) fn of(item: Option<&Value>) -> Self {
        match item {
            Some(Value::Integer(number)) => Self::Number(*number),
            Some(Value::Number(number)) => Self::Number(number.round() as i32),
            Some(Value::Text(name)) => match name.trim().parse() {
                Ok(number) => Self::Number(number),
                Err(_) => Self::Name(name.clone()),
            },
            _ => Self::Number(1),
        }
    }

    /// The place of the sheet among some names.
    #[cfg(feature = "spreadsheets")]
    fn find(&self, names: &[String]) -> Result<usize, Message> {
        let found = match self {
            Self::Number(number) => usize::try_from(*number)
                .ok()
                .and_then(|n| n.checked_sub(1))
                .filter(|place| *place < names.len()),
            Self::Name(name) => names.iter().position(|own| own.to_lowercase() == name.to_lowercase()),
        };
        let told = || match self {
            Self::Number(number) => format!("no sheet {number}"),
            Self::Name(name) => format!("no sheet '{name}'"),
        };
        found.ok_or_else(|| {
            Message::error(format!("The file has {}: its sheets are {}", told(), names.join(", ")))
        })
    }
}

impl Cell {
    /// As an item of data; none for an empty cell.
    pub(crate) fn value(&self) -> Option<Value> {
        Some(match self {
            Self::Empty => return None,
            Self::Text(text) => Value::Text(text.clone()),
            Self::Number(number) => Value::Number(*number),
            Self::Boolean(yes) => Value::Boolean(*yes),
            Self::Moment(moment) => Value::Time(*moment),
        })
    }

    /// As a text; an empty one for an empty cell.
    pub(crate) fn text(&self, context: &Context<'_>) -> Shared<str> {
        match self.value() {
            None => "".into(),
            Some(Value::Text(text)) => text,
            // In full, not with the few digits of a panel.
            Some(Value::Number(number)) => number.to_string().into(),
            Some(value) => text::value(&value, &context.style()).into(),
        }
    }

    /// What stands in a cell for an item of data.
    pub(crate) fn of(item: Option<&Value>, context: &Context<'_>) -> Self {
        match item {
            None => Self::Empty,
            Some(Value::Number(number)) if number.is_finite() => Self::Number(*number),
            Some(Value::Integer(number)) => Self::Number(f64::from(*number)),
            Some(Value::Boolean(yes)) => Self::Boolean(*yes),
            Some(Value::Text(text)) => Self::Text(text.clone()),
            Some(Value::Time(moment)) => Self::Moment(*moment),
            Some(other) => Self::Text(text::value(other, &context.style()).into()),
        }
    }
}

impl Table {
    /// Reads a sheet of a file; its kind is told by its first bytes, and .csv by its name.
    ///
    /// # Errors
    /// The message to show when the file may not be read, is no spreadsheet, has no such sheet, or is too large.
    pub(crate) fn read(context: &Context<'_>, path: &str, which: &Which) -> Result<Self, Message> {
        read::read(context, path, which)
    }

    /// A branch a row.
    pub(crate) fn from_rows(context: &Context<'_>, tree: &Tree) -> Self {
        let row = |branch: katydid_data::Branch<'_>| {
            branch.iter().map(|item| Cell::of(item.as_ref(), context)).collect()
        };
        Self { rows: tree.branches().map(row).collect() }
    }

    /// A branch a column.
    pub(crate) fn from_columns(context: &Context<'_>, tree: &Tree) -> Self {
        Self::from_rows(context, tree).turned()
    }

    /// Rows as columns.
    pub(crate) fn turned(&self) -> Self {
        let height = self.rows.iter().map(Vec::len).max().unwrap_or(0);
        let cell = |row: &Vec<Cell>, at: usize| row.get(at).cloned().unwrap_or(Cell::Empty);
        Self { rows: (0..height).map(|at| self.rows.iter().map(|row| cell(row, at)).collect()).collect() }
    }

    /// The number of cells.
    pub(crate) fn size(&self) -> usize {
        self.rows.iter().map(Vec::len).sum()
    }

    /// A tree with a branch for each row at its number, of what is made of the cells.
    pub(crate) fn tree(&self, item: impl Fn(&Cell) -> Option<Value>) -> Tree {
        let mut builder = TreeBuilder::<Value>::new();
        for (number, row) in (0..).zip(&self.rows) {
            builder.branch(Path::from([number]));
            row.iter().for_each(|cell| builder.push(item(cell)));
        }
        builder.finish()
    }
}
