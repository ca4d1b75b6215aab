//! Texts in space, and legends.

use std::sync::Arc as Shared;

use katydid_data::Colour;
use katydid_definition::document::Object;
use katydid_geometry::{Plane, Point3, Rectangle};
use uuid::{Uuid, uuid};

use super::Draw;
use crate::Painter;
use crate::font;
use crate::rows::Row;
use crate::{Form, Legend, Look, Place};

pub(super) const DRAWN: &[(Uuid, Draw)] = &[
    (uuid!("3b220754-4114-4170-b6c3-b286b86ed524"), text_tag),
    (uuid!("5a41528b-12b9-40dc-a3f2-842034d267c4"), text_tag_3d),
    (uuid!("f6867cdd-2216-4451-9134-7da94bdcd5af"), legend),
    // Human's texts.
    (uuid!("6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd344"), screen_text),
    (uuid!("6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd345"), facing_text),
    (uuid!("6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd346"), justified_text),
];

/// The height of a text that faces the viewer and is given a factor only, in pixels.
const FACING: f64 = 12.0;

/// A text that faces the viewer, of a height in pixels.
fn facing(painter: &mut Painter<'_>, row: &Row<'_>, [text, at, colour]: [usize; 3], size: f64) {
    let (Some(text), Some(at)) = (row.item::<Shared<str>>(text), row.item::<Point3>(at)) else { return };
    let line = row.item::<Colour>(colour).unwrap_or(painter.look.line);
    if size > 0.0 {
        let size = size.clamp(4.0, 200.0);
        let tag = Form::Tag { at, text: text.to_string(), size, place: Place::On };
        painter.scene.add(tag, Look { line, ..painter.look });
    }
}

fn screen_text(painter: &mut Painter<'_>, _: &Object, row: &Row<'_>) {
    let size = row.item::<f64>(2).unwrap_or(20.0);
    facing(painter, row, [0, 1, 3], size);
}

fn facing_text(painter: &mut Painter<'_>, _: &Object, row: &Row<'_>) {
    let size = FACING * row.item::<f64>(4).unwrap_or(1.0);
    facing(painter, row, [0, 3, 5], size);
}

fn justified_text(painter: &mut Painter<'_>, _: &Object, row: &Row<'_>) {
    let (Some(plane), Some(text)) = (row.item::<Plane>(0), row.item::<Shared<str>>(1)) else { return };
    let line = row.item::<Colour>(3).unwrap_or(painter.look.line);
    let size = row.item::<f64>(2).unwrap_or(1.0);
    let [across, up] = [4, 5].map(|k| row.item::<i32>(k).unwrap_or(0).clamp(0, 2));
    // Writings are counted from the top left on, row by row.
    let justification = 3 * (2 - up) + across + 1;
    let writing = Form::Writing { plane, text: text.to_string(), size, justification };
    if size.is_finite() && size > 0.0 {
        painter.scene.add(writing, Look { line, ..painter.look });
    }
}

fn text_tag(painter: &mut Painter<'_>, object: &Object, row: &Row<'_>) {
    let (Some(at), Some(text)) = (row.item::<Point3>(0), row.item::<Shared<str>>(1)) else { return };
    let line = row.item::<Colour>(2).unwrap_or(painter.look.line);
    let height = object.container().i32("TagHeight").map_or(13.0, f64::from);
    let tag = Form::Tag { at, text: text.to_string(), size: height.clamp(4.0, 200.0), place: Place::Beside };
    painter.scene.add(tag, Look { line, ..painter.look });
}

fn text_tag_3d(painter: &mut Painter<'_>, _: &Object, row: &Row<'_>) {
    let (Some(plane), Some(text)) = (row.item::<Plane>(0), row.item::<Shared<str>>(1)) else { return };
    let line = row.item::<Colour>(3).unwrap_or(painter.look.line);
    let size = row.item::<f64>(2).unwrap_or(1.0);
    let justification = row.item::<i32>(4).unwrap_or(7);
    let writing = Form::Writing { plane, text: text.to_string(), size, justification };
    if size.is_finite() && size > 0.0 {
        painter.scene.add(writing, Look { line, ..painter.look });
    }
}

fn legend(painter: &mut Painter<'_>, _: &Object, row: &Row<'_>) {
    let tags: Vec<Shared<str>> = row.list(1);
    let text = |k: usize| tags.get(k).map(|tag| tag.to_string()).unwrap_or_default();
    let entries: Vec<(Colour, String)> =
        row.list::<Colour>(0).into_iter().enumerate().map(|(k, colour)| (colour, text(k))).collect();
    match row.item::<Rectangle>(2) {
        Some(rectangle) => legend_inside(painter, &rectangle, &entries),
        None => painter.scene.legends.push(Legend::List(entries)),
    }
}

/// A legend in the model: a row for each colour, from the top of the rectangle to its bottom, with letters as large as
/// fit in.
fn legend_inside(painter: &mut Painter<'_>, rectangle: &Rectangle, entries: &[(Colour, String)]) {
    let (wide, high) = (rectangle.x.length().abs(), rectangle.y.length().abs());
    let row = high / entries.len().max(1) as f64;
    if !(wide > 0.0 && row > 0.0 && wide.is_finite() && row.is_finite()) {
        return;
    }
    let side = (0.8 * row).min(0.5 * wide);
    let longest = entries.iter().map(|(_, text)| font::width(text, 1.0)).fold(0.0, f64::max);
    let room = wide - 1.5 * side;
    let size = if longest > 0.0 { (0.7 * row).min(room / longest) } else { 0.7 * row };
    let left = rectangle.x.start.min(rectangle.x.end);
    let top = rectangle.y.start.max(rectangle.y.end);
    let at = |u: f64, v: f64| rectangle.plane.at(left + u, top - v, 0.0);
    for (k, (colour, text)) in entries.iter().enumerate() {
        let middle = (k as f64 + 0.5) * row;
        let (above, below) = (middle - 0.5 * side, middle + 0.5 * side);
        let corners = [at(0.0, above), at(side, above), at(side, below), at(0.0, below)];
        painter.scene.add(Form::Tile(corners, [*colour; 4]), painter.look);
        let origin = at(1.3 * side, middle);
        let writing = Form::Writing {
            plane: Plane { origin, ..rectangle.plane },
            text: text.clone(),
            size,
            justification: 4,
        };
        if size > 0.0 {
            painter.scene.add(writing, painter.look);
        }
    }
}
