use std::fmt;

use katydid_data::cast::parse_number;
use katydid_data::{Tree, Value, text};

use crate::thresholds::{MOST_CELL_BYTES, MOST_CELL_ITEMS};

/// What a row of a study's table has in a column.
#[derive(Debug, Clone, PartialEq)]
pub enum Cell {
    /// Nothing, or null.
    Null,
    /// True or false.
    Boolean(bool),
    /// A number; it may be NaN or infinite in results.
    Number(f64),
    /// A text; lists and trees as JSON.
    Text(String),
}

impl Cell {
    /// The number, where it is one.
    pub fn number(&self) -> Option<f64> {
        match self {
            Self::Number(x) => Some(*x),
            Self::Boolean(on) => Some(f64::from(u8::from(*on))),
            _ => None,
        }
    }

    /// A cell of a table of texts: what reads as a number is one.
    pub fn of_text(text: &str) -> Self {
        let text = text.trim();
        match text {
            "" => Self::Null,
            "true" | "True" => Self::Boolean(true),
            "false" | "False" => Self::Boolean(false),
            _ => text
                .parse()
                .ok()
                .filter(|x: &f64| x.is_finite())
                .map_or_else(|| Self::Text(text.to_owned()), Self::Number),
        }
    }

    /// A value of a plan.
    pub(crate) fn of_json(value: &serde_json::Value) -> Self {
        match value {
            serde_json::Value::Null => Self::Null,
            serde_json::Value::Bool(on) => Self::Boolean(*on),
            serde_json::Value::Number(x) => x.as_f64().map_or(Self::Null, Self::Number),
            serde_json::Value::String(text) => Self::Text(text.clone()),
            other => Self::Text(other.to_string()),
        }
    }

    /// The value in JSON, which has no NaN and no infinity: those are texts.
    pub fn json(&self) -> serde_json::Value {
        match self {
            Self::Null => serde_json::Value::Null,
            Self::Boolean(on) => (*on).into(),
            Self::Number(x) if !x.is_finite() => x.to_string().into(),
            Self::Number(x) => (*x).into(),
            Self::Text(text) => text.as_str().into(),
        }
    }

    /// What an output gives: one item as itself, a list as a JSON array, several branches as a JSON object from path to
    /// list. What is longer than a cell holds is told by its count.
    pub fn of_tree(tree: &Tree) -> Self {
        if tree.item_count() == 0 {
            return Self::Null;
        }
        if tree.item_count() == 1 && tree.branch_count() == 1 {
            let item = tree.branch(0).and_then(|branch| branch.get(0));
            return item.as_ref().map_or(Self::Null, Self::of_value);
        }
        let too_long =
            || Self::Text(format!("{} items in {} branches", tree.item_count(), tree.branch_count()));
        if tree.item_count() > MOST_CELL_ITEMS {
            return too_long();
        }
        let mut lists = tree.branches().map(|branch| {
            let items: Vec<serde_json::Value> = branch.iter().map(|item| json(item.as_ref())).collect();
            (branch.path().to_string(), items)
        });
        let text = if tree.branch_count() == 1 {
            lists.next().map(|(_, items)| serde_json::Value::from(items).to_string()).unwrap_or_default()
        } else {
            let members: Vec<String> = lists
                .map(|(path, items)| {
                    format!("{}:{}", serde_json::Value::from(path), serde_json::Value::from(items))
                })
                .collect();
            format!("{{{}}}", members.join(","))
        };
        if text.len() > MOST_CELL_BYTES { too_long() } else { Self::Text(text) }
    }

    fn of_value(value: &Value) -> Self {
        match value {
            Value::Number(x) => Self::Number(*x),
            Value::Integer(i) => Self::Number(f64::from(*i)),
            Value::Boolean(on) => Self::Boolean(*on),
            Value::Text(text) => parse_number(text).map_or_else(|| short(text), Self::Number),
            other => short(&text::exact(Some(other), &text::Style::default())),
        }
    }

    /// Cells of a point as bytes, to hand them to another process.
    pub fn to_bytes(cells: &[Self]) -> Vec<u8> {
        let mut bytes = Vec::with_capacity(16 * cells.len());
        cells.iter().for_each(|cell| cell.encode(&mut bytes));
        bytes
    }

    /// The cells of [`to_bytes`](Self::to_bytes); `None` where the bytes are damaged.
    #[cfg(feature = "studies")]
    pub fn of_bytes(bytes: &[u8]) -> Option<Vec<Self>> {
        crate::record::cells(bytes)
    }

    /// The bytes that stand for it in a store and in keys.
    pub(crate) fn encode(&self, out: &mut Vec<u8>) {
        match self {
            Self::Null => out.push(0),
            Self::Boolean(on) => out.extend([1, u8::from(*on)]),
            Self::Number(x) => {
                out.push(2);
                out.extend(x.to_bits().to_le_bytes());
            }
            Self::Text(text) => {
                out.push(3);
                out.extend(u32::try_from(text.len()).unwrap_or(u32::MAX).to_le_bytes());
                out.extend(text.as_bytes());
            }
        }
    }
}

fn short(text: &str) -> Cell {
    let end = (0..=text.len().min(MOST_CELL_BYTES)).rev().find(|at| text.is_char_boundary(*at)).unwrap_or(0);
    Cell::Text(text.get(..end).unwrap_or_default().to_owned())
}

fn json(item: Option<&Value>) -> serde_json::Value {
    item.map_or(serde_json::Value::Null, |item| Cell::of_value(item).json())
}

impl fmt::Display for Cell {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Null => Ok(()),
            Self::Boolean(on) => on.fmt(f),
            // The shortest digits that read back as the same number.
            Self::Number(x) => x.fmt(f),
            Self::Text(text) => text.fmt(f),
        }
    }
}

#[cfg(test)]
mod tests {
    use katydid_data::{Column, Path};

    use super::*;

    #[test]
    fn lists_and_trees_are_json() {
        assert_eq!(Cell::of_tree(&Tree::empty()), Cell::Null);
        assert_eq!(Cell::of_tree(&Tree::item(Value::Number(0.1))), Cell::Number(0.1));
        assert_eq!(Cell::of_tree(&Tree::item(Value::from("2.50"))), Cell::Number(2.5));
        assert_eq!(Cell::of_tree(&Tree::list(vec![1.0, 2.5])), Cell::Text("[1.0,2.5]".to_owned()));
        let list = |path: i32| Tree::branch_at(Path::from([path].as_slice()), Column::nulls(1));
        let tree = Tree::merge([&list(0), &list(3)]);
        assert_eq!(Cell::of_tree(&tree), Cell::Text("{\"{0}\":[null],\"{3}\":[null]}".to_owned()));
        let long = Tree::list(vec![0.0; 2_000_000]);
        assert_eq!(Cell::of_tree(&long), Cell::Text("2000000 items in 1 branches".to_owned()));
    }

    #[test]
    fn texts_of_tables_are_numbers_where_they_read_as_such() {
        assert_eq!(Cell::of_text(" 1e3 "), Cell::Number(1000.0));
        assert_eq!(Cell::of_text("nan"), Cell::Text("nan".to_owned()));
        assert_eq!(Cell::of_text(""), Cell::Null);
    }
}
