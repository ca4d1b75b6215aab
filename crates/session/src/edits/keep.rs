//! Values kept in ports, and parameters put before inputs.

use katydid_component::registry;
use katydid_data::cast::{self, Rules};
use katydid_data::{Kind, Tree, Value};
use katydid_definition::document::{
    Branch, NewPort, Object, Persistent, PortRef, Side, Stored, ids, parse_path,
};
use uuid::Uuid;

use super::{geometry, make};
use crate::Refusal;
use crate::catalogue::stored;
use crate::editor::Draft;
use crate::view::{kind, parameter_kind, size};

/// The most values that a text may have.
pub(super) const MOST_VALUES: usize = 1_000_000;

pub(super) fn unfit(object: &Object, reason: impl Into<String>) -> Refusal {
    Refusal::Unfit { object: object.title().to_owned(), reason: reason.into() }
}

/// The type of an input's items.
pub(super) fn kind_of(object: &Object, input: usize) -> Kind {
    let declared = registry::by_guid(object.component).and_then(|c| c.input(input)).map(|port| port.kind);
    object.inputs.get(input).map_or(Kind::Generic, |port| kind(port, declared))
}

/// Keeps values in an input, as text.
pub(super) fn keep(draft: &mut Draft<'_>, port: Uuid, values: Option<&str>) -> Result<(), Refusal> {
    let at = draft.input(port)?;
    let rules = draft.rules;
    put(draft.at(at.object)?, at.port, values, &rules)
}

/// Keeps values in an input of an object; none takes them out.
pub(super) fn put(
    object: &mut Object,
    input: usize,
    text: Option<&str>,
    rules: &Rules,
) -> Result<(), Refusal> {
    let Some(port) = object.inputs.get(input) else { return Err(unfit(object, "it has no such input")) };
    if !size::shows(object, Side::Input) || object.component == ids::PANEL {
        return Err(unfit(object, "it keeps its value itself"));
    }
    let had = object.persistent(port);
    let Some(text) = text else {
        if had.is_some() {
            object.set_persistent(input, None)?;
        }
        return Ok(());
    };
    let values = read(text, kind_of(object, input), rules).map_err(|reason| unfit(object, reason))?;
    if had.as_ref() != Some(&values) {
        object.set_persistent(input, Some(&values))?;
    }
    Ok(())
}

/// Values as text, one a line, with a path on a line of its own before each branch but the first.
fn read(text: &str, kind: Kind, rules: &Rules) -> Result<Persistent, String> {
    let mut branches: Vec<Branch> = Vec::new();
    let mut count = 0;
    for line in text.lines() {
        // Where paths are values there is no telling them from heads of branches.
        if let Some(path) = (kind != Kind::Path).then(|| parse_path(line)).flatten()
            && line.trim_start().starts_with('{')
            && !line.contains(',')
        {
            branches.push(Branch { path, items: Vec::new() });
            continue;
        }
        count += 1;
        if count > MOST_VALUES {
            return Err(format!("an input keeps at most {MOST_VALUES} values"));
        }
        if branches.is_empty() {
            branches.push(Branch { path: vec![0], items: Vec::new() });
        }
        if let Some(branch) = branches.last_mut() {
            branch.items.push(value(line, kind, rules)?);
        }
    }
    // No line at all is one empty text.
    if branches.is_empty() && kind == Kind::Text {
        return Ok(Persistent::item(Stored::Text(String::new())));
    }
    Ok(Persistent { branches })
}

/// A text as a value of a type.
fn value(line: &str, kind: Kind, rules: &Rules) -> Result<Stored, String> {
    if line.trim() == "null" && kind != Kind::Text {
        return Ok(Stored::Null);
    }
    let text = Value::text(line);
    let found = match kind {
        Kind::Text => Some(text),
        // What reads as a number is one where anything goes.
        Kind::Generic => cast::value(&text, Kind::Number, rules).or(Some(text)),
        kind => cast::value(&text, kind, rules),
    };
    let found = found.ok_or_else(|| format!("'{line}' is not a {kind}"))?;
    match stored(&found) {
        Some(Stored::Number(x)) if !x.is_finite() => Err(format!("'{line}' is not a finite number")),
        Some(value) => Ok(value),
        None => Err(format!("a {kind} cannot be kept as text")),
    }
}

/// Keeps the data that a port has now, and takes its wires away.
pub(super) fn internalise(draft: &mut Draft<'_>, port: Uuid) -> Result<(), Refusal> {
    let lookup = draft.lookup();
    match (lookup.input(port), lookup.output(port)) {
        (Some(at), _) => {
            let object = draft.at(at.object)?;
            let sources = object.inputs.get(at.port).map(|port| port.sources.clone()).unwrap_or_default();
            // What it keeps already stays.
            if sources.is_empty() {
                return Ok(());
            }
            let title = object.title().to_owned();
            let trees: Option<Vec<Tree>> =
                sources.iter().map(|id| draft.results.output(*id, draft.within)).collect();
            let trees = trees.ok_or_else(|| Refusal::Unfit {
                object: title,
                reason: "there is no data to keep until it is solved".to_owned(),
            })?;
            let tree = Tree::merge(trees.iter());
            let rules = draft.rules;
            let object = draft.at(at.object)?;
            let values = kept(object, &tree, kind_of(object, at.port), &rules)?;
            object.set_sources(at.port, &[])?;
            object.set_persistent(at.port, Some(&values))?;
            Ok(())
        }
        (None, Some(at)) => beside(draft, port, at),
        (None, None) => Err(Refusal::NoPort(port)),
    }
}

