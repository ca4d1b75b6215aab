//! One object as a statement.

use super::ast::{ModifierKind, Name};
use super::catalogue::{Expect, Facts, PortFacts};
use super::slot::{self, Slot};
use super::write::{Entry, Sheet};
use super::{labels, object, own, text, value};
use crate::archive::Chunk;
use crate::document::{Annotation, Document, Object, ObjectKind, Persistent, Port, Side, Special, ids};

/// Names and nicknames of ports.
pub(super) type Names = Vec<(String, String)>;

/// The objects in the order of the text: each after what it is wired to, annotations behind all others.
pub(super) fn order(objects: &[Object]) -> Vec<usize> {
    let mut by_output = std::collections::HashMap::new();
    for (at, object) in objects.iter().enumerate() {
        for port in &object.outputs {
            by_output.entry(port.id).or_insert(at);
        }
    }
    let sources = |at: usize| -> Vec<usize> {
        let inputs = objects.get(at).map(|object| object.inputs.as_slice()).unwrap_or_default();
        inputs.iter().flat_map(|port| &port.sources).filter_map(|id| by_output.get(id).copied()).collect()
    };
    let note = |at: &usize| objects.get(*at).is_some_and(Object::is_annotation);
    let (notes, working): (Vec<usize>, Vec<usize>) = (0..objects.len()).partition(note);
    let mut order = Vec::with_capacity(objects.len());
    let mut seen = vec![false; objects.len()];
    for start in working.into_iter().chain(notes) {
        // A walk with a stack of its own: each object with the sources that are still to be visited.
        let mut stack = vec![(start, None::<std::vec::IntoIter<usize>>)];
        while let Some((at, left)) = stack.last_mut() {
            let at = *at;
            let left = match left {
                Some(left) => left,
                None => {
                    if seen.get_mut(at).is_none_or(|seen| std::mem::replace(seen, true)) {
                        stack.pop();
                        continue;
                    }
                    left.insert(sources(at).into_iter())
                }
            };
            match left.next() {
                Some(next) => {
                    if seen.get(next) == Some(&false) {
                        stack.push((next, None));
                    }
                }
                None => {
                    order.push(at);
                    stack.pop();
                }
            }
        }
    }
    order
}

