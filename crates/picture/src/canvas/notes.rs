//! Groups, scribbles and sketches.

use katydid_definition::document::special::{Group, Scribble, Sketch};
use katydid_definition::document::{Document, Special};
use katydid_elementary::Elementary;
use uuid::Uuid;

use super::frame::union;
use super::{Placed, theme};
use crate::drawing::{Item, Label, Path, Shape, blend, opaque};
use katydid_scene::colour::of_archive as colour;

/// Free pixels inside a group's frame; more at the top, where its name stands.
const PAD: f64 = 12.0;
const TOP: f64 = 28.0;
/// Groups in groups, at most.
const MOST_NESTED: usize = 16;

struct Framed {
    group: Group,
    title: String,
    rect: [f64; 4],
}

fn framed(document: &Document, placed: &[Option<Placed<'_>>]) -> Vec<Framed> {
    let lookup = document.lookup();
    let groups = document.objects.iter().filter_map(|object| match object.special() {
        Some(Special::Group(group)) => Some((object, group)),
        _ => None,
    });
    let with_frame = |(object, group): (&katydid_definition::document::Object, Group)| {
        let rect = around(document, placed, &|id| lookup.object(id), &group, MOST_NESTED)?;
        Some(Framed { title: object.title().to_owned(), rect, group })
    };
    let mut all: Vec<Framed> = groups.filter_map(with_frame).collect();
    // The large ones lie below the small ones in them.
    all.sort_by(|a, b| (b.rect[2] * b.rect[3]).total_cmp(&(a.rect[2] * a.rect[3])));
    all
}

fn around(
    document: &Document,
    placed: &[Option<Placed<'_>>],
    find: &dyn Fn(Uuid) -> Option<usize>,
    group: &Group,
    deeper: usize,
) -> Option<[f64; 4]> {
    let rect = |id: &Uuid| {
        let index = find(*id)?;
        match document.objects.get(index)?.special() {
            Some(Special::Group(inner)) => around(document, placed, find, &inner, deeper.checked_sub(1)?),
            _ => placed.get(index)?.as_ref().map(|one| one.frame.rect),
        }
    };
    let [x, y, w, h] = group.members.iter().filter_map(rect).reduce(union)?;
    Some([x - PAD, y - TOP, w + 2.0 * PAD, h + TOP + PAD])
}

/// The frames of all groups.
pub(super) fn group_frames(document: &Document, placed: &[Option<Placed<'_>>]) -> Vec<[f64; 4]> {
    framed(document, placed).into_iter().map(|one| one.rect).collect()
}

pub(super) fn groups(document: &Document, placed: &[Option<Placed<'_>>]) -> Vec<Item> {
    let draw = |Framed { group, title, rect }: Framed| {
        let fill = group.colour.map_or(theme::GROUP, colour);
        let edge = blend(opaque(fill), theme::INK, 0.3);
        let [x, y, ..] = rect;
        let mut items = vec![Shape::filled(Path::rounded(rect, 8.0), fill).outlined(edge, 1.0).into()];
        let name = group.label.trim();
        if !name.is_empty() {
            let ink = blend(opaque(fill), theme::INK, 0.85);
            let room = rect[2] - 14.0;
            let name = crate::font::fitted(name, 11.0, room);
            items.push(Label::new([x + 8.0, y + 12.0], name, 11.0, ink).bold().into());
        }
        Item::Group(format!("Group {title}"), items)
    };
    framed(document, placed).into_iter().map(draw).collect()
}

pub(super) fn scribble(one: &Placed<'_>, scribble: &Scribble) -> Vec<Item> {
    let [x, y, w, h] = one.frame.rect;
    let size = if scribble.size.is_finite() { scribble.size.clamp(4.0, 400.0) } else { 14.0 };
    let lines: Vec<&str> = scribble.text.lines().collect();
    // The corners of a turned scribble say where its text runs.
    let [a, b, ..] = scribble.corners.map(|p| p.map(f64::from));
    let along = [b[0] - a[0], b[1] - a[1]];
    let length = along[0].hypotenuse(along[1]);
    let turned = length > 1.0 && length.is_finite() && along[1].abs() > 0.01 * length;
    let (start, [c, s]) = if turned { (a, along.map(|k| k / length)) } else { ([x, y], [1.0, 0.0]) };
    let step = if turned { 1.3 * size } else { (h / lines.len().max(1) as f64).clamp(size, 1.6 * size) };
    let items = lines.iter().enumerate().map(|(k, line)| {
        let down = step * (k as f64 + 0.5) + 0.35 * size;
        // A typeface wider than the author's is set smaller rather than run over its neighbours.
        let wide = crate::font::width(line, size);
        let fitting = if turned || wide <= w { size } else { (size * w / wide).max(0.6 * size) };
        let mut label = Label::new([start[0] - s * down, start[1] + c * down], *line, fitting, theme::INK);
        label.bold = scribble.bold;
        label.turn = [c, s, -s, c];
        label.into()
    });
    items.collect()
}

pub(super) fn sketch(sketch: &Sketch) -> Vec<Item> {
    let line = sketch.colour.map_or(theme::EDGE, colour);
    let marks = sketch.marks.iter().filter(|mark| mark.points.len() > 1);
    marks
        .map(|mark| {
            Shape::stroked(Path::polyline(mark.points.iter().copied()), line, sketch.width.clamp(0.2, 100.0))
                .into()
        })
        .collect()
}