/// Data in the form that a parameter keeps.
fn kept(object: &Object, tree: &Tree, kind: Kind, rules: &Rules) -> Result<Persistent, Refusal> {
    let cast::Cast { column, .. } = cast::column(tree.column(), kind, rules);
    let tree = tree.with_column(column);
    if tree.item_count() > MOST_VALUES {
        return Err(unfit(object, format!("an input keeps at most {MOST_VALUES} values")));
    }
    geometry::persistent(&tree).map_err(|reason| unfit(object, reason))
}

/// Keeps the data of an output in a new parameter beside it, from which its readers read on.
fn beside(draft: &mut Draft<'_>, port: Uuid, at: PortRef) -> Result<(), Refusal> {
    let object = draft.at(at.object)?.clone();
    let id = katydid_definition::kd::derived_id(port, "internalised");
    if draft.has(id) {
        return Ok(());
    }
    let tree = draft
        .results
        .output(port, draft.within)
        .ok_or_else(|| unfit(&object, "there is no data to keep until it is solved"))?;
    let declared = registry::by_guid(object.component).and_then(|c| c.output(at.port)).map(|port| port.kind);
    let kind = object.outputs.get(at.port).map_or(Kind::Generic, |port| kind(port, declared));
    let mut new = make::object(parameter_of(kind), id)?;
    let values = kept(&object, &tree, kind, &draft.rules)?;
    new.set_persistent(0, Some(&values))?;
    let [x, y, w, h] = size::bounds(&object);
    make::place(&mut new, [x + w + 60.0, y + 0.5 * h]);
    for reader in &mut draft.document.objects {
        for k in 0..reader.inputs.len() {
            let sources = reader.inputs.get(k).map_or(&[][..], |port| &port.sources);
            if sources.contains(&port) {
                let now: Vec<Uuid> =
                    sources.iter().map(|source| if *source == port { id } else { *source }).collect();
                reader.set_sources(k, &now)?;
            }
        }
    }
    draft.document.objects.push(new);
    draft.stir();
    Ok(())
}

/// The floating parameter for items of a type.
fn parameter_of(kind: Kind) -> Uuid {
    let known = registry::all().into_iter().find(|component| {
        let plain =
            component.floating && ["Geometry", "Primitive"].contains(&component.panel) && !component.old;
        plain && component.outputs.first().is_some_and(|port| port.kind == kind)
    });
    match kind {
        Kind::Generic => ids::DATA,
        Kind::Geometry => ids::GEOMETRY,
        _ => known.map_or(ids::DATA, |component| component.guid),
    }
}

/// Puts a floating parameter before an input, which takes over what the input keeps and reads.
pub(super) fn extract(draft: &mut Draft<'_>, port: Uuid, id: Uuid) -> Result<(), Refusal> {
    if draft.has(id) {
        return Ok(());
    }
    let at = draft.input(port)?;
    let object = draft.at(at.object)?.clone();
    if object.is_floating() {
        return Err(unfit(&object, "it is a parameter already"));
    }
    let Some(input) = object.inputs.get(at.port) else { return Err(Refusal::NoPort(port)) };
    let kind = kind_of(&object, at.port);
    let type_id = input.type_id.filter(|id| parameter_kind(*id).is_some());
    let mut new = make::object(type_id.unwrap_or_else(|| parameter_of(kind)), id)?;
    new.set_nickname(if input.nickname.is_empty() { &input.name } else { &input.nickname });
    new.set_sources(0, &input.sources)?;
    if let Some(values) = object.persistent(input) {
        new.set_persistent(0, Some(&values))?;
    }
    let [x, y, ..] = size::bounds(&object);
    let grip = size::grips(&object, Side::Input).get(at.port).copied().unwrap_or(0.0);
    let [w, _] = size::natural(&new);
    make::place(&mut new, [x - 60.0 - 0.5 * w, y + grip]);
    draft.at(at.object)?.set_sources(at.port, &[id])?;
    draft.document.objects.push(new);
    draft.stir();
    Ok(())
}

/// What a port of this kind is called when it is made for an object inside a cluster.
pub(super) fn port_for(object: &Object, id: Uuid) -> NewPort {
    NewPort {
        id,
        name: object.title().to_owned(),
        nickname: object.title().to_owned(),
        type_id: Some(ids::DATA),
        ..NewPort::default()
    }
}
