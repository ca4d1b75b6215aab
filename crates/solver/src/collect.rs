//! The data of an input: what its wires bring, or what it keeps itself, cast to its type.

use std::sync::Arc as Shared;

use katydid_component::{Message, ModelLack, Port as Declared, stored};
use katydid_data::{Column, Kind, ModelObject, Tree, Value, cast};
use katydid_definition::document::{Object, Port, Side};

use crate::{Options, modifiers};

/// Data on its way into an input, and what to say about it.
#[derive(Debug, Default)]
pub(crate) struct Collected {
    pub(crate) tree: Tree,
    pub(crate) messages: Vec<Message>,
}

/// Collects the data of `port`: the trees on its wires, branch by branch in wire order; without wires the
/// values kept in the port; without those the component's own default.
pub(crate) fn port(
    object: &Object,
    port: &Port,
    declared: Option<&Declared>,
    wired: &[&Tree],
    options: &Options,
) -> Collected {
    let rules = &options.rules;
    let mut messages = Vec::new();
    let tree =
        if !port.sources.is_empty() {
            Tree::merge(wired.iter().copied())
        } else if let Some(persistent) = object.persistent(port) {
            let (tree, said) = stored::tree(&persistent, options.model.as_deref());
            let kind = declared.map_or(Kind::Generic, |port| port.kind);
            messages.extend(said.into_iter().map(|message| Message {
                lack: message.lack.map(|lack| ModelLack { kind, ..lack }),
                ..message
            }));
            tree
        } else {
            declared.and_then(|d| d.default).map_or_else(Tree::empty, |default| default())
        };
    Collected { tree: fit(object, port, declared, tree, rules, &mut messages), messages }
}

/// The data of `port` when somebody brought it in place of wires and of what is kept.
pub(crate) fn brought(
    object: &Object,
    port: &Port,
    declared: Option<&Declared>,
    tree: &Tree,
    options: &Options,
) -> Collected {
    let mut messages = Vec::new();
    Collected { tree: fit(object, port, declared, tree.clone(), &options.rules, &mut messages), messages }
}

/// The tree as the input takes it: cast to its type, changed by its modifiers.
fn fit(
    object: &Object,
    port: &Port,
    declared: Option<&Declared>,
    tree: Tree,
    rules: &cast::Rules,
    messages: &mut Vec<Message>,
) -> Tree {
    let kind = declared.map_or(Kind::Generic, |d| d.kind);
    let carried = if object.is_floating() { carried_texts(&tree) } else { Vec::new() };
    let tree = cast_to(tree, kind, rules, messages);
    let tree = if carried.is_empty() { tree } else { carrying(tree, carried) };
    let tree =
        if object.is_floating() { tree } else { modifiers::apply(tree, port, Side::Input, rules, messages) };
    // An expression may give another type than the port's.
    let tree = if object.is_floating() { tree } else { cast_to(tree, kind, rules, messages) };
    match kind {
        Kind::Surface if !object.is_floating() => one_surface(tree, messages),
        Kind::Brep if !object.is_floating() => breps(tree, messages),
        _ => tree,
    }
}

/// The texts that the items of a tree carry, by their places; empty where no item carries any.
fn carried_texts(tree: &Tree) -> Vec<(usize, Texts)> {
    let column = tree.column();
    if !matches!(column.kind(), Kind::Generic | Kind::Content) {
        return Vec::new();
    }
    let items = column.iter().enumerate();
    items
        .filter_map(|(place, item)| Some((place, item?.carried_texts().to_vec())))
        .filter(|(_, texts)| !texts.is_empty())
        .collect()
}

/// Keys and texts.
type Texts = Vec<(Shared<str>, Shared<str>)>;

/// The tree with items that carry texts again: a parameter gives geometry on with what it carries.
fn carrying(tree: Tree, carried: Vec<(usize, Texts)>) -> Tree {
    let mut items: Vec<Option<Value>> = tree.column().iter().collect();
    for (place, texts) in carried {
        if let Some(item) = items.get_mut(place) {
            *item = item.take().map(|value| match value.kind().is_geometry() {
                true => ModelObject::carrying(value, texts),
                false => value,
            });
        }
    }
    tree.with_column(Column::of_options(items))
}

/// Components that ask for a surface compute with that of a brep's only face, trimmed or not; a face that is turned over
/// stays a brep, for those that ask to which side it looks ([`katydid_data::Face`]). For breps of several faces they have
/// nothing to compute with. (Parameters pass all of them through as they are.)
fn one_surface(tree: Tree, messages: &mut Vec<Message>) -> Tree {
    let surface = |brep: &Value| {
        let brep = brep.brep().ok_or_else(|| "it has no faces".to_owned())??;
        match (brep.faces(), brep.face_surface(0)) {
            ([face], Some(_)) if face.reversed => Ok(Value::Brep(brep)),
            ([_], Some(surface)) => Ok(Value::from(surface.clone())),
            _ => Err("it has several faces".to_owned()),
        }
    };
    replaced(tree, "computed with as a surface", messages, surface)
}

/// Breps that are kept as a program wrote them are read for the components that ask for breps.
fn breps(tree: Tree, messages: &mut Vec<Message>) -> Tree {
    replaced(tree, "read", messages, |kept| match (kept, kept.brep()) {
        (Value::Kept(_), Some(brep)) => Ok(Value::Brep(brep?)),
        _ => Ok(kept.clone()),
    })
}

/// The tree with another value in the place of every brep, and nothing where there is none.
fn replaced(
    tree: Tree,
    done: &str,
    messages: &mut Vec<Message>,
    make: impl Fn(&Value) -> Result<Value, String>,
) -> Tree {
    let column = tree.column();
    let is_brep = |item: &Option<Value>| matches!(item, Some(Value::Kept(_) | Value::Brep(_)));
    if !column.iter().any(|item| is_brep(&item)) {
        return tree;
    }
    let mut refused = None;
    let usable = column.iter().map(|item| match item {
        Some(brep) if is_brep(&Some(brep.clone())) => match make(&brep) {
            Ok(value) => Some(value),
            Err(why) => {
                refused.get_or_insert((brep, why));
                None
            }
        },
        item => item,
    });
    let usable = Column::of_options(usable.collect());
    if let Some((first, why)) = refused {
        let class = match &first {
            Value::Kept(raw) => raw.class_name(),
            other => other.kind().to_string(),
        };
        messages.push(Message::warning(format!("A {class} cannot be {done}: {why}")));
    }
    tree.with_column(usable)
}

/// The tree with every item cast to a type; those that cannot be are null, which is told.
pub(crate) fn cast_to(tree: Tree, kind: Kind, rules: &cast::Rules, messages: &mut Vec<Message>) -> Tree {
    let cast::Cast { column, failed, ours } = cast::column(tree.column(), kind, rules);
    if let Some((from, way)) = ours {
        messages.push(Message::remark(format!(
            "{from} to {kind}: {}. This is our reading; nothing tells what Grasshopper does",
            way.gives
        )));
    }
    if let Some((from, count)) = failed {
        let times = if count == 1 { String::new() } else { format!(" ({count} times)") };
        messages.push(Message::warning(format!("Data conversion failed from {from} to {kind}{times}")));
    }
    tree.with_column(column)
}
