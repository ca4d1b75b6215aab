//! What hangs on what: which missing component types the data of each port needs, through wires and clusters.

use std::collections::{HashMap, VecDeque};

use katydid_definition::archive::Limits;
use katydid_definition::document::{ClusterContent, Document, Hook, Lookup, Object, ids};
use katydid_solver::of_object;
use uuid::Uuid;

use super::causes::Causes;

/// The missing types by the ids of their objects, as places in the list of what is not supported.
pub(super) type Missing = HashMap<Uuid, Vec<usize>>;

/// What some data needs.
#[derive(Debug, Clone, Default)]
pub(super) struct Needs {
    /// The missing component types.
    pub(super) missing: Causes,
    /// Inside a cluster, the numbers of the cluster's inputs.
    inputs: Causes,
}

impl Needs {
    fn join(&mut self, other: &Self) -> bool {
        let grew = self.missing.join(&other.missing);
        self.inputs.join(&other.inputs) || grew
    }

    fn of_all<'a>(all: impl IntoIterator<Item = &'a Self>) -> Self {
        let mut joined = Self::default();
        all.into_iter().for_each(|needs| {
            joined.join(needs);
        });
        joined
    }
}

/// What the data of each port of a document needs and has not.
#[derive(Debug)]
pub(super) struct Hanging {
    /// For each object, for each output.
    given: Vec<Vec<Needs>>,
    /// For each object, what all that it reads needs, and it itself.
    taken: Vec<Needs>,
}

impl Hanging {
    /// Follows the wires of a document from what is missing.
    pub(super) fn of(document: &Document, missing: &Missing) -> Self {
        Self::within(document, missing, &HashMap::new())
    }

    /// Likewise inside a cluster, whose inputs bring data from outside: their numbers by the places of the objects inside that
    /// give it.
    fn within(document: &Document, missing: &Missing, entering: &HashMap<usize, Needs>) -> Self {
        let objects = &document.objects;
        let mut found = Self {
            given: objects.iter().map(|object| vec![Needs::default(); object.outputs.len()]).collect(),
            taken: vec![Needs::default(); objects.len()],
        };
        let wires = Wires::of(document);
        let nodes: Vec<Node> = objects.iter().map(|object| Node::of(object, missing)).collect();
        let begins = |at: &usize| nodes.get(*at).is_some_and(Node::begins) || entering.contains_key(at);
        let mut waiting: VecDeque<usize> = (0..objects.len()).filter(begins).collect();
        let mut waits: Vec<bool> = (0..objects.len()).map(|at| begins(&at)).collect();
        // Sets only grow, so that this ends; with wires in a circle too.
        while let Some(at) = waiting.pop_front() {
            set(&mut waits, at, false);
            let (Some(object), Some(node)) = (objects.get(at), nodes.get(at)) else { continue };
            // What is disabled gives nothing, in Grasshopper as well.
            if object.locked {
                continue;
            }
            let inputs: Vec<Needs> =
                (0..object.inputs.len()).map(|input| found.at_sources(wires.sources(at, input))).collect();
            let handed = wires.ends.get(&at).map(|end| {
                Needs::of_all(
                    &wires.inputs(*end).iter().map(|read| found.at_sources(read)).collect::<Vec<_>>(),
                )
            });
            let outputs = node.outputs(&inputs, object.outputs.len());
            if found.put(at, &outputs, entering.get(&at).into_iter().chain(&handed)) {
                for &reader in wires.readers(at) {
                    if !set(&mut waits, reader, true) {
                        waiting.push_back(reader);
                    }
                }
            }
            if let Some(taken) = found.taken.get_mut(at) {
                taken.missing.join(&node.own);
                taken.join(&Needs::of_all(&inputs));
            }
        }
        found
    }

    /// Adds what the outputs of an object need, and what all of them need besides; tells whether anything is new.
    fn put<'a>(&mut self, at: usize, outputs: &[Needs], all: impl Iterator<Item = &'a Needs>) -> bool {
        let besides = Needs::of_all(all);
        let mut grew = false;
        for (slot, needs) in self.given.get_mut(at).into_iter().flatten().zip(outputs) {
            grew |= slot.join(needs);
            grew |= slot.join(&besides);
        }
        grew
    }

    fn at_sources(&self, sources: &[Source]) -> Needs {
        Needs::of_all(sources.iter().filter_map(|(object, output)| self.given.get(*object)?.get(*output)))
    }

    /// What the data that an object gives needs; of one without outputs, what the data that it takes needs.
    pub(super) fn at(&self, object: usize) -> Needs {
        match self.given.get(object).map_or(&[][..], Vec::as_slice) {
            [] => self.taken.get(object).cloned().unwrap_or_default(),
            outputs => Needs::of_all(outputs),
        }
    }
}

/// Sets a flag; tells what it was.
fn set(flags: &mut [bool], at: usize, to: bool) -> bool {
    flags.get_mut(at).is_some_and(|flag| std::mem::replace(flag, to))
}