/// As [`order`], of objects that are being written.
pub(super) fn order_of(entries: &[Entry<'_>]) -> Vec<usize> {
    let objects: Vec<Object> = entries.iter().map(|entry| entry.object.clone()).collect();
    order(&objects)
}

/// Whether an object has the ports that the catalogue says.
pub(super) fn follows(object: &Object, facts: Option<&Facts>) -> bool {
    let Some(facts) = facts else { return false };
    if facts.floating || object.is_floating() {
        return facts.floating == object.is_floating();
    }
    let fits = |facts: &[PortFacts], ports: &[Port]| {
        let (fixed, many) = slot::split(facts);
        let names = || fixed.iter().map(|port| (port.name.as_str(), port.nickname.as_str()));
        // One of many that is called as a fixed one is would be taken for it.
        let clear = |port: &Port| {
            let label = Name { text: port.nickname.clone(), quoted: true, ..Name::default() };
            slot::find(&label, names()).is_none()
        };
        let added = ports.get(fixed.len()..).unwrap_or_default();
        ports.len() == fixed.len() || many.is_some() && !added.is_empty() && added.iter().all(clear)
    };
    let variable = facts.is_variable() || facts.guid == ids::CLUSTER;
    let annotation = object.is_annotation();
    (variable == object.variable || annotation)
        && fits(&facts.inputs, &object.inputs)
        && fits(&facts.outputs, &object.outputs)
}

/// The ports of a cluster after its inside, when the objects inside are called as the ports are.
pub(super) fn inner_names(object: &Object, facts: &Facts, inside: &Document) -> Option<Facts> {
    let mut facts = facts.clone();
    let sides = [
        (ids::CLUSTER_INPUT, &mut facts.inputs, &object.inputs),
        (ids::CLUSTER_OUTPUT, &mut facts.outputs, &object.outputs),
    ];
    for (component, ports, outer) in sides {
        let many = ports.pop().filter(|port| port.many)?;
        let inner = inside.objects.iter().filter(|object| object.component == component);
        let names: Vec<&str> = inner.map(|object| object.nickname.as_str()).collect();
        let usable = |name: &&str| !name.is_empty() && !name.starts_with('_');
        let mut sorted = names.clone();
        sorted.sort_unstable();
        sorted.dedup();
        let same = names.iter().copied().eq(outer.iter().map(|port| port.nickname.as_str()));
        if !same || !names.iter().all(usable) || sorted.len() != names.len() {
            return None;
        }
        ports.extend(names.into_iter().map(|name| PortFacts {
            name: name.to_owned(),
            nickname: name.to_owned(),
            many: false,
            ..many.clone()
        }));
    }
    Some(facts)
}

/// What a port goes by where all are written.
fn port_label(port: &Port) -> &str {
    if port.nickname.is_empty() { &port.name } else { &port.nickname }
}

/// The names that outputs are found by.
pub(super) fn output_names(object: &Object, facts: Option<&Facts>, all_written: bool) -> Names {
    slots(object, facts, all_written, Side::Output)
        .into_iter()
        .map(|slot| (slot.name, slot.nickname))
        .collect()
}

/// The ports of a side as a reader will see them.
fn slots<'a>(object: &Object, facts: Option<&Facts>, all_written: bool, side: Side) -> Vec<Slot<'a>> {
    let ports = object.ports(side);
    let Some(facts) = facts.filter(|_| !all_written) else {
        return ports
            .iter()
            .map(|port| slot::exact(facts, side, object.variable, port_label(port)))
            .collect();
    };
    let list = if side == Side::Input { &facts.inputs } else { &facts.outputs };
    let (fixed, many) = slot::split(list);
    ports
        .iter()
        .enumerate()
        .map(|(k, port)| match (fixed.get(k), many) {
            (Some(facts), _) => slot::exact_of(facts),
            (None, Some(many)) => slot::one_of_many(many, k - fixed.len(), Some(&port.nickname)),
            (None, None) => Slot::default(),
        })
        .collect()
}

/// The statement of an object, without settings and inside.
pub(super) fn print(sheet: &mut Sheet<'_, '_>, at: usize) -> String {
    let Some(entry) = sheet.entries.get(at) else { return String::new() };
    let object = entry.object;
    if object.kind == ObjectKind::Annotation(Annotation::Group) {
        return group(sheet, entry);
    }
    let mut line = format!("{} = ", entry.label);
    let facts = entry.facts.clone();
    let named = facts.as_deref().and_then(|facts| sheet.known.name_of(facts, object.component));
    let all_written =
        entry.all_written && !(object.is_floating() && facts.as_ref().is_some_and(|f| f.floating));
    let mut parameter = false;
    match (&facts, named) {
        (Some(facts), Some((with_panel, as_parameter))) => {
            if with_panel {
                line.push_str(&format!("{}/", labels::name(&facts.panel)));
            }
            line.push_str(&labels::name(&facts.name));
            parameter = as_parameter;
        }
        _ => {
            line.push_str(&format!("{} @{}", labels::name(&object.name), object.component));
            parameter |= facts.is_none() && object.is_floating();
        }
    }
    if all_written && facts.is_some() {
        line.push('!');
    }
    let mut arguments = targets(sheet, object);
    arguments.extend(own::print(object));
    arguments.extend(inputs(sheet, at, all_written));
    line.push_str(&format!("({})", arguments.join(", ")));
    let flags = [
        (object.locked, "disabled"),
        (object.hidden, "hidden"),
        (parameter, "parameter"),
        (all_written && object.variable, "variable"),
    ];
    for (_, word) in flags.into_iter().filter(|(on, _)| *on) {
        line.push(' ');
        line.push_str(word);
    }
    line + &outputs(sheet, at, all_written)
}

/// What an object by its id is called in the text.
fn reference(sheet: &Sheet<'_, '_>, id: uuid::Uuid) -> String {
    let found = sheet.lookup.object(id).and_then(|at| sheet.entries.get(at));
    found.map_or_else(|| format!("@{id}"), |entry| entry.label.to_string())
}

/// The objects that a trigger has solved again.
fn targets(sheet: &Sheet<'_, '_>, object: &Object) -> Vec<String> {
    match object.special() {
        Some(Special::Trigger(trigger)) => {
            trigger.targets.into_iter().map(|id| reference(sheet, id)).collect()
        }
        _ => Vec::new(),
    }
}

fn group(sheet: &Sheet<'_, '_>, entry: &Entry<'_>) -> String {
    let attributes = object::print_frame(entry.object.container());
    let attributes =
        if attributes.is_empty() { String::new() } else { format!("({})", attributes.join(", ")) };
    let Some(Special::Group(group)) = entry.object.special() else { return String::new() };
    let members: Vec<String> = group.members.into_iter().map(|id| reference(sheet, id)).collect();
    format!("group {}{attributes}: {}", entry.label, members.join(", "))
}

/// The arguments that are inputs.
fn inputs(sheet: &mut Sheet<'_, '_>, at: usize, all_written: bool) -> Vec<String> {
    let Some(entry) = sheet.entries.get(at) else { return Vec::new() };
    let (object, facts) = (entry.object, entry.facts.clone());
    let floating = object.is_floating();
    let slots = if floating {
        let port = facts.as_ref().and_then(|facts| facts.inputs.first());
        let expect = port.map(|port| port.expect).unwrap_or_default();
        let default = port.and_then(|port| port.default.clone());
        vec![Slot { expect, default, ..Slot::default() }]
    } else {
        slots(object, facts.as_deref(), all_written, Side::Input)
    };
    let fixed = facts.as_ref().map_or(0, |facts| slot::split(&facts.inputs).0.len());
    let names: Names =
        facts.iter().flat_map(|f| &f.inputs).map(|p| (p.name.clone(), p.nickname.clone())).collect();
    let mut list = Vec::new();
    // Whether an input before was left out, so that the next needs its name.
    let mut gap = false;
    for (k, (port, slot)) in object.inputs.iter().zip(&slots).enumerate() {
        let given = given(sheet, object, port, slot);
        if floating {
            list.extend(given);
            continue;
        }
        let needs_name = all_written || k >= fixed && slot.nickname != usual(facts.as_deref(), k, fixed);
        if all_written || k >= fixed {
            let label = if all_written { port_label(port) } else { &port.nickname };
            let text = given.unwrap_or_else(|| "_".to_owned());
            let plain = all_written && label.is_empty() || !needs_name;
            list.push(if plain { text } else { format!("{} = {text}", labels::name(label)) });
            continue;
        }
        let Some(text) = given else {
            gap = true;
            // A port that stands for many counts those before it.
            if object.inputs.len() > fixed {
                list.push("_".to_owned());
            }
            continue;
        };
        if !gap || object.inputs.len() > fixed {
            list.push(text);
            continue;
        }
        match port_name(&names, k) {
            Some(name) => list.push(format!("{name} = {text}")),
            None => {
                list.resize(k, "_".to_owned());
                list.push(text);
            }
        }
    }
    list
}

/// What a port is called among the many of its kind.
fn usual(facts: Option<&Facts>, k: usize, fixed: usize) -> String {
    let many = facts.and_then(|facts| facts.inputs.last());
    many.map(|many| slot::one_of_many(many, k - fixed, None).nickname).unwrap_or_default()
}

/// A name that finds the port: its full one if it does, else the short one.
fn port_name(names: &Names, k: usize) -> Option<String> {
    let (name, nickname) = names.get(k)?;
    let found = |text: &str| {
        let label = Name { text: text.to_owned(), quoted: true, ..Name::default() };
        slot::find(&label, names.iter().map(|(name, nick)| (name.as_str(), nick.as_str()))) == Some(k)
    };
    [name, nickname].into_iter().find(|text| !text.is_empty() && found(text)).map(|text| labels::name(text))
}

/// Wires, values and modifiers of an input; nothing when it has what it has without a word.
fn given(sheet: &mut Sheet<'_, '_>, object: &Object, port: &Port, slot: &Slot<'_>) -> Option<String> {
    let wires: Vec<String> = port.sources.iter().map(|id| wire(sheet, *id)).collect();
    let floating = object.is_floating();
    let own = floating && own::has_settings(object.component);
    let kept = if own { None } else { object.persistent(port) };
    let usual = own || kept == slot.default;
    let values = match &kept {
        _ if usual => None,
        None => Some("none".to_owned()),
        Some(values) => Some(values_text(sheet, values, slot.expect)),
    };
    let modifiers = modifiers(port.chunk(object.container()), floating);
    let mut text = match wires.as_slice() {
        [] => String::new(),
        [one] => one.clone(),
        several => format!("[{}]", several.join(", ")),
    };
    match values {
        Some(values) if text.is_empty() => text = values,
        Some(values) => text.push_str(&format!(" else {values}")),
        None => {}
    }
    if text.is_empty() && modifiers.is_empty() {
        return None;
    }
    if text.is_empty() {
        text.push('_');
    }
    Some(text + &modifiers)
}

fn values_text(sheet: &mut Sheet<'_, '_>, values: &Persistent, expect: Expect) -> String {
    value::print(values, expect, &mut |bytes| sheet.data.keep(bytes))
}

/// An output, as a wire names it.
fn wire(sheet: &Sheet<'_, '_>, id: uuid::Uuid) -> String {
    let Some(port) = sheet.lookup.output(id) else { return format!("@{id}") };
    let Some(entry) = sheet.entries.get(port.object) else { return format!("@{id}") };
    let label = &entry.label;
    if entry.object.is_floating() || entry.outputs.len() == 1 {
        return label.to_string();
    }
    match port_name(&entry.outputs, port.port) {
        Some(name) => format!("{label}.{name}"),
        None => format!("{}.{}", label.before_number(), port.port),
    }
}

fn modifiers(chunk: Option<&Chunk>, floating: bool) -> String {
    let mut line = String::new();
    for kind in chunk.map(ModifierKind::read).unwrap_or_default() {
        match &kind {
            // The preview of a floating parameter is that of the object.
            ModifierKind::Hidden if floating => {}
            ModifierKind::Expression(text) if stands_in_braces(text) => {
                line.push_str(&format!(" |{{{text}}}"))
            }
            ModifierKind::Expression(text) => {
                line.push_str(&format!(" |expression {}", text::quote(text, '"')));
            }
            kind => {
                let word = ModifierKind::WORDS.iter().find(|(_, other)| other == kind);
                line.extend(word.map(|(word, _)| format!(" |{word}")));
            }
        }
    }
    line
}

/// Whether the braces in an expression are in balance, and it is one line.
fn stands_in_braces(text: &str) -> bool {
    let mut depth = 0i32;
    for c in text.chars() {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            c if c.is_control() => return false,
            _ => {}
        }
        if depth < 0 {
            return false;
        }
    }
    depth == 0
}

