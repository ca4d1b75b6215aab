//! What a Geometry Pipeline lets through, as arguments.

use super::ast::{Argument, Target, Values};
use super::own::Own;
use super::text;
use crate::archive::Chunk;

/// The flags of the pipeline by their words, and what a new one has.
const FLAGS: [(&str, &str, bool); 3] = [
    ("hidden", "IncludeHidden", true),
    ("locked", "IncludeLocked", true),
    ("sublayers", "SublayerFiltering", true),
];
/// Its filters by their words.
const FILTERS: [(&str, &str); 2] = [("layer", "LayerFilter"), ("name", "NameFilter")];
/// What branches are made by, as words that `group` takes.
const GROUPS: [(&str, bool, bool); 3] = [("layer", true, false), ("type", false, true), ("both", true, true)];
/// The types of objects by the bits that Rhino's filters have for them (openNURBS `ON::object_type`).
const TYPES: [(&str, u32); 16] = [
    ("point", 1),
    ("cloud", 2),
    ("curve", 4),
    ("surface", 8),
    ("brep", 0x10),
    ("mesh", 0x20),
    ("light", 0x100),
    ("annotation", 0x200),
    ("block", 0x1000),
    ("dot", 0x2000),
    ("detail", 0x8000),
    ("hatch", 0x1_0000),
    ("cage", 0x2_0000),
    ("subd", 0x4_0000),
    ("clipping", 0x2000_0000),
    ("extrusion", 0x4000_0000),
];

/// `Geometry Pipeline(types = [point, curve], layer = "Walls*", hidden = false, group = layer)`.
pub(super) fn take(own: &mut Own<'_, '_>, container: &mut Chunk) {
    let words: Vec<&str> = TYPES.iter().map(|(word, _)| *word).collect();
    let what = format!("none or some of {} in square brackets", words.join(", "));
    // What is not said is not stored: a pipeline without types takes all of them.
    if let Some(types) = own.named("types", &what, types_of) {
        container.set("TypeFilter", types.cast_signed());
    }
    for (word, item) in FILTERS {
        container.set(item, own.text(word).unwrap_or_else(|| "*".to_owned()));
    }
    for (word, item, usual) in FLAGS {
        container.set(item, own.boolean(word).unwrap_or(usual));
    }
    let group = own.word("group", &GROUPS.map(|(word, ..)| word));
    let group = group.and_then(|k| GROUPS.get(usize::try_from(k).ok()?));
    let (by_layer, by_type) = group.map_or((false, false), |(_, by_layer, by_type)| (*by_layer, *by_type));
    container.set("GroupByLayer", by_layer);
    container.set("GroupByType", by_type);
}

/// The bits of the types that an argument names.
fn types_of(argument: &Argument) -> Option<u32> {
    let given = &argument.given;
    match &given.values {
        Values::None if given.wires.is_empty() => return Some(0),
        Values::Default if !given.wires.is_empty() && given.modifiers.is_empty() => {}
        _ => return None,
    }
    given.wires.iter().try_fold(0, |bits, wire| {
        let Target::Label(label) = &wire.target else { return None };
        TYPES.iter().find(|(word, _)| *word == label.text).map(|(_, bit)| bits | bit)
    })
}

/// The arguments of a pipeline, without those that say what every new one has. Bits that have no word are not said
/// here.
pub(super) fn print(container: &Chunk) -> Vec<String> {
    let mut arguments = Vec::new();
    if let Some(types) = container.i32("TypeFilter").map(i32::cast_unsigned)
        && let Some(words) = words_of(types)
    {
        arguments.push(format!("types = {words}"));
    }
    for (word, item) in FILTERS {
        if let Some(filter) = container.str(item).filter(|filter| *filter != "*") {
            arguments.push(format!("{word} = {}", text::quote(filter, '"')));
        }
    }
    for (word, item, usual) in FLAGS {
        if let Some(flag) = container.bool(item).filter(|flag| *flag != usual) {
            arguments.push(format!("{word} = {flag}"));
        }
    }
    let flag = |name| container.bool(name).unwrap_or(false);
    let by = (flag("GroupByLayer"), flag("GroupByType"));
    if let Some((word, ..)) = GROUPS.iter().find(|(_, by_layer, by_type)| (*by_layer, *by_type) == by) {
        arguments.push(format!("group = {word}"));
    }
    arguments
}

fn words_of(types: u32) -> Option<String> {
    let named: Vec<&(&str, u32)> = TYPES.iter().filter(|(_, bit)| types & bit != 0).collect();
    if named.iter().fold(0, |bits, (_, bit)| bits | bit) != types {
        return None;
    }
    let words: Vec<&str> = named.iter().map(|(word, _)| *word).collect();
    Some(match words.as_slice() {
        [] => "none".to_owned(),
        [one] => (*one).to_owned(),
        several => format!("[{}]", several.join(", ")),
    })
}
