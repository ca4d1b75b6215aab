//! Statements to the tree of an archive.

use std::collections::HashMap;
use std::sync::Arc;

use uuid::Uuid;

use super::ast::{Argument, Call, Edit, Entry, Flags, Group, Module, Name, Output, Place, Target, Wire};
use super::catalogue::{Facts, Known};
use super::problem::{Fault, nearest};
use super::slot::{self, Slot};
use super::{derive, object, own, residue};
use crate::archive::Chunk;
use crate::document::{Document, ids};

/// An object that is being built.
pub(super) struct Node<'a> {
    /// What its id derives from: the label, or its place in the text.
    pub(super) key: String,
    pub(super) nickname: String,
    pub(super) what: What<'a>,
    pub(super) flags: Flags,
    pub(super) written_outputs: Option<&'a [Output]>,
    pub(super) settings: &'a [Edit],
    pub(super) inside: Option<&'a Module>,
    pub(super) details: &'a [Edit],
    pub(super) place: Option<&'a Place>,
    pub(super) component: Uuid,
    pub(super) name: String,
    pub(super) facts: Option<Arc<Facts>>,
    pub(super) floating: bool,
    pub(super) variable: bool,
    pub(super) id: Uuid,
    pub(super) inputs: Vec<Slot<'a>>,
    pub(super) outputs: Vec<Slot<'a>>,
    /// What the object's own settings come to.
    pub(super) own: Chunk,
    /// The cluster's inside.
    pub(super) inner: Option<Chunk>,
}

#[derive(Clone, Copy)]
pub(super) enum What<'a> {
    Call(&'a Call),
    Group(&'a Group),
}

pub(super) struct Builder<'a, 'k> {
    known: &'k Known<'k>,
    pub(super) faults: Vec<Fault>,
    pub(super) nodes: Vec<Node<'a>>,
    labels: HashMap<String, usize>,
    /// Objects without a label, by where they stand in the text.
    calls: HashMap<usize, usize>,
    pub(super) data: HashMap<u32, &'a [u8]>,
    parent: Uuid,
    pub(super) insides: Insides,
}

/// What becomes of the insides of clusters.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Insides {
    /// Each is packed into its cluster.
    Packed,
    /// They are built, since their objects are what the ports of the clusters refer to, but packing them takes long.
    Unpacked,
}

/// The text that a label is found by.
pub(super) fn key(label: &Name) -> String {
    match label.suffix {
        Some(n) => format!("{}'{n}", label.text),
        None => label.text.clone(),
    }
}

/// The tree of a document. `parent` is the cluster that it is the inside of.
pub(super) fn build(
    module: &Module,
    known: &Known<'_>,
    parent: Option<Uuid>,
    insides: Insides,
    faults: &mut Vec<Fault>,
) -> Chunk {
    let mut builder = Builder {
        known,
        faults: Vec::new(),
        nodes: Vec::new(),
        labels: HashMap::new(),
        calls: HashMap::new(),
        data: module.data.iter().map(|(n, bytes)| (*n, bytes.as_slice())).collect(),
        parent: parent.unwrap_or(derive::ROOT),
        insides,
    };
    builder.collect(module);
    builder.resolve();
    builder.annotate(module);
    let order = builder.order(module);
    let objects = object::chunks(&mut builder, &order);
    let root = builder.root(module, parent.is_some(), objects);
    faults.append(&mut builder.faults);
    root
}

