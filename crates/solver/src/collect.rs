//! The data of an input: what its wires bring, or what it keeps itself, cast to its type.

use katydid_component::{Message, Port as Declared};
use katydid_data::{Column, Kind, Tree, Value, cast};
use katydid_definition::document::{Object, Port};

use crate::{Options, modifiers, stored};

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
    let tree = if !port.sources.is_empty() {
        Tree::merge(wired.iter().copied())
    } else if let Some(persistent) = object.persistent(port) {
        let (tree, said) = stored::tree(&persistent, options.model.as_deref());
        messages.extend(said);
        tree
    } else {
        declared.and_then(|d| d.default).map_or_else(Tree::empty, |default| default())
    };
    let kind = declared.map_or(Kind::Generic, |d| d.kind);
    let tree = cast_to(tree, kind, rules, &mut messages);
    let tree = if object.is_floating() { tree } else { modifiers::apply(tree, port, rules, &mut messages) };
    // An expression may give another type than the port's.
    let tree = cast_to(tree, kind, rules, &mut messages);
    let tree =
        if kind == Kind::Surface && !object.is_floating() { computable(tree, &mut messages) } else { tree };
    Collected { tree, messages }
}

/// Components compute with the surface of a kept brep of one untrimmed face, turned over or not; for others they
/// have nothing to compute with. (Parameters pass all of them through as they are.)
fn computable(tree: Tree, messages: &mut Vec<Message>) -> Tree {
    let column = tree.column();
    if !column.iter().any(|item| matches!(item, Some(Value::Kept(_)))) {
        return tree;
    }
    let mut refused = None;
    let usable = column.iter().map(|item| match item {
        Some(Value::Kept(brep)) => match brep.bare_surface() {
            Ok(Some(bare)) => Some(Value::from(bare.surface)),
            _ => {
                refused.get_or_insert(brep);
                None
            }
        },
        item => item,
    });
    let usable = Column::of_options(usable.collect());
    if let Some(first) = refused {
        messages.push(Message::warning(format!(
            "A {} that is trimmed or of several faces cannot be computed with yet",
            first.class_name()
        )));
    }
    tree.with_column(usable)
}

fn cast_to(tree: Tree, kind: Kind, rules: &cast::Rules, messages: &mut Vec<Message>) -> Tree {
    let cast::Cast { column, failed } = cast::column(tree.column(), kind, rules);
    if let Some((from, count)) = failed {
        let times = if count == 1 { String::new() } else { format!(" ({count} times)") };
        messages.push(Message::warning(format!("Data conversion failed from {from} to {kind}{times}")));
    }
    tree.with_column(column)
}
