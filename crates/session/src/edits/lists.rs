//! Controls with any number of parts: lists, pools, gradients, rules, drawn lines.

use katydid_definition::archive::{Chunk, Item, ItemValue};
use katydid_definition::document::Object;
use katydid_definition::kd;
use uuid::Uuid;

use super::controls::{argb, number, part, short, unfit};
use super::{finite, make};
use crate::Refusal;
use crate::protocol::{Colour, GripView, ListItemView, ListModeView};

/// The most items of a list.
const MOST_ITEMS: usize = 10_000;

pub(super) fn value_list(
    object: &mut Object,
    mode: ListModeView,
    items: &[ListItemView],
) -> Result<(), Refusal> {
    if items.len() > MOST_ITEMS {
        return Err(unfit(object, &format!("a list has at most {MOST_ITEMS} items")));
    }
    let mut one = items.iter().position(|item| item.selected);
    if mode != ListModeView::Check && one.is_none() && !items.is_empty() {
        one = Some(0);
    }
    let container = object.container_mut();
    container.remove_children("ListItem");
    for (k, item) in items.iter().enumerate() {
        let mut chunk = Chunk::indexed("ListItem", i32::try_from(k).unwrap_or(i32::MAX));
        chunk.set("Expression", short(&item.expression)?);
        chunk.set("Name", short(&item.name)?);
        chunk.set("Selected", if mode == ListModeView::Check { item.selected } else { one == Some(k) });
        container.chunks.push(chunk);
    }
    container.chunks.sort_by(|a, b| (&a.name, a.index).cmp(&(&b.name, b.index)));
    container.set("ListCount", i32::try_from(items.len()).unwrap_or(i32::MAX));
    container.set(
        "ListMode",
        match mode {
            ListModeView::Check => 0,
            ListModeView::DropDown => 1,
            ListModeView::Sequence => 2,
            ListModeView::Cycle => 3,
        },
    );
    Ok(())
}

pub(super) fn genes(
    object: &mut Object,
    values: &[f64],
    decimals: i32,
    min: f64,
    max: f64,
) -> Result<(), Refusal> {
    finite(values)?;
    finite(&[min, max])?;
    if values.len() > MOST_ITEMS || min > max {
        return Err(unfit(object, "a pool has at most ten thousand numbers between its limits"));
    }
    let places = u32::try_from(decimals.clamp(0, 12)).unwrap_or(2);
    let pool = part(object, "GeneData")?;
    pool.remove("Value");
    for (k, x) in (0..).zip(values) {
        pool.items.push(Item::indexed("Value", k, make::decimal(x.clamp(min, max), places)));
    }
    pool.set("Count", i32::try_from(values.len()).unwrap_or(i32::MAX));
    pool.set("Decimals", decimals.clamp(0, 12));
    number(pool, "Minimum", min);
    number(pool, "Maximum", max);
    Ok(())
}

pub(super) fn gradient(object: &mut Object, grips: &[GripView], linear: bool) -> Result<(), Refusal> {
    let at: Vec<f64> = grips.iter().map(|grip| grip.at).collect();
    finite(&at)?;
    if grips.len() > MOST_ITEMS {
        return Err(unfit(object, "a gradient has at most ten thousand grips"));
    }
    let gradient = part(object, "Gradient")?;
    let old: Vec<Chunk> = gradient.children("Grip").into_iter().cloned().collect();
    gradient.remove_children("Grip");
    for (k, grip) in grips.iter().enumerate() {
        // Grips have ids of their own, which stay.
        let index = i32::try_from(k).unwrap_or(i32::MAX);
        let mut chunk = old.get(k).cloned().unwrap_or_else(|| Chunk::new("Grip"));
        chunk.index = Some(index);
        if chunk.guid("Id").is_none() {
            chunk.set("Id", kd::derived_id(Uuid::nil(), &format!("grip {k}")));
        }
        chunk.set("Factor", grip.at.clamp(0.0, 1.0));
        chunk.set_at("Colour", 0, argb(grip.left));
        chunk.set_at("Colour", 1, argb(grip.right));
        gradient.set_child(chunk);
    }
    gradient.set("GripCount", i32::try_from(grips.len()).unwrap_or(i32::MAX));
    gradient.set("Linear", linear);
    Ok(())
}

/// A new gradient: places and colours.
pub(super) fn put_gradient(container: &mut Chunk, grips: &[(f64, Colour)]) {
    let mut gradient = Chunk::new("Gradient");
    gradient.set("GripCount", i32::try_from(grips.len()).unwrap_or(0));
    gradient.set("Linear", true);
    gradient.set("Locked", false);
    for (k, (at, colour)) in (0..).zip(grips) {
        let mut grip = Chunk::indexed("Grip", k);
        grip.set("Factor", *at);
        grip.set("Id", kd::derived_id(Uuid::nil(), &format!("grip {k}")));
        grip.set_at("Colour", 0, argb(*colour));
        grip.set_at("Colour", 1, argb(*colour));
        gradient.set_child(grip);
    }
    container.set_child(gradient);
}

pub(super) fn paths(object: &mut Object, rules: &[[String; 2]]) -> Result<(), Refusal> {
    if rules.len() > MOST_ITEMS {
        return Err(unfit(object, "it has at most ten thousand rules"));
    }
    let lexers = part(object, "lexers")?;
    lexers.remove("source");
    lexers.remove("target");
    for (k, [source, target]) in (0..).zip(rules) {
        lexers.set_at("source", k, short(source)?);
        lexers.set_at("target", k, short(target)?);
    }
    lexers.set("lexer_count", i32::try_from(rules.len()).unwrap_or(i32::MAX));
    Ok(())
}

pub(super) fn sketch(
    object: &mut Object,
    lines: &[Vec<[f64; 2]>],
    colour: Colour,
    width: f64,
) -> Result<(), Refusal> {
    const MOST_POINTS: usize = 1_000_000;
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
    Ok(())
}