impl<'a> Builder<'a, '_> {
    fn fault(&mut self, name: &Name, message: String, hint: Option<String>) {
        let mut fault = Fault::new(name.span.at, name.span.len, message);
        fault.hint = hint;
        self.faults.push(fault);
    }

    /// A node for each object, calls inside calls before what they stand in.
    fn collect(&mut self, module: &'a Module) {
        for (k, entry) in module.entries.iter().enumerate() {
            let label = match entry {
                Entry::Object(statement) => statement.label.as_ref(),
                Entry::Group(group) => Some(&group.label),
            };
            let key = label.map_or_else(|| format!("/{k}"), key);
            let at = match entry {
                Entry::Object(statement) => {
                    let at = self.call(&statement.call, key.clone(), label, statement.flags);
                    if let Some(node) = self.nodes.get_mut(at) {
                        node.written_outputs = statement.outputs.as_deref();
                        node.settings = &statement.settings;
                        node.inside = statement.inside.as_deref();
                    }
                    at
                }
                Entry::Group(group) => {
                    let mut node = Node::new(What::Group(group), key.clone(), Some(&group.label));
                    (node.component, node.name) = (ids::GROUP, "Group".to_owned());
                    self.nodes.push(node);
                    self.nodes.len() - 1
                }
            };
            let Some(label) = label else { continue };
            if self.labels.insert(key, at).is_some() {
                let hint = "give it another name, or a number such as '2 behind it".to_owned();
                self.fault(label, format!("{} stands for another object already", label.text), Some(hint));
            }
        }
    }

    fn call(&mut self, call: &'a Call, key: String, label: Option<&Name>, flags: Flags) -> usize {
        for (k, argument) in call.arguments.iter().enumerate() {
            for (n, wire) in argument.given.wires.iter().enumerate() {
                if let Target::Call(inner) = &wire.target {
                    let at = self.call(inner, format!("{key}/{k}.{n}"), None, Flags::default());
                    self.calls.insert(inner.span.at, at);
                }
            }
        }
        let mut node = Node::new(What::Call(call), key, label);
        node.flags = flags;
        self.look_up(&mut node, call, label.is_none());
        self.nodes.push(node);
        self.nodes.len() - 1
    }

    /// Finds the component in the catalogue.
    fn look_up(&mut self, node: &mut Node<'_>, call: &Call, nameless: bool) {
        node.name.clone_from(&call.name.text);
        node.facts = match call.guid {
            Some(guid) => self.known.by_guid(guid),
            None => self.known.by_name(&call.name.text, node.flags.parameter),
        };
        match (&node.facts, call.guid) {
            (facts, Some(guid)) => {
                node.component = guid;
                node.floating = facts.as_ref().map_or(node.flags.parameter, |facts| facts.floating);
            }
            (Some(facts), None) => {
                node.component = facts.guid;
                node.floating = facts.floating;
                node.name.clone_from(&facts.name);
            }
            (None, None) => {
                let names = self.known.names();
                let near = nearest(&call.name.text, names.iter().map(String::as_str));
                let hint = near.map(|name| format!("did you mean {name}?"));
                let hint = hint
                    .unwrap_or_else(|| "a plug-in's needs its id behind the name: Name @guid(…)".to_owned());
                self.fault(
                    &call.name,
                    format!("there is no component called {}", call.name.text),
                    Some(hint),
                );
            }
        }
        if nameless && let Some(facts) = &node.facts {
            node.nickname.clone_from(&facts.nickname);
        }
        let all_written = call.exact || node.facts.is_none();
        node.variable = if all_written {
            node.flags.variable
        } else {
            node.facts.as_ref().is_some_and(|facts| facts.is_variable())
        };
    }

    /// Ports and insides of the objects. Ids come before the insides, which derive theirs from them.
    fn resolve(&mut self) {
        for at in 0..self.nodes.len() {
            let parent = self.parent;
            let Some(node) = self.nodes.get_mut(at) else { return };
            node.id = derive::id(parent, &node.key);
            let What::Call(call) = node.what else { continue };
            let mut own = std::mem::take(&mut node.own);
            let rest = own::take(node.component, &call.arguments, &mut own, &mut self.faults);
            node.own = own;
            for argument in rest.iter().filter(|argument| argument.choice.is_some()) {
                let span = argument.span;
                self.faults.push(Fault::new(span.at, span.len, "only a Value List has items to choose from"));
            }
            self.ports(at, call, &rest);
        }
    }

    fn ports(&mut self, at: usize, call: &'a Call, arguments: &[&'a Argument]) {
        let Some(node) = self.nodes.get_mut(at) else { return };
        let all_written = call.exact || node.facts.is_none();
        if node.floating {
            if let Some(extra) = arguments.get(1) {
                let message = format!("{} has one input, and this is one too many", node.name);
                self.faults.push(Fault::new(extra.span.at, extra.span.len, message));
            }
            // Input and output are one port: what is written behind the arrow is said of both.
            let written = node.written_outputs.unwrap_or_default();
            if let [_, .., last] = written {
                let message = format!("{} has one output, and this is one too many", node.name);
                self.faults.push(Fault::new(last.name.span.at, last.name.span.len, message));
            }
            let behind = written.first().map_or(&[][..], |output| &output.modifiers);
            let before = arguments.first().map_or(&[][..], |argument| &argument.given.modifiers);
            for modifier in behind {
                let item = modifier.kind.item().0;
                if before.iter().any(|other| other.kind.item().0 == item) {
                    let message = "this modifier is given before the arrow too, and there is one port only";
                    self.faults.push(Fault::new(modifier.span.at, modifier.span.len, message));
                }
            }
            let facts = node.facts.as_ref().and_then(|facts| facts.inputs.first());
            let port = Slot {
                modifiers: behind,
                expect: facts.map(|facts| facts.expect).unwrap_or_default(),
                type_id: Some(node.component),
                default: facts.and_then(|facts| facts.default.clone()),
                given: arguments.first().map(|argument| &argument.given),
                id: node.id,
                ..Slot::default()
            };
            node.inputs = vec![port];
            return;
        }
        // A cluster has the ports that its inside says, until it is written otherwise.
        if let (Some(inside), false) = (node.inside, call.exact)
            && node.component == ids::CLUSTER
        {
            node.facts = node.facts.as_ref().map(|facts| Arc::new(cluster_facts(facts, inside)));
        }
        let facts = node.facts.clone();
        let mut faults = Vec::new();
        let title = node.name.clone();
        let style = (all_written, node.variable);
        node.inputs = slot::inputs(facts.as_deref(), style, &title, arguments, &mut faults);
        node.outputs = slot::outputs(facts.as_deref(), style, &title, node.written_outputs, &mut faults);
        for (k, slot) in node.inputs.iter_mut().enumerate() {
            slot.id = derive::id(node.id, &format!("in {k}"));
        }
        for (k, slot) in node.outputs.iter_mut().enumerate() {
            slot.id = derive::id(node.id, &format!("out {k}"));
        }
        self.faults.append(&mut faults);
    }

    /// The blocks at the end: ids, details and places, each to its object.
    fn annotate(&mut self, module: &'a Module) {
        for line in &module.ids {
            let Some(at) = self.find(&line.label) else { continue };
            let Some(node) = self.nodes.get_mut(at) else { continue };
            if let Some(id) = line.own {
                node.id = id;
                // The ports of an object derive their ids from its own.
                for (k, slot) in node.inputs.iter_mut().enumerate() {
                    slot.id = derive::id(id, &format!("in {k}"));
                }
                for (k, slot) in node.outputs.iter_mut().enumerate() {
                    slot.id = derive::id(id, &format!("out {k}"));
                }
            }
            let too_many = line.inputs.len() > node.inputs.len() || line.outputs.len() > node.outputs.len();
            for (slots, ids) in [(&mut node.inputs, &line.inputs), (&mut node.outputs, &line.outputs)] {
                for (slot, id) in slots.iter_mut().zip(ids) {
                    slot.id = id.unwrap_or(slot.id);
                }
            }
            if too_many {
                let message = format!("{} has fewer ports than ids stand here", line.label.text);
                self.fault(&line.label, message, None);
            }
        }
        for (label, edits) in &module.details {
            if let Some(node) = self.find(label).and_then(|at| self.nodes.get_mut(at)) {
                node.details = edits;
            }
        }
        for place in &module.layout {
            if let Some(node) = self.find(&place.label).and_then(|at| self.nodes.get_mut(at)) {
                node.place = Some(place);
            }
        }
        for node in &mut self.nodes {
            if let Some(inside) = node.inside {
                node.inner = Some(build(inside, self.known, Some(node.id), self.insides, &mut self.faults));
            }
        }
    }

    /// The object of a label; a fault when there is none.
    pub(super) fn find(&mut self, label: &Name) -> Option<usize> {
        let found = self.labels.get(&key(label)).copied();
        if found.is_none() {
            let near = nearest(&key(label), self.labels.keys().map(String::as_str));
            let hint = near.map(|name| format!("did you mean {name}?"));
            self.fault(label, format!("no object is called {}", key(label)), hint);
        }
        found
    }

    /// The id that a wire comes from.
    pub(super) fn source(&mut self, wire: &Wire) -> Option<Uuid> {
        let at = match &wire.target {
            Target::Guid(id) => return Some(*id),
            Target::Label(label) => self.find(label)?,
            Target::Call(call) => *self.calls.get(&call.span.at)?,
        };
        let node = self.nodes.get(at)?;
        if node.floating {
            return Some(node.id);
        }
        let names = || node.outputs.iter().map(|slot| (slot.name.as_str(), slot.nickname.as_str()));
        let found = match &wire.port {
            Some(port) => slot::find(port, names()).ok_or_else(|| slot::unknown(port, &node.name, names())),
            None => Ok(0),
        };
        let output = found.and_then(|k| {
            let none = Fault::new(wire.span.at, wire.span.len, format!("{} has no outputs", node.name));
            node.outputs.get(k).ok_or(none)
        });
        match output {
            Ok(slot) => Some(slot.id),
            Err(fault) => {
                self.faults.push(fault);
                None
            }
        }
    }

    /// The objects in drawing order: as the layout has them, and then those that it does not have.
    fn order(&self, module: &Module) -> Vec<usize> {
        let mut order: Vec<usize> = Vec::with_capacity(self.nodes.len());
        let mut placed = vec![false; self.nodes.len()];
        let laid = module.layout.iter().filter_map(|place| self.labels.get(&key(&place.label)).copied());
        for at in laid.chain(0..self.nodes.len()) {
            if let Some(placed) = placed.get_mut(at)
                && !std::mem::replace(placed, true)
            {
                order.push(at);
            }
        }
        order
    }

    /// The tree around the objects.
    fn root(&mut self, module: &Module, nested: bool, objects: Vec<Chunk>) -> Chunk {
        let mut root = base(nested);
        let definition = if nested { Some(&mut root) } else { root.child_mut("Definition") };
        if let Some(definition) = definition {
            if let Some(properties) = definition.child_mut("DefinitionProperties") {
                properties.set("Name", module.title.as_deref().unwrap_or_default());
                properties.set("Description", module.about.as_deref().unwrap_or_default());
            }
            if let Some(list) = definition.child_mut("DefinitionObjects") {
                list.set("ObjectCount", i32::try_from(objects.len()).unwrap_or(i32::MAX));
            }
        }
        residue::sort(&mut root);
        self.apply(&mut root, &module.file);
        let definition = if nested { Some(&mut root) } else { root.child_mut("Definition") };
        if let Some(definition) = definition
            && !objects.is_empty()
        {
            if definition.child("DefinitionObjects").is_none() {
                definition.set_child(Chunk::new("DefinitionObjects"));
            }
            if let Some(list) = definition.child_mut("DefinitionObjects") {
                let strangers = std::mem::replace(&mut list.chunks, objects);
                list.chunks.extend(strangers);
            }
        }
        root
    }

    /// Makes changes to a tree.
    pub(super) fn apply(&mut self, chunk: &mut Chunk, edits: &[Edit]) {
        for edit in edits {
            let data = |n: u32| self.data.get(&n).copied();
            let span = edit.span;
            match residue::apply(chunk, edit, &data) {
                Ok(()) => {}
                Err(Some(n)) => self.faults.push(super::raw_value::missing_data(n, span.at, span.len)),
                Err(None) => self.faults.push(Fault::new(span.at, span.len, "this path is too long")),
            }
        }
    }
}

