//! What the document says of itself. Grasshopper keeps no units and tolerances: they stand in the table where
//! documents keep values by name, and Grasshopper leaves them there.

use katydid_data::cast::Rules;
use katydid_data::units;
use katydid_definition::archive::{Chunk, ItemValue};
use katydid_definition::document::Document;

use super::finite;
use crate::Refusal;
use crate::controls::argb;
use crate::editor::Draft;
use crate::protocol::Edit;

pub(super) const TABLE: &str = "ValueTable";
const UNITS: &str = "Katydid.Units";
const TOLERANCE: &str = "Katydid.Tolerance";
const ANGLE: &str = "Katydid.AngleTolerance";

/// The chunk that the definition's parts stand in: the root itself inside a cluster.
pub(super) fn definition(root: &Chunk) -> &Chunk {
    root.child("Definition").unwrap_or(root)
}

pub(super) fn definition_mut(root: &mut Chunk) -> &mut Chunk {
    let at = root.chunks.iter().position(|chunk| chunk.name == "Definition" && chunk.index.is_none());
    match at {
        Some(at) => &mut root.chunks[at],
        None => root,
    }
}

/// The units and tolerances that a document names; what it does not name is as given.
pub(crate) fn rules_of(document: &Document, given: Rules) -> Rules {
    let mut rules = given;
    let Some(table) = definition(document.frame()).child(TABLE) else { return rules };
    if let Some(units) = table.str(UNITS).and_then(units::named) {
        rules.units = units;
    }
    let sound = |name: &str, most: f64| table.f64(name).filter(|x| *x > 0.0 && *x <= most);
    if let Some(tolerance) = sound(TOLERANCE, 1e6) {
        rules.tolerance.absolute = tolerance;
    }
    if let Some(degrees) = sound(ANGLE, 90.0) {
        rules.tolerance.angle = degrees.to_radians();
    }
    rules
}

/// The part of that name, which is made where it is missing.
pub(super) fn part<'a>(parent: &'a mut Chunk, name: &str) -> &'a mut Chunk {
    if parent.child(name).is_none() {
        parent.set_child(Chunk::new(name));
    }
    let at = parent.chunks.iter().position(|chunk| chunk.name == name && chunk.index.is_none()).unwrap_or(0);
    &mut parent.chunks[at]
}

/// Sets what is given.
pub(super) fn change(draft: &mut Draft<'_>, edit: &Edit) -> Result<(), Refusal> {
    let Edit::Settings {
        units: unit,
        tolerance,
        angle_tolerance,
        preview_normal,
        preview_selected,
        name,
        author,
        description,
    } = edit
    else {
        return Ok(());
    };
    let positive = |x: &f64, most: f64, what: &str| {
        finite(&[*x])?;
        if *x > 0.0 && *x <= most {
            return Ok(());
        }
        Err(Refusal::Senseless(format!("the {what} must be greater than 0 and at most {most}")))
    };
    let mut set: Vec<(&str, &str, ItemValue)> = Vec::new();
    if let Some(unit) = unit {
        let known = units::named(unit)
            .ok_or_else(|| Refusal::Senseless(format!("there is no unit called {unit}")))?;
        set.push((TABLE, UNITS, ItemValue::String(known.name().to_owned())));
    }
    if let Some(x) = tolerance {
        positive(x, 1e6, "tolerance")?;
        set.push((TABLE, TOLERANCE, ItemValue::Double(*x)));
    }
    if let Some(x) = angle_tolerance {
        positive(x, 90.0, "tolerance of angles")?;
        set.push((TABLE, ANGLE, ItemValue::Double(*x)));
    }
    if let Some(colour) = preview_normal {
        set.push(("DocumentHeader", "PreviewNormal", ItemValue::Colour(argb(*colour))));
    }
    if let Some(colour) = preview_selected {
        set.push(("DocumentHeader", "PreviewSelected", ItemValue::Colour(argb(*colour))));
    }
    for (chunk, item, text) in [
        ("DefinitionProperties", "Name", name),
        ("DefinitionProperties", "Description", description),
        ("Author", "Name", author),
    ] {
        if let Some(text) = text {
            set.push((chunk, item, ItemValue::String(text.clone())));
        }
    }
    let there = |(chunk, item, value): &(&str, &str, ItemValue)| {
        let empty = matches!(value, ItemValue::String(text) if text.is_empty());
        match definition(draft.document.frame()).child(chunk).and_then(|chunk| chunk.item(item)) {
            Some(old) => old == value,
            None => empty,
        }
    };
    set.retain(|one| !there(one));
    if set.is_empty() {
        return Ok(());
    }
    let definition = definition_mut(draft.document.tree_mut());
    for (chunk, item, value) in set {
        part(definition, chunk).set(item, value);
    }
    let frame = draft.document.frame().clone();
    draft.document.set_frame(frame);
    Ok(())
}
