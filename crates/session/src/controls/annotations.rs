//! The Group, the Scribble and the Sketch.

use katydid_definition::archive::{Chunk, Item, ItemValue};
use katydid_definition::document::special::Border;
use katydid_definition::document::{Object, Special, ids};

use super::parts::number;
use super::{PLAIN, Row, argb, colour, finite, part, short, unfit};
use crate::Refusal;
use crate::edits::{shape_group, sound};
use crate::protocol::{BorderView, Colour, Control};

/// The most points of a sketch.
const MOST_POINTS: usize = 1_000_000;

pub(super) const GROUP: Row = Row {
    components: &[ids::GROUP],
    hangs_from_corner: true,
    view: |_, special| {
        let Special::Group(group) = special else { return None };
        Some(Control::Group {
            label: group.label,
            colour: group.colour.map_or([170, 135, 255, 150], colour),
            border: match group.border {
                Border::Blob => BorderView::Blob,
                Border::Rectangle => BorderView::Rectangle,
                Border::Box | Border::Other(_) => BorderView::Box,
            },
            members: group.members,
        })
    },
    shape: |object, control| {
        let Control::Group { label, colour, border, members } = control else { return Ok(false) };
        shape_group(object, label, *colour, *border, members)?;
        Ok(true)
    },
    ..PLAIN
};

pub(super) const SCRIBBLE: Row = Row {
    components: &[ids::SCRIBBLE],
    hangs_from_corner: true,
    view: |_, special| {
        let Special::Scribble(scribble) = special else { return None };
        Some(Control::Scribble {
            text: scribble.text,
            font: scribble.font,
            size: scribble.size,
            bold: scribble.bold,
            italic: scribble.italic,
            corners: scribble.corners,
        })
    },
    shape: |object, control| {
        let Control::Scribble { text, font, size, bold, italic, corners } = control else {
            return Ok(false);
        };
        finite(&[*size])?;
        sound(corners.as_flattened())?;
        if !(1.0..=1000.0).contains(size) {
            return Err(unfit(object, "letters are between 1 and 1000 points high"));
        }
        let container = object.container_mut();
        container.set("Text", short(text)?);
        container.set("Font", short(font)?);
        container.set("Size", ItemValue::Single(*size as f32));
        container.set("Bold", *bold);
        container.set("Italic", *italic);
        if !is_flat(corners) {
            for (name, corner) in ["Ca", "Cb", "Cc", "Cd"].into_iter().zip(corners) {
                container.set(name, ItemValue::PointF(*corner));
            }
        }
        Ok(true)
    },
    ..PLAIN
};

pub(super) const SKETCH: Row = Row {
    components: &[ids::SKETCH],
    hangs_from_corner: true,
    view: |_, special| {
        let Special::Sketch(sketch) = special else { return None };
        Some(Control::Sketch {
            lines: sketch.marks.into_iter().map(|mark| mark.points).collect(),
            colour: sketch.colour.map_or([0, 0, 0, 255], colour),
            width: sketch.width,
        })
    },
    shape: |object, control| {
        let Control::Sketch { lines, colour, width } = control else { return Ok(false) };
        sketch(object, lines, *colour, *width)
    },
    ..PLAIN
};

/// Whether corners enclose nothing: a face that does not know how large letters are sends them so.
pub(crate) fn is_flat(corners: &[[f32; 2]; 4]) -> bool {
    corners.iter().all(|corner| corner == &corners[0])
}

/// The shape of a group's frame, by its number in the file.
pub(crate) fn border(border: BorderView) -> i32 {
    match border {
        BorderView::Box => 1,
        BorderView::Blob => 2,
        BorderView::Rectangle => 3,
    }
}

fn sketch(object: &mut Object, lines: &[Vec<[f64; 2]>], colour: Colour, width: f64) -> Result<bool, Refusal> {
    finite(&[width])?;
    if lines.iter().map(Vec::len).sum::<usize>() > MOST_POINTS {
        return Err(unfit(object, "a sketch has at most a million points"));
    }
    for line in lines {
        finite(line.as_flattened())?;
    }
    let container = object.container_mut();
    container.remove_children("Mark");
    for (k, line) in (0..).zip(lines) {
        let mut mark = Chunk::indexed("Mark", k);
        for (i, point) in (0..).zip(line) {
            let value = ItemValue::Point2d(*point);
            mark.items.push(Item::indexed("V", i, value));
        }
        mark.set("VertexCount", i32::try_from(line.len()).unwrap_or(i32::MAX));
        container.chunks.push(mark);
    }
    container.set("MarkCount", i32::try_from(lines.len()).unwrap_or(i32::MAX));
    let attributes = part(object, "Attributes")?;
    if attributes.child("SketchProperties").is_none() {
        attributes.set_child(Chunk::new("SketchProperties"));
    }
    if let Some(properties) = attributes.child_mut("SketchProperties") {
        properties.set("Color", argb(colour));
        number(properties, "Width", width);
    }
    Ok(true)
}
