//! Places on the canvas for objects that have none.

use std::collections::HashMap;

use super::statement;
use crate::archive::{self, ItemValue, Limits};
use crate::document::{ClusterContent, Document, MOST_NESTED, Object, Special};

/// How far apart columns stand, in pixels: the wires between them run there.
const WIRES: f32 = 60.0;
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
    let order = statement::order(&document.objects);
    let columns = columns(document, &order);
    let lefts = lefts(document, &columns);
    let top = document.objects.iter().filter_map(|object| object.bounds).map(|[_, y, _, h]| y + h);
    let top =
        top.filter(|y| y.is_finite()).fold(None, |most: Option<f32>, y| Some(most.map_or(y, |m| m.max(y))));
    let mut heights: HashMap<usize, f32> = HashMap::new();
    for at in order {
        let Some(object) = document.objects.get_mut(at) else { continue };
        if depth + 1 < MOST_NESTED {
            placed += inside(object, depth);
        }
        if !has_no_place(object) {
            continue;
        }
        let column = columns.get(&at).copied().unwrap_or(0);
        let [width, height] = size(object);
        let x = lefts.get(column).copied().unwrap_or(0.0);
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

/// Whether an object waits for a place.
fn has_no_place(object: &Object) -> bool {
    object.pivot.is_none() && object.bounds.is_none() && !object.is_annotation()
}

/// The column of every object: right of all that it is wired to.
fn columns(document: &Document, order: &[usize]) -> HashMap<usize, usize> {
    let lookup = document.lookup();
    let mut columns: HashMap<usize, usize> = HashMap::new();
    for &at in order {
        let Some(object) = document.objects.get(at) else { continue };
        let sources = object.inputs.iter().flat_map(|port| &port.sources);
        let before = sources.filter_map(|id| columns.get(&lookup.output(*id)?.object).copied());
        let column = before.map(|column| column + 1).max().unwrap_or(0);
        columns.insert(at, column);
    }
    columns
}

/// Where each column begins: behind the widest object of the one before it.
fn lefts(document: &Document, columns: &HashMap<usize, usize>) -> Vec<f32> {
    let mut widths = vec![0.0_f32; columns.values().max().map_or(0, |last| last + 1)];
    for (at, object) in document.objects.iter().enumerate().filter(|(_, object)| has_no_place(object)) {
        if let Some(width) = columns.get(&at).and_then(|column| widths.get_mut(*column)) {
            *width = width.max(size(object)[0]);
        }
    }
    let mut left = 0.0;
    let begin = |width: &f32| {
        let here = left;
        left += width + if *width > 0.0 { WIRES } else { 0.0 };
        here
    };
    widths.iter().map(begin).collect()
}

/// About as large as Grasshopper will draw it.
fn size(object: &Object) -> [f32; 2] {
    let ports = object.inputs.len().max(object.outputs.len()).max(1);
    let rows = u16::try_from(ports).map_or(1000.0, f32::from);
    let name = wide(object.title());
    match object.special() {
        // Its name stands before the track.
        Some(Special::Slider(_)) => [(110.0 + name).clamp(160.0, 300.0), 20.0],
        Some(Special::Panel(panel)) => panel_size(&panel.text, name),
        Some(Special::ValueList(list)) => {
            let longest = list.items.iter().map(|item| wide(&item.name)).fold(0.0, f32::max);
            [(name + longest + 50.0).clamp(90.0, 300.0), 20.0]
        }
        _ if object.is_floating() => [(name + 20.0).clamp(60.0, 200.0), 20.0],
        _ => [(name + 60.0).clamp(90.0, 180.0), 4.0 + 20.0 * rows],
    }
}

/// As large as a text wants to be read, within what is usual.
fn panel_size(text: &str, name: f32) -> [f32; 2] {
    let longest = text.lines().map(wide).fold(name, f32::max);
    let lines = u16::try_from(text.lines().count()).map_or(f32::MAX, f32::from);
    [(longest + 24.0).clamp(160.0, 320.0), (lines * 12.5 + 30.0).clamp(80.0, 300.0)]
}

/// About how wide a text is, in pixels.
fn wide(text: &str) -> f32 {
    u16::try_from(text.chars().count()).map_or(f32::MAX, |n| 5.6 * f32::from(n))
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
