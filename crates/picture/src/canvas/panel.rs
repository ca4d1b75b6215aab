//! Panels: a text, or the data that comes in, with its paths and indices.

use katydid_data::{Tree, Value, text};
use katydid_definition::document::special::Panel;
use katydid_geometry::Matrix;

use super::capsule::{grips, wrapped};
use super::{Placed, theme};
use crate::drawing::{Anchor, Item, Label, Path, Shape, blend};
use crate::font;
use katydid_scene::colour::of_archive as colour;

const SIZE: f64 = 9.5;
const ROW: f64 = 12.5;
/// The height of the strip with the name.
const HEAD: f64 = 14.0;
/// No panel is looked at farther than this: none is so high.
const MOST_ROWS: usize = 4000;

enum Row {
    Path(String),
    /// An item's index, where it is the first row of one that has an index, and its text.
    Item(Option<usize>, String),
}

pub(super) fn draw(one: &Placed<'_>, panel: &Panel) -> Option<Vec<Item>> {
    let [x, y, w, h] = one.frame.rect;
    let paper = panel.colour.map_or(theme::PANEL, colour);
    let ink = theme::INK;
    let dim = blend(paper, ink, 0.6);
    let mut items = vec![
        Shape::filled(Path::rounded([x, y, w, h], 3.0), paper).outlined(blend(paper, ink, 0.45), 1.0).into(),
    ];
    let object = one.object;
    let wired = object.inputs.iter().any(|port| !port.sources.is_empty());
    let tree = one.output(0).filter(|_| wired);
    let one_path = tree.filter(|tree| tree.branch_count() == 1 && panel.draw_paths);
    let name = object.nickname.trim();
    let named = !name.is_empty() && name != "Panel" && name != object.name;
    let head = if named || one_path.is_some() { HEAD.min(h) } else { 0.0 };
    if head > 0.0 {
        let strip = Path::rounded([x + 0.5, y + 0.5, w - 1.0, head], 2.5);
        items.push(Shape::filled(strip, blend(paper, ink, 0.1)).into());
        let path =
            one_path.and_then(|tree| tree.paths().first()).map(ToString::to_string).unwrap_or_default();
        let used = font::width(&path, SIZE - 1.0) + 8.0;
        if named {
            let name = font::fitted(name, SIZE, w - used - 8.0);
            items.push(Label::new([x + 6.0, y + 10.5], name, SIZE, ink).bold().into());
        }
        let label = Label::new([x + w - 6.0, y + 10.5], path, SIZE - 1.0, dim);
        items.push(label.anchored(Anchor::End).into());
    }
    let top = y + head + 2.0;
    let most = (((h - head - 3.0) / ROW).floor().max(0.0) as usize).min(MOST_ROWS);
    let gutter = match tree {
        Some(tree) if panel.draw_indices => {
            let longest = tree.branches().map(|branch| branch.len()).max().unwrap_or(0);
            font::width(&longest.saturating_sub(1).to_string(), SIZE - 1.0) + 8.0
        }
        _ => 0.0,
    };
    let room = w - gutter - 12.0;
    let (rows, all) = match tree {
        Some(tree) => data(one, tree, panel, room, most),
        None => {
            let lines = panel.text.lines().flat_map(|line| folded(line, panel.wrap, room));
            (lines.take(most + 1).map(|line| Row::Item(None, line)).collect(), panel.text.lines().count())
        }
    };
    let cut = rows.len() > most;
    let shown = if cut { most.saturating_sub(1) } else { rows.len() };
    for (k, row) in rows.iter().take(shown).enumerate() {
        let base = top + ROW * k as f64 + 0.5 * ROW + 0.35 * SIZE;
        match row {
            Row::Path(path) => {
                let label = Label::new([x + w - 6.0, base], path.clone(), SIZE - 1.0, dim);
                items.push(label.anchored(Anchor::End).into());
            }
            Row::Item(index, text) => {
                if let Some(index) = index {
                    let at = [x + gutter, base];
                    let label = Label::new(at, index.to_string(), SIZE - 1.0, dim).anchored(Anchor::End);
                    items.push(label.into());
                }
                items.push(aligned(panel, [x + gutter + 6.0, base], room, text));
            }
        }
    }
    if cut && most > 0 {
        let base = top + ROW * shown as f64 + 0.5 * ROW + 0.35 * SIZE;
        let label = Label::new([x + 0.5 * w, base], format!("… of {all}"), SIZE - 1.0, dim);
        items.push(label.anchored(Anchor::Middle).into());
    }
    items.extend(grips(one));
    Some(items)
}

fn aligned(panel: &Panel, [x, y]: [f64; 2], room: f64, text: &str) -> Item {
    let (at, anchor) = match panel.alignment {
        1 => ([x + 0.5 * room, y], Anchor::Middle),
        2 => ([x + room, y], Anchor::End),
        _ => ([x, y], Anchor::Start),
    };
    Label::new(at, text, SIZE, theme::INK).anchored(anchor).into()
}

/// The rows of a tree, no more than `most` and one; and how many items it has.
fn data(one: &Placed<'_>, tree: &Tree, panel: &Panel, room: f64, most: usize) -> (Vec<Row>, usize) {
    let mut rows = Vec::new();
    let paths = panel.draw_paths && tree.branch_count() > 1;
    for branch in tree.branches() {
        if rows.len() > most {
            break;
        }
        if paths {
            rows.push(Row::Path(branch.path().to_string()));
        }
        for (k, item) in branch.iter().enumerate() {
            if rows.len() > most {
                break;
            }
            let mut whole = text::item(item.as_ref(), &one.style);
            if let Some(Value::Matrix(matrix)) = &item {
                whole.push_str(&numbers(matrix, most));
            }
            let lines = whole.lines().flat_map(|line| folded(line, panel.wrap, room)).enumerate();
            let index = |line: usize| Some(k).filter(|_| line == 0 && panel.draw_indices);
            rows.extend(lines.take(most + 1).map(|(line, text)| Row::Item(index(line), text)));
        }
    }
    (rows, tree.item_count())
}

/// The numbers of a matrix, a line a row.
fn numbers(matrix: &Matrix, most: usize) -> String {
    let rows = matrix.values().chunks(matrix.columns().max(1)).take(most);
    let line = |row: &[f64]| row.iter().map(|x| text::number(*x)).collect::<Vec<_>>().join("   ");
    rows.map(|row| format!("\n{}", line(row))).collect()
}

/// A line in the panel's width: in several rows where it wraps, else cut.
fn folded(line: &str, wrap: bool, room: f64) -> Vec<String> {
    if !wrap || font::width(line, SIZE) <= room {
        return vec![font::fitted(line, SIZE, room)];
    }
    wrapped(line, SIZE, room, usize::MAX)
}
