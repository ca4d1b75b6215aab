//! Places on the canvas for objects that have none.

use std::collections::HashMap;

use super::statement;
use crate::archive::{self, ItemValue, Limits};
use crate::document::{ClusterContent, Document, MOST_NESTED, Object};

/// How far apart columns stand, in pixels.
const COLUMN: f32 = 170.0;
/// How far apart objects stand in a column, in pixels.
const GAP: f32 = 20.0;

/// Gives a place on the canvas to every object that has none, inside clusters too, and tells how many there were. Data
/// flows from left to right: an object stands right of all that it is wired to. Objects that have a place keep it, and
/// the others go below them.
pub fn arrange(document: &mut Document) -> usize {
    arrange_at(document, 0)
}

fn arrange_at(document: &mut Document, depth: usize) -> usize {
    let mut placed = 0;
    let lookup = document.lookup();
    let order = statement::order(&document.objects);
    let mut columns: HashMap<usize, usize> = HashMap::new();
    let top = document.objects.iter().filter_map(|object| object.bounds).map(|[_, y, _, h]| y + h);
    let top =
        top.filter(|y| y.is_finite()).fold(None, |most: Option<f32>, y| Some(most.map_or(y, |m| m.max(y))));
    let mut heights: HashMap<usize, f32> = HashMap::new();
    for at in order {
        let Some(object) = document.objects.get_mut(at) else { continue };
        let sources = object.inputs.iter().flat_map(|port| &port.sources);
        let before = sources.filter_map(|id| columns.get(&lookup.output(*id)?.object).copied());
        let column = before.map(|column| column + 1).max().unwrap_or(0);
        columns.insert(at, column);
        if depth + 1 < MOST_NESTED {
            placed += inside(object, depth);
        }
        if object.pivot.is_some() || object.bounds.is_some() || object.is_annotation() {
            continue;
        }
        let [width, height] = size(object);
        let x = COLUMN * u16::try_from(column).map_or(f32::from(u16::MAX), f32::from);
        let y = heights.entry(column).or_insert_with(|| top.map_or(0.0, |top| top + 3.0 * GAP));
        let place = [x, *y, width, height];
        *y += height + GAP;
        let pivot =
            if object.is_floating() { [x, place[1]] } else { [x + width / 2.0, place[1] + height / 2.0] };
        object.set_place(place, pivot);
        placed += 1;
    }
    placed
}

/// About as large as Grasshopper will draw it.
fn size(object: &Object) -> [f32; 2] {
    let ports = object.inputs.len().max(object.outputs.len()).max(1);
    let rows = u16::try_from(ports).map_or(1000.0, f32::from);
    match object.special() {
        Some(crate::document::Special::Slider(_)) => [160.0, 20.0],
        Some(crate::document::Special::Panel(_)) => [160.0, 80.0],
        _ if object.is_floating() => [60.0, 20.0],
        _ => [90.0, 4.0 + 20.0 * rows],
    }
}

/// The objects inside a cluster.
fn inside(object: &mut Object, depth: usize) -> usize {
    let Some(Ok(ClusterContent::Open { mut document, .. })) = object.cluster(&Limits::default()) else {
        return 0;
    };
    let placed = arrange_at(&mut document, depth + 1);
    if placed > 0
        && let Ok(bytes) = archive::write_gh(&document.to_archive().root)
    {
        object.container_mut().set("ClusterDocument", ItemValue::ByteArray(bytes));
        object.refresh();
    }
    placed
}