/// The outputs that need a word: those with modifiers, and all where nobody else knows them.
fn outputs(sheet: &Sheet<'_, '_>, at: usize, all_written: bool) -> String {
    let Some(entry) = sheet.entries.get(at) else { return String::new() };
    let object = entry.object;
    if object.is_floating() || object.outputs.is_empty() {
        return String::new();
    }
    let facts = entry.facts.as_deref();
    let (fixed, many) = facts.map_or((&[][..], None), |facts| slot::split(&facts.outputs));
    let usual = many.map(|many| slot::one_of_many(many, 0, None).nickname);
    let numbers = object.outputs.iter().map(|port| Some(port.nickname.as_str())).skip(fixed.len());
    let as_usual = many.is_none() || numbers.eq([usual.as_deref()]);
    // Where one output is written, those of many are no longer taken for granted.
    let list_many = !as_usual
        || object.outputs.iter().any(|port| !modifiers(port.chunk(object.container()), false).is_empty());
    let mut list = Vec::new();
    for (k, port) in object.outputs.iter().enumerate() {
        let modifiers = modifiers(port.chunk(object.container()), false);
        if all_written || k >= fixed.len() {
            if all_written || list_many {
                let label = if all_written { port_label(port) } else { &port.nickname };
                list.push(labels::name(label) + &modifiers);
            }
        } else if !modifiers.is_empty() {
            let name = port_name(&entry.outputs, k).unwrap_or_else(|| k.to_string());
            list.push(name + &modifiers);
        }
    }
    if list.is_empty() && (all_written || as_usual) {
        String::new()
    } else {
        format!(" -> {}", list.join(", "))
    }
}