/// The tree of a document without objects.
pub(super) fn base(nested: bool) -> Chunk {
    let mut root = Document::new().to_archive().root;
    if nested && let Some(mut definition) = root.child("Definition").cloned() {
        "Document".clone_into(&mut definition.name);
        root = definition;
    }
    root
}

/// The ports of a cluster, as its inside has them: inputs and outputs in drawing order.
fn cluster_facts(facts: &Facts, inside: &Module) -> Facts {
    let mut facts = facts.clone();
    let mut order: Vec<&super::ast::Statement> = Vec::new();
    let statements = || {
        inside.entries.iter().filter_map(|entry| match entry {
            Entry::Object(statement) => Some(statement),
            Entry::Group(_) => None,
        })
    };
    let label = |statement: &super::ast::Statement| statement.label.as_ref().map(key);
    for place in &inside.layout {
        order.extend(statements().find(|s| label(s).as_deref() == Some(key(&place.label).as_str())));
    }
    order.extend(statements().filter(|s| {
        !inside.layout.iter().any(|place| label(s).as_deref() == Some(key(&place.label).as_str()))
    }));
    for (name, ports) in [("Cluster Input", &mut facts.inputs), ("Cluster Output", &mut facts.outputs)] {
        let Some(many) = ports.pop() else { continue };
        let found = order.iter().filter(|statement| statement.call.name.text.eq_ignore_ascii_case(name));
        ports.extend(found.map(|statement| {
            let title = statement.label.as_ref().map(|label| label.text.clone());
            let title = title.unwrap_or_else(|| many.name.clone());
            super::catalogue::PortFacts { name: title.clone(), nickname: title, many: false, ..many.clone() }
        }));
    }
    facts
}

impl<'a> Node<'a> {
    fn new(what: What<'a>, key: String, label: Option<&Name>) -> Self {
        // A name that begins with _ is for the text only.
        let shown = label.filter(|label| label.quoted || !label.text.starts_with('_'));
        Self {
            key,
            nickname: shown.map(|label| label.text.clone()).unwrap_or_default(),
            what,
            flags: Flags::default(),
            written_outputs: None,
            settings: &[],
            inside: None,
            details: &[],
            place: None,
            component: Uuid::nil(),
            name: String::new(),
            facts: None,
            floating: false,
            variable: false,
            id: Uuid::nil(),
            inputs: Vec::new(),
            outputs: Vec::new(),
            own: Chunk::default(),
            inner: None,
        }
    }
}
