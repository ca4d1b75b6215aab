//! Results in few words: what a face shows of them without asking for the data.

use katydid_component::Level;
use katydid_data::{Tree, text};
use katydid_definition::document::{Object, ids};
use katydid_solver::ObjectReport;

use crate::protocol::{MessageView, ModelLackView, OutputView, Page, ResultView, Row, Structure};
use crate::scripts;

/// How many rows of a panel go out with its result.
const PANEL_ROWS: u32 = 100;
/// The most rows that are given at a time.
const MOST_ROWS: u32 = 10_000;
/// The most letters of an item.
const MOST_LETTERS: usize = 2_000;
/// The most messages of an object that are told.
const MOST_MESSAGES: usize = 50;

/// The result of an object as a face shows it; `style` is that of the panels.
pub fn result_view(object: &Object, report: &ObjectReport, style: &text::Style) -> ResultView {
    let outputs = object.outputs.iter().zip(&report.outputs);
    let is_script = !report.messages.is_empty() && object.script().is_some();
    ResultView {
        id: object.id,
        status: report.status.word().to_owned(),
        messages: report
            .messages
            .iter()
            .take(MOST_MESSAGES)
            .map(|message| MessageView {
                level: level(message.level).to_owned(),
                text: message.text.clone(),
                line: if is_script { scripts::line(&message.text) } else { None },
            })
            .collect(),
        lacks: report
            .messages
            .iter()
            .filter_map(|message| message.lack)
            .map(|lack| ModelLackView {
                kind: lack.kind.name().to_owned(),
                objects: count(lack.objects),
                has_model: lack.has_model,
            })
            .collect(),
        milliseconds: report.time.as_secs_f64() * 1e3,
        outputs: outputs
            .map(|(port, tree)| OutputView {
                port: port.id,
                structure: structure(tree),
                branches: count(tree.branch_count()),
                items: count(tree.item_count()),
            })
            .collect(),
        panel: (object.component == ids::PANEL)
            .then(|| report.outputs.first())
            .flatten()
            .map(|tree| rows(tree, [0, PANEL_ROWS], Digits::Few, style)),
    }
}

fn level(level: Level) -> &'static str {
    match level {
        Level::Remark => "remark",
        Level::Warning => "warning",
        Level::Error => "error",
    }
}

fn count(n: usize) -> u32 {
    u32::try_from(n).unwrap_or(u32::MAX)
}

/// How the wires that carry a tree are drawn.
pub fn structure(tree: &Tree) -> Structure {
    match (tree.branch_count(), tree.item_count()) {
        (_, 0) => Structure::Empty,
        (1, 1) => Structure::Item,
        (1, _) => Structure::List,
        _ => Structure::Tree,
    }
}

/// How many digits numbers have in rows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Digits {
    /// As many as a panel shows.
    Few,
    /// All: what is kept again from such rows is the same.
    All,
}

impl Digits {
    /// All where they are asked for.
    pub fn of(exact: bool) -> Self {
        if exact { Self::All } else { Self::Few }
    }
}

/// Rows of a tree as a panel shows them, from row `from` on `most`: a row for each path, and one for each of its items.
pub fn rows(tree: &Tree, [from, most]: [u32; 2], digits: Digits, style: &text::Style) -> Page {
    let words = match digits {
        Digits::Few => text::item,
        Digits::All => text::exact,
    };
    let total = tree.branch_count().saturating_add(tree.item_count());
    let (mut skip, mut left) = (from as usize, most.min(MOST_ROWS) as usize);
    let mut rows = Vec::new();
    for branch in tree.branches() {
        if left == 0 {
            break;
        }
        let length = branch.len();
        if skip > length {
            skip -= length + 1;
            continue;
        }
        if skip == 0 {
            rows.push(Row::Path { path: branch.path().to_string(), items: count(length) });
            left -= 1;
        }
        let first = skip.saturating_sub(1);
        skip = 0;
        for index in (first..length).take(left) {
            let item = branch.get(index);
            rows.push(Row::Item { index: count(index), text: cut(words(item.as_ref(), style)) });
            left -= 1;
        }
    }
    Page { from, total: count(total), rows }
}

/// A text no longer than a row wants.
fn cut(text: String) -> String {
    match text.char_indices().nth(MOST_LETTERS) {
        Some((at, _)) => format!("{}…", text.get(..at).unwrap_or_default()),
        None => text,
    }
}

#[cfg(test)]
mod tests {
    use katydid_data::{Column, Path, Value};

    use super::*;

    fn tree() -> Tree {
        let list = |path: i32, texts: &[&str]| {
            let items = texts.iter().map(|text| Value::text(*text)).collect();
            Tree::branch_at(Path::from([path].as_slice()), Column::of_values(items, None))
        };
        Tree::merge([&list(0, &["a", "b"]), &list(2, &["c"])])
    }

    #[test]
    fn any_page_is_a_part_of_all_rows() {
        let tree = tree();
        let all = rows(&tree, [0, 100], Digits::All, &Default::default());
        assert_eq!((all.total, all.rows.len()), (5, 5));
        assert!(matches!(&all.rows[3], Row::Path { path, items: 1 } if path == "{2}"));
        for from in 0..7 {
            for most in 0..7 {
                let page = rows(&tree, [from, most], Digits::Few, &Default::default());
                let expected: Vec<Row> =
                    all.rows.iter().skip(from as usize).take(most as usize).cloned().collect();
                assert_eq!(page.rows, expected, "{from} {most}");
            }
        }
    }

    #[test]
    fn wires_are_drawn_by_structure() {
        assert_eq!(structure(&tree()), Structure::Tree);
        assert_eq!(structure(&Tree::empty()), Structure::Empty);
        assert_eq!(structure(&Tree::branch_at(Path::zero(), Column::nulls(1))), Structure::Item);
    }
}
