//! Objects that draw their data as a chart: lines, bars, sectors, pictures.

use std::f64::consts::TAU;

use katydid_data::{Colour, Tree, Value, text};
use katydid_definition::document::ids;
use katydid_elementary::Elementary;
use katydid_geometry::{BoundingBox, Mesh};

use super::capsule::{grips, middle, window};
use super::{Placed, theme};
use crate::drawing::{Anchor, Item, Label, Path, Shape, blend};
use crate::font;

/// More values than this are not drawn: nobody could tell them apart.
const MOST: usize = 10_000;
/// More sectors than this become one for all the rest.
const MOST_SECTORS: usize = 24;
/// More pictures than this are not drawn.
const MOST_PICTURES: usize = 64;
/// More faces of a picture than this are not drawn.
const MOST_FACES: usize = 65_536;

/// Colours that neighbours can be told apart by.
const PALETTE: [Colour; 8] = [
    Colour::rgb(66, 110, 180),
    Colour::rgb(224, 132, 60),
    Colour::rgb(92, 158, 88),
    Colour::rgb(190, 70, 80),
    Colour::rgb(130, 104, 172),
    Colour::rgb(140, 106, 84),
    Colour::rgb(206, 122, 178),
    Colour::rgb(120, 126, 134),
];

fn paint(k: usize) -> Colour {
    PALETTE.get(k % PALETTE.len()).copied().unwrap_or(theme::EDGE)
}

/// The chart of an object that draws one.
pub(super) fn draw(one: &Placed<'_>) -> Option<Vec<Item>> {
    let chart = match one.object.component {
        ids::QUICK_GRAPH => lines,
        ids::BAR_GRAPH => bars,
        ids::PIE_CHART => sectors,
        ids::VALUE_TRACKER => tracker,
        ids::IMAGE_GALLERY => gallery,
        _ => return None,
    };
    let history = one.report.and_then(|report| report.history());
    let tree = history.or_else(|| one.output(0))?;
    let (mut items, rect) = window(one);
    items.extend(chart(one, tree, rect));
    items.extend(grips(one));
    Some(items)
}

/// The finite numbers of each branch.
fn numbers(tree: &Tree) -> Vec<Vec<f64>> {
    let number = |value: Value| match value {
        Value::Number(x) => Some(x),
        Value::Integer(n) => Some(f64::from(n)),
        _ => None,
    };
    let of = |branch: katydid_data::Branch<'_>| {
        branch.iter().flatten().filter_map(number).filter(|x| x.is_finite()).take(MOST).collect()
    };
    tree.branches().map(of).filter(|row: &Vec<f64>| !row.is_empty()).take(MOST).collect()
}

fn extent<'a>(all: impl Iterator<Item = &'a f64>) -> [f64; 2] {
    all.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], &x| [low.min(x), high.max(x)])
}

fn lines(_: &Placed<'_>, tree: &Tree, [x, y, w, h]: [f64; 4]) -> Vec<Item> {
    let numbers: Vec<f64> = numbers(tree).into_iter().flatten().take(MOST).collect();
    let [low, high] = extent(numbers.iter());
    let range = if high > low { high - low } else { 1.0 };
    let last = numbers.len().saturating_sub(1).max(1) as f64;
    let at = |(k, n): (usize, &f64)| [x + w * k as f64 / last, y + h * (1.0 - (n - low) / range)];
    vec![Shape::stroked(Path::polyline(numbers.iter().enumerate().map(at)), theme::RED, 1.2).into()]
}

/// A bar for each number, from zero up or down; the branches have a colour each.
fn bars(_: &Placed<'_>, tree: &Tree, [x, y, w, h]: [f64; 4]) -> Vec<Item> {
    let rows = numbers(tree);
    let count = rows.iter().map(Vec::len).sum::<usize>().min(MOST);
    let [low, high] = extent(rows.iter().flatten());
    let (low, high) = (low.min(0.0), high.max(0.0));
    let range = if high > low { high - low } else { 1.0 };
    let level = |n: f64| y + h * (high - n) / range;
    let step = w / count.max(1) as f64;
    let gap = if step > 3.0 { 1.0 } else { 0.0 };
    let coloured = rows.iter().enumerate().flat_map(|(k, row)| row.iter().map(move |n| (paint(k), *n)));
    let mut items: Vec<Item> = Vec::new();
    for (k, (colour, n)) in coloured.take(MOST).enumerate() {
        let (top, bottom) = (level(n.max(0.0)), level(n.min(0.0)));
        let bar = Path::rectangle([x + step * k as f64 + 0.5 * gap, top, step - gap, bottom - top]);
        items.push(Shape::filled(bar, colour).into());
    }
    let zero = level(0.0);
    items.push(Shape::stroked(Path::polyline([[x, zero], [x + w, zero]]), theme::EDGE, 0.8).into());
    items
}