/// What an object makes of what its inputs need.
struct Node {
    /// The missing types that the object itself is of.
    own: Causes,
    /// Of a cluster, what each output needs.
    inside: Option<Vec<Needs>>,
}

impl Node {
    fn of(object: &Object, missing: &Missing) -> Self {
        let mut own = Causes::default();
        missing.get(&object.id).into_iter().flatten().for_each(|cause| own.insert(*cause));
        let inside = match object.cluster(&Limits::default()) {
            Some(Ok(ClusterContent::Open { document, hooks })) if own.is_empty() => {
                Some(through(object, &document, &hooks, missing))
            }
            _ => None,
        };
        Self { own, inside }
    }

    /// Whether anything missing may come from it.
    fn begins(&self) -> bool {
        !self.own.is_empty() || self.inside.iter().flatten().any(|needs| !needs.missing.is_empty())
    }

    /// What each of so many outputs needs.
    fn outputs(&self, inputs: &[Needs], count: usize) -> Vec<Needs> {
        let Some(inside) = &self.inside else {
            let mut all = Needs::of_all(inputs);
            all.missing.join(&self.own);
            return vec![all; count];
        };
        let output = |within: &Needs| {
            let mut all = Needs::of_all(within.inputs.iter().filter_map(|input| inputs.get(input)));
            all.missing.join(&within.missing);
            all
        };
        inside.iter().map(output).collect()
    }
}

/// For each output of a cluster the missing types inside that it needs, and which of the cluster's inputs it reads.
fn through(cluster: &Object, document: &Document, hooks: &[Hook], missing: &Missing) -> Vec<Needs> {
    let lookup = document.lookup();
    let inner =
        |port: Uuid| hooks.iter().find(|hook| hook.port == port).and_then(|hook| lookup.object(hook.object));
    let mut entering: HashMap<usize, Needs> = HashMap::new();
    for (input, port) in cluster.inputs.iter().enumerate() {
        if let Some(inner) = inner(port.id) {
            entering.entry(inner).or_default().inputs.insert(input);
        }
    }
    let found = Hanging::within(document, missing, &entering);
    cluster.outputs.iter().map(|port| inner(port.id).map_or_else(Needs::default, |at| found.at(at))).collect()
}

/// An output by its object and its number there.
type Source = (usize, usize);

/// The wires of a document between places of objects and ports.
struct Wires {
    /// For each object, for each input, the outputs it reads: object and output.
    sources: Vec<Vec<Vec<Source>>>,
    /// For each object those that read it, each once; the start of a loop reads its end.
    readers: Vec<Vec<usize>>,
    /// The end of the loop that an object is the start of.
    ends: HashMap<usize, usize>,
}

impl Wires {
    fn of(document: &Document) -> Self {
        let lookup = document.lookup();
        let mut wires = Self {
            sources: document.objects.iter().map(|object| vec![Vec::new(); object.inputs.len()]).collect(),
            readers: vec![Vec::new(); document.objects.len()],
            ends: HashMap::new(),
        };
        for wire in document.wires() {
            let Some(from) = lookup.output(wire.from) else { continue };
            wires.read(from.object, wire.object);
            let sources = wires.sources.get_mut(wire.object).and_then(|inputs| inputs.get_mut(wire.input));
            if let Some(sources) = sources {
                sources.push((from.object, from.port));
            }
        }
        wires.close_loops(document, &lookup);
        wires
    }

    fn read(&mut self, from: usize, reader: usize) {
        if let Some(readers) = self.readers.get_mut(from).filter(|readers| !readers.contains(&reader)) {
            readers.push(reader);
        }
    }

    /// No wire leads from the end of a loop back to its start: the link does.
    fn close_loops(&mut self, document: &Document, lookup: &Lookup) {
        for (end, object) in document.objects.iter().enumerate() {
            // Most objects have other names, whichever plug-in they are of.
            if !object.name.contains("Loop") {
                continue;
            }
            let Some(found) = of_object(document, object) else { continue };
            if ![ids::LOOP_END, ids::FAST_LOOP_END].contains(&found.component.guid) {
                continue;
            }
            let link = (0..object.inputs.len()).find(|input| found.input_place(*input) == Some(0));
            let sources =
                link.and_then(|input| object.inputs.get(input)).map_or(&[][..], |port| &port.sources);
            let Some(start) = sources.iter().find_map(|id| lookup.output(*id)) else { continue };
            self.ends.insert(start.object, end);
            // Whoever hands data to the end hands it to the start.
            let from: Vec<usize> =
                self.sources.get(end).into_iter().flatten().flatten().map(|source| source.0).collect();
            from.into_iter().for_each(|from| self.read(from, start.object));
        }
    }

    /// What each input of an object reads.
    fn inputs(&self, object: usize) -> &[Vec<Source>] {
        self.sources.get(object).map_or(&[], Vec::as_slice)
    }

    fn sources(&self, object: usize, input: usize) -> &[Source] {
        self.inputs(object).get(input).map_or(&[], Vec::as_slice)
    }

    fn readers(&self, object: usize) -> &[usize] {
        self.readers.get(object).map_or(&[], Vec::as_slice)
    }
}
