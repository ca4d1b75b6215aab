//! Where objects stand on the canvas, and which is drawn before which.

use std::collections::HashSet;

use katydid_definition::archive::ItemValue;
use katydid_definition::document::{Annotation, Object, ObjectKind, ids};
use uuid::Uuid;

use super::{bounded, sound};
use crate::Refusal;
use crate::editor::Draft;
use crate::protocol::Alignment;
use crate::view::size;

/// Moves objects to where their left top corners shall be.
pub(super) fn move_to(draft: &mut Draft<'_>, objects: &[(Uuid, [f32; 2])]) -> Result<(), Refusal> {
    bounded(objects)?;
    for &(id, [x, y]) in objects {
        sound(&[x, y])?;
        let object = draft.object(id)?;
        let [left, top, ..] = size::bounds(object);
        // What stands there already, but for rounding, stays.
        let near = |a: f32, b: f32| (a - b).abs() <= 1e-3 + 1e-6 * a.abs().max(b.abs());
        if !(near(x, left) && near(y, top)) {
            shift(object, [x - left, y - top]);
        }
    }
    Ok(())
}

/// Moves an object by a step. Groups stand where their members do.
pub(super) fn shift(object: &mut Object, [dx, dy]: [f32; 2]) {
    if dx == 0.0 && dy == 0.0 {
        return;
    }
    match object.kind {
        ObjectKind::Annotation(Annotation::Group) => return,
        ObjectKind::Annotation(Annotation::Scribble) => {
            let container = object.container_mut();
            for name in ["Ca", "Cb", "Cc", "Cd"] {
                if let Some([x, y]) = container.canvas_point(name) {
                    container.set(name, ItemValue::PointF([x + dx, y + dy]));
                }
            }
        }
        ObjectKind::Annotation(Annotation::Sketch) => {
            for mark in object.container_mut().chunks.iter_mut().filter(|chunk| chunk.name == "Mark") {
                for item in mark.items.iter_mut().filter(|item| item.name == "V") {
                    if let ItemValue::Point2d([x, y]) = item.value {
                        item.value = ItemValue::Point2d([x + f64::from(dx), y + f64::from(dy)]);
                    }
                }
            }
        }
        _ if object.bounds.is_none() && object.pivot.is_none() => {
            let [x, y, w, h] = size::bounds(object);
            let [px, py] = size::hang(object, [w, h]);
            object.set_place([x, y, w, h], [x + px, y + py]);
        }
        _ => {}
    }
    object.move_by(dx, dy);
}

/// Gives an object with a size of its own another.
pub(super) fn resize(draft: &mut Draft<'_>, id: Uuid, bounds: [f32; 4]) -> Result<(), Refusal> {
    sound(&bounds)?;
    let [x, y, w, h] = bounds;
    if w < 10.0 || h < 10.0 {
        return Err(Refusal::Senseless("nothing on the canvas is smaller than ten units".to_owned()));
    }
    let object = draft.object(id)?;
    let before = size::bounds(object);
    if before == bounds {
        return Ok(());
    }
    if object.component == ids::SCRIBBLE {
        let container = object.container_mut();
        for (name, corner) in [("Ca", [x, y]), ("Cb", [x + w, y]), ("Cc", [x + w, y + h]), ("Cd", [x, y + h])]
        {
            container.set(name, ItemValue::PointF(corner));
        }
        object.refresh();
    } else if object.special().is_none() || object.is_annotation() {
        return Err(Refusal::Unfit {
            object: object.title().to_owned(),
            reason: "its size follows from its ports".to_owned(),
        });
    }
    let [px, py] = object.pivot.unwrap_or([before[0], before[1]]);
    object.set_place(bounds, [px + x - before[0], py + y - before[1]]);
    Ok(())
}

