//! Wires: one line for an item, two for a list, two broken ones for a tree, orange for none.

use katydid_data::{Colour, Tree};
use katydid_definition::document::{Document, WireDisplay};

use super::{Placed, theme};
use crate::drawing::{Item, Path, Shape, Stroke, blend};

/// The structure of what a wire carries.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Load {
    Nothing,
    Item,
    List,
    Tree,
}

fn load(tree: Option<&Tree>) -> Load {
    match tree {
        None => Load::Nothing,
        Some(tree) if tree.is_empty() || tree.item_count() == 0 => Load::Nothing,
        Some(tree) if tree.branch_count() > 1 => Load::Tree,
        Some(tree) if tree.item_count() > 1 => Load::List,
        Some(_) => Load::Item,
    }
}

pub(super) fn all(document: &Document, placed: &[Option<Placed<'_>>], ground: Colour) -> Vec<Item> {
    let lookup = document.lookup();
    let mut items = Vec::new();
    for wire in document.wires() {
        let Some(from) = lookup.output(wire.from) else { continue };
        let get = |k: usize| placed.get(k).and_then(Option::as_ref);
        let (Some(source), Some(target)) = (get(from.object), get(wire.object)) else { continue };
        let (Some(a), Some(b)) = (source.frame.outputs.get(from.port), target.frame.inputs.get(wire.input))
        else {
            continue;
        };
        let display = target.object.inputs.get(wire.input).map(|port| port.wire_display);
        let load = load(source.output(from.port));
        match display.unwrap_or_default() {
            WireDisplay::Normal => items.extend(drawn(*a, *b, load, ground)),
            WireDisplay::Faint => {
                let colour = blend(ground, colour(load), 0.45);
                items.push(Shape::stroked(path(*a, *b), colour, 0.8).into());
            }
            WireDisplay::Hidden => items.extend([wireless(*a, 1.0), wireless(*b, -1.0)]),
        }
    }
    items
}

fn colour(load: Load) -> Colour {
    if load == Load::Nothing { theme::EMPTY_WIRE } else { theme::WIRE }
}

fn drawn([ax, ay]: [f64; 2], [bx, by]: [f64; 2], load: Load, ground: Colour) -> Vec<Item> {
    let path = path([ax, ay], [bx, by]);
    let stroke = |colour: Colour, width: f64| {
        let dashes = if load == Load::Tree { vec![7.0, 4.0] } else { Vec::new() };
        let stroke = Some(Stroke { colour, width, dashes });
        Shape { path: path.clone(), fill: None, stroke }.into()
    };
    let colour = colour(load);
    match load {
        Load::Nothing => vec![stroke(colour, 1.4)],
        Load::Item => vec![stroke(colour, 1.5)],
        // Two lines are a broad one with its middle taken out.
        Load::List | Load::Tree => vec![stroke(colour, 4.0), stroke(ground, 1.6)],
    }
}

/// A curve that leaves to the right and comes in from the left.
fn path([ax, ay]: [f64; 2], [bx, by]: [f64; 2]) -> Path {
    let reach = if bx >= ax { 0.5 * (bx - ax) } else { 0.3 * (ax - bx) + 0.2 * (by - ay).abs() };
    let reach = reach.max(0.25 * (by - ay).abs().min(120.0)).max(8.0);
    Path::cubic([[ax, ay], [ax + reach, ay], [bx - reach, by], [bx, by]])
}

/// The sign of a wire that is not drawn: two small waves before its port.
fn wireless([x, y]: [f64; 2], side: f64) -> Item {
    let mut waves = Path::default();
    for r in [5.0, 8.0] {
        let arc = Path::cubic([
            [x + side * r * 0.8, y - r * 0.7],
            [x + side * (r * 1.15), y - r * 0.25],
            [x + side * (r * 1.15), y + r * 0.25],
            [x + side * r * 0.8, y + r * 0.7],
        ]);
        waves.extend(arc);
    }
    Shape::stroked(waves, theme::WIRE, 1.0).into()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn loads_are_told_apart() {
        let tree = |n: usize| Tree::list(vec![1.0; n]);
        assert_eq!(load(None), Load::Nothing);
        assert_eq!([0, 1, 2].map(|n| load(Some(&tree(n)))), [Load::Nothing, Load::Item, Load::List]);
        assert_eq!(load(Some(&tree(2).graft())), Load::Tree);
    }
}