/// The parts of a whole: numbers by their size, all else by how often each is there.
fn parts(one: &Placed<'_>, tree: &Tree) -> Vec<(String, f64)> {
    let values: Vec<Value> = tree.column().iter().flatten().take(MOST).collect();
    let number = |value: &Value| match value {
        Value::Number(x) => Some(*x),
        Value::Integer(n) => Some(f64::from(*n)),
        _ => None,
    };
    let sizes: Option<Vec<f64>> = values.iter().map(number).collect();
    if let Some(sizes) = sizes {
        // A part is as large as its number, whatever its sign.
        let part = |n: f64| (text::number((n * 1000.0).round() / 1000.0), n.abs());
        return sizes.into_iter().filter(|n| n.is_finite() && *n != 0.0).map(part).collect();
    }
    let mut counts: Vec<(String, f64)> = Vec::new();
    for value in &values {
        let words = text::value(value, &one.style);
        let place = counts.iter().position(|(known, _)| *known == words);
        match place.and_then(|place| counts.get_mut(place)) {
            Some((_, count)) => *count += 1.0,
            None => counts.push((words, 1.0)),
        }
    }
    counts
}

fn sectors(one: &Placed<'_>, tree: &Tree, [x, y, w, h]: [f64; 4]) -> Vec<Item> {
    let mut parts = parts(one, tree);
    if parts.len() > MOST_SECTORS {
        let rest: f64 = parts.drain(MOST_SECTORS - 1..).map(|(_, n)| n).sum();
        parts.push(("…".to_owned(), rest));
    }
    let whole: f64 = parts.iter().map(|(_, n)| n).sum();
    let mut items = Vec::new();
    if !(whole > 0.0 && whole.is_finite()) {
        return items;
    }
    let (centre, r) = ([x + 0.5 * w, y + 0.5 * h], 0.46 * w.min(h));
    let on = |turn: f64, r: f64| {
        // From the top, the way of clocks.
        let (sin, cos) = (TAU * turn).sine_cosine();
        [centre[0] + r * sin, centre[1] - r * cos]
    };
    let mut labels = Vec::new();
    let mut from = 0.0;
    for (k, (name, size)) in parts.iter().enumerate() {
        let share = size / whole;
        let steps = ((share * 96.0).ceil() as usize).max(1);
        let rim = (0..=steps).map(|i| on(from + share * i as f64 / steps as f64, r));
        let path = if parts.len() == 1 {
            Path::circle(centre, r)
        } else {
            Path::polygon(std::iter::once(centre).chain(rim))
        };
        items.push(Shape::filled(path, paint(k)).outlined(theme::PAPER, 1.0).into());
        let room = TAU * share * 0.65 * r;
        if share > 0.04 && room > 14.0 {
            let words = font::fitted(name, theme::PORT, (0.7 * r).min(room.max(20.0)));
            labels.push(middle(on(from + 0.5 * share, 0.65 * r), words, theme::PORT, theme::WHITE));
        }
        from += share;
    }
    items.extend(labels);
    items
}