/// Lines objects up, or spreads them evenly.
pub(super) fn align(draft: &mut Draft<'_>, objects: &[Uuid], how: Alignment) -> Result<(), Refusal> {
    bounded(objects)?;
    let mut seen = HashSet::new();
    let mut boxes: Vec<(Uuid, [f32; 4])> = Vec::new();
    for &id in objects.iter().filter(|id| seen.insert(**id)) {
        let object = draft.object(id)?;
        // A group stands where its members do.
        if object.component != ids::GROUP {
            boxes.push((id, size::bounds(object)));
        }
    }
    let edge = |of: fn(&[f32; 4]) -> f32, least: bool| {
        let pick = if least { f32::min } else { f32::max };
        boxes.iter().map(|(_, b)| of(b)).reduce(pick).unwrap_or(0.0)
    };
    let [left, right] = [edge(|b| b[0], true), edge(|b| b[0] + b[2], false)];
    let [top, bottom] = [edge(|b| b[1], true), edge(|b| b[1] + b[3], false)];
    let spread = |axis: usize, from: f32, to: f32| spread(&boxes, axis, to - from);
    let moves: Vec<(Uuid, [f32; 2])> = match how {
        Alignment::Left => boxes.iter().map(|(id, b)| (*id, [left - b[0], 0.0])).collect(),
        Alignment::Right => boxes.iter().map(|(id, b)| (*id, [right - b[0] - b[2], 0.0])).collect(),
        Alignment::Centre => {
            boxes.iter().map(|(id, b)| (*id, [0.5 * (left + right - b[2]) - b[0], 0.0])).collect()
        }
        Alignment::Top => boxes.iter().map(|(id, b)| (*id, [0.0, top - b[1]])).collect(),
        Alignment::Bottom => boxes.iter().map(|(id, b)| (*id, [0.0, bottom - b[1] - b[3]])).collect(),
        Alignment::Middle => {
            boxes.iter().map(|(id, b)| (*id, [0.0, 0.5 * (top + bottom - b[3]) - b[1]])).collect()
        }
        Alignment::SpreadAcross => spread(0, left, right),
        Alignment::SpreadDown => spread(1, top, bottom),
    };
    for (id, step) in moves {
        // What stands right but for rounding stays.
        if step.iter().any(|x| x.abs() > 0.01) {
            shift(draft.object(id)?, step);
        }
    }
    Ok(())
}

/// The steps that make the gaps along an axis equal; the first and the last stay.
fn spread(boxes: &[(Uuid, [f32; 4])], axis: usize, whole: f32) -> Vec<(Uuid, [f32; 2])> {
    let low = |b: &[f32; 4]| if axis == 0 { b[0] } else { b[1] };
    let long = |b: &[f32; 4]| if axis == 0 { b[2] } else { b[3] };
    let mut order: Vec<&(Uuid, [f32; 4])> = boxes.iter().collect();
    order.sort_by(|(_, a), (_, b)| low(a).total_cmp(&low(b)));
    let gaps = u16::try_from(order.len().saturating_sub(1)).map_or(1e5, f32::from).max(1.0);
    // Where there is no room they stand one behind the other.
    let gap = ((whole - order.iter().map(|(_, b)| long(b)).sum::<f32>()) / gaps).max(0.0);
    let mut at = order.first().map_or(0.0, |(_, b)| low(b));
    let mut steps = Vec::with_capacity(order.len());
    for (id, b) in order {
        let step = at - low(b);
        steps.push((*id, if axis == 0 { [step, 0.0] } else { [0.0, step] }));
        at += long(b) + gap;
    }
    steps
}

/// Draws objects behind or before all others: the file's order is that of drawing.
pub(super) fn reorder(draft: &mut Draft<'_>, objects: &[Uuid], back: bool) -> Result<(), Refusal> {
    bounded(objects)?;
    let named: HashSet<Uuid> = objects.iter().copied().collect();
    for &id in &named {
        draft.object(id)?;
    }
    let all = std::mem::take(&mut draft.document.objects);
    let (mut moved, mut rest): (Vec<Object>, Vec<Object>) =
        all.into_iter().partition(|object| named.contains(&object.id));
    draft.document.objects = if back {
        moved.append(&mut rest);
        moved
    } else {
        rest.append(&mut moved);
        rest
    };
    draft.stir();
    Ok(())
}
