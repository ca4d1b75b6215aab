//! Components and floating parameters.

use katydid_data::Colour;
use katydid_definition::document::{Mapping, Object, Port, ids};
use katydid_solver::Status;

use super::{Placed, theme, type_name};
use crate::drawing::{Anchor, Item, Label, Path, Shape, Stroke, blend};
use crate::font;

/// The name is set upright when there is less room for it than this.
const NARROW: f64 = 30.0;

pub(super) fn draw(one: &Placed<'_>) -> Vec<Item> {
    let object = one.object;
    let (fill, ink) = theme::capsule(one);
    let mut items = body(one, fill);
    let [x, y, w, h] = one.frame.rect;
    if object.is_floating() {
        let name = font::fitted(object.title(), theme::NAME, w - 10.0);
        items.push(middle([x + 0.5 * w, y + 0.5 * h], name, theme::NAME, ink));
        let marks = object.inputs.first().map(marks).unwrap_or_default();
        if !marks.is_empty() {
            let at = [x + 5.0, y + 0.5 * h + 3.0];
            items.push(Label::new(at, marks, theme::TYPE, ink).into());
        }
    } else {
        let rows = object.inputs.len().max(object.outputs.len()).max(1);
        let size = theme::PORT.min(0.95 * h / rows as f64);
        let left = column(&object.inputs, size);
        let right = column(&object.outputs, size);
        // Long names give way to the band in the middle.
        let room = w - 20.0;
        let share = if left + right > room { room / (left + right) } else { 1.0 };
        let (left, right) = (left * share, right * share);
        for (port, at) in object.inputs.iter().zip(&one.frame.inputs) {
            let text = font::fitted(&named(port), size, left);
            items.push(Label::new([x + 6.0, at[1] + 0.36 * size], text, size, ink).into());
        }
        for (port, at) in object.outputs.iter().zip(&one.frame.outputs) {
            let text = font::fitted(&named(port), size, right);
            let label = Label::new([x + w - 6.0, at[1] + 0.36 * size], text, size, ink);
            items.push(label.anchored(Anchor::End).into());
        }
        let from = x + if left > 0.0 { left + 9.0 } else { 4.0 };
        let to = x + w - if right > 0.0 { right + 9.0 } else { 4.0 };
        items.extend(band([from, y + 3.0, (to - from).max(10.0), h - 6.0], object.title()));
    }
    items.extend(grips(one));
    items
}

/// The capsule without anything on it; and above it the name of its type where the nickname hides that.
pub(super) fn body(one: &Placed<'_>, fill: Colour) -> Vec<Item> {
    let mut items: Vec<Item> = type_name(one.object).map(|name| above(one, name)).into_iter().collect();
    items.extend(outline(one, fill));
    items
}

/// A frame for what is drawn inside a capsule.
pub(super) fn window(one: &Placed<'_>) -> (Vec<Item>, [f64; 4]) {
    let mut items = body(one, theme::capsule(one).0);
    let [x, y, w, h] = one.frame.rect;
    let rect = [x + 6.0, y + 4.0, (w - 12.0).max(4.0), (h - 8.0).max(4.0)];
    items.push(Shape::filled(Path::rectangle(rect), theme::PAPER).outlined(theme::EDGE, 0.6).into());
    (items, rect)
}

/// A small text above an object.
fn above(one: &Placed<'_>, text: &str) -> Item {
    let [x, y, w, _] = one.frame.rect;
    Label::new([x + 2.0, y - 3.5], font::fitted(text, theme::TYPE, w + 14.0), theme::TYPE, theme::FAINT)
        .into()
}

fn outline(one: &Placed<'_>, fill: Colour) -> Vec<Item> {
    let rect = one.frame.rect;
    let [x, y, w, h] = rect;
    let mut items = Vec::new();
    if one.object.component == ids::CLUSTER {
        let behind = Path::rounded([x + 3.0, y + 3.0, w, h], theme::CORNER);
        items.push(Shape::filled(behind, fill).outlined(theme::EDGE, 1.0).into());
    }
    let mut shape = Shape::filled(Path::rounded(rect, theme::CORNER), fill).outlined(theme::EDGE, 1.0);
    // What does not run has a broken outline.
    if matches!(one.status(), Status::Disabled | Status::Unsupported) {
        shape.stroke = Some(Stroke { colour: theme::EDGE, width: 1.2, dashes: vec![4.0, 3.0] });
    }
    items.push(shape.into());
    items
}