/// The values there are, the last one in figures.
fn tracker(one: &Placed<'_>, tree: &Tree, rect: [f64; 4]) -> Vec<Item> {
    let [x, y, w, h] = rect;
    let mut items = Vec::new();
    let rows = numbers(tree);
    let (low, high) = {
        let [low, high] = extent(rows.iter().flatten());
        if high > low { (low, high) } else { (low - 1.0, high + 1.0) }
    };
    let at = |n: f64| y + h * (0.08 + 0.84 * (high - n) / (high - low));
    for (k, row) in rows.iter().enumerate().take(MOST_SECTORS) {
        let last = row.len().saturating_sub(1).max(1) as f64;
        let place = |(i, n): (usize, &f64)| [x + w * i as f64 / last, at(*n)];
        let path = match row.as_slice() {
            [only] => Path::polyline([[x, at(*only)], [x + w, at(*only)]]),
            _ => Path::polyline(row.iter().enumerate().map(place)),
        };
        items.push(Shape::stroked(path, paint(k), 1.4).into());
        if let Some(last) = row.last() {
            let words = text::number((last * 1000.0).round() / 1000.0);
            let label = Label::new([x + w - 3.0, at(*last) - 2.0], words, theme::PORT, paint(k));
            items.push(label.with_halo(theme::PAPER).anchored(Anchor::End).into());
        }
    }
    if rows.is_empty() && !tree.is_empty() {
        let words = font::fitted(one.object.title(), theme::NAME, w);
        items.push(middle([x + 0.5 * w, y + 0.5 * h], words, theme::NAME, theme::FAINT));
    }
    items
}

/// A frame for each item: coloured meshes, which Import Image gives, and colours are drawn; of all else the name.
fn gallery(one: &Placed<'_>, tree: &Tree, [x, y, w, h]: [f64; 4]) -> Vec<Item> {
    let values: Vec<Value> = tree.column().iter().flatten().take(MOST_PICTURES).collect();
    let mut items = Vec::new();
    if values.is_empty() {
        return items;
    }
    let n = values.len() as f64;
    let columns = (n * w / h.max(1.0)).sqrt().ceil().clamp(1.0, n);
    let rows = (n / columns).ceil();
    let (cw, ch) = (w / columns, h / rows);
    for (k, value) in values.iter().enumerate() {
        let (row, column) = ((k as f64 / columns).floor(), k as f64 % columns);
        let cell = [x + cw * column + 2.0, y + ch * row + 2.0, (cw - 4.0).max(1.0), (ch - 4.0).max(1.0)];
        match value {
            Value::Mesh(mesh) => items.extend(picture(mesh, cell)),
            Value::Colour(colour) => items.push(Shape::filled(Path::rectangle(cell), *colour).into()),
            other => {
                let faint = blend(theme::PAPER, theme::EDGE, 0.12);
                let frame = Shape::filled(Path::rectangle(cell), faint).outlined(theme::FAINT, 0.6);
                items.push(frame.into());
                let words = text::value(other, &one.style);
                let name = words.rsplit(['/', '\\']).next().unwrap_or_default();
                let centre = [cell[0] + 0.5 * cell[2], cell[1] + 0.5 * cell[3]];
                let name = font::fitted(name, theme::PORT, cell[2] - 4.0);
                items.push(middle(centre, name, theme::PORT, theme::INK));
            }
        }
    }
    items
}

/// A mesh seen from above in a rectangle, each face in the mean of its vertices' colours.
fn picture(mesh: &Mesh, [x, y, w, h]: [f64; 4]) -> Vec<Item> {
    let Some(BoundingBox { min, max }) = mesh.bounding_box() else { return Vec::new() };
    let (wide, high) = ((max.x - min.x).max(f64::MIN_POSITIVE), (max.y - min.y).max(f64::MIN_POSITIVE));
    let scale = (w / wide).min(h / high);
    let (left, top) = (x + 0.5 * (w - wide * scale), y + 0.5 * (h - high * scale));
    let colours = mesh.colours();
    let mut items = Vec::new();
    for (f, face) in mesh.faces().iter().enumerate().take(MOST_FACES) {
        let Some(points) = mesh.face_points(f) else { continue };
        let corners = points.iter().map(|p| [left + (p.x - min.x) * scale, top + (max.y - p.y) * scale]);
        let path = Path::polygon(corners);
        let own: Vec<[u8; 4]> =
            face.indices().iter().filter_map(|&i| colours.get(i as usize).copied()).collect();
        let mean = |c: usize| {
            let sum: f64 = own.iter().filter_map(|rgba| rgba.get(c)).map(|v| f64::from(*v)).sum();
            (sum / own.len().max(1) as f64).round() as u8
        };
        let colour =
            if own.is_empty() { Colour::rgb(200, 202, 206) } else { Colour::rgb(mean(0), mean(1), mean(2)) };
        // A thin line of its own colour, so that no ground shines through between faces.
        items.push(Shape::filled(path, colour).outlined(colour, 0.4).into());
    }
    items
}