/// The dark band with the name.
fn band(rect: [f64; 4], name: &str) -> Vec<Item> {
    let [x, y, w, h] = rect;
    let mut items = vec![Shape::filled(Path::rounded(rect, 3.0), theme::BAND).into()];
    let centre = [x + 0.5 * w, y + 0.5 * h];
    if w < NARROW && h > w {
        let text = font::fitted(name, theme::NAME, h - 6.0);
        let mut label = Label::new([centre[0] + 3.5, centre[1]], text, theme::NAME, theme::WHITE)
            .anchored(Anchor::Middle);
        label.turn = [0.0, -1.0, 1.0, 0.0];
        items.push(label.into());
        return items;
    }
    let step = theme::NAME + 1.0;
    let most = ((h / step).floor() as usize).max(1);
    let lines = wrapped(name, theme::NAME, w - 6.0, most);
    let top = centre[1] - 0.5 * step * (lines.len() as f64 - 1.0);
    for (k, line) in lines.into_iter().enumerate() {
        items.push(middle([centre[0], top + step * k as f64], line, theme::NAME, theme::WHITE));
    }
    items
}

/// A text in lines of a width; the last of them is cut where there are more.
pub(super) fn wrapped(text: &str, size: f64, room: f64, most: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        let joined = lines.last().map(|line| format!("{line} {word}"));
        match joined {
            Some(joined) if font::width(&joined, size) <= room || lines.len() == most => {
                lines.pop();
                lines.push(joined);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines.iter().map(|line| font::fitted(line, size, room)).collect()
}

/// A text with its middle at a point.
pub(super) fn middle(at: [f64; 2], text: String, size: f64, colour: Colour) -> Item {
    Label::new([at[0], at[1] + 0.35 * size], text, size, colour).anchored(Anchor::Middle).into()
}

/// The width that the names of ports need.
fn column(ports: &[Port], size: f64) -> f64 {
    ports.iter().map(|port| font::width(&named(port), size)).fold(0.0, f64::max)
}

/// A port's short name with marks for what it does to its data.
fn named(port: &Port) -> String {
    let name = if port.nickname.is_empty() { &port.name } else { &port.nickname };
    let marks = marks(port);
    if marks.is_empty() { name.clone() } else { format!("{name} {marks}") }
}

fn marks(port: &Port) -> String {
    let m = &port.modifiers;
    let mapping = match m.mapping {
        Mapping::None => "",
        Mapping::Flatten => "↓",
        Mapping::Graft => "↑",
    };
    [
        (true, mapping),
        (m.simplify, "∼"),
        (m.reverse, "←"),
        (m.reparameterize, "↦"),
        (m.unitize, "û"),
        (m.invert, "¬"),
        (m.degrees, "°"),
        (m.expression.is_some(), "ƒ"),
    ]
    .into_iter()
    .filter(|(on, _)| *on)
    .map(|(_, mark)| mark)
    .collect()
}

/// The round places where wires end.
pub(super) fn grips(one: &Placed<'_>) -> Vec<Item> {
    let fill = blend(theme::PAPER, theme::EDGE, 0.05);
    let grip = |at: &[f64; 2]| Shape::filled(Path::circle(*at, 2.8), fill).outlined(theme::EDGE, 1.0).into();
    one.frame.inputs.iter().chain(&one.frame.outputs).map(grip).collect()
}

/// A capsule with its name on the left, and the rectangle beside it, at least `need` wide; where that leaves no room for
/// the name it stands above, and the rectangle is the whole.
pub(super) fn titled(one: &Placed<'_>, need: f64) -> (Vec<Item>, [f64; 4]) {
    let (fill, ink) = theme::capsule(one);
    let [x, y, w, h] = one.frame.rect;
    let object: &Object = one.object;
    let wide = font::width(object.title(), theme::NAME) + 12.0;
    if wide + need > w {
        let mut items = vec![above(one, object.title())];
        items.extend(outline(one, fill));
        return (items, [x + 2.0, y, w - 2.0, h]);
    }
    let mut items = body(one, fill);
    let at = [x + 6.0, y + h.min(20.0) * 0.5 + 3.5];
    items.push(Label::new(at, object.title(), theme::NAME, ink).into());
    (items, [x + wide, y, w - wide, h])
}
