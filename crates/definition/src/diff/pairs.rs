//! Which object of the new document is which of the old.

use std::collections::HashMap;
use std::hash::Hash;

use uuid::Uuid;

use super::title;
use crate::document::{Document, Lookup, Object, Port, Side, Special};

/// Where a wire comes from, in terms of both documents.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Source {
    /// An output of an object of the old document.
    Old(usize, usize),
    /// An output that only the new document has.
    New(usize, usize),
    /// Nothing in the document.
    Nowhere(Uuid),
}

pub(super) struct Pairs<'a> {
    old: &'a Document,
    new: &'a Document,
    /// For each new object, the old one.
    before: Vec<Option<usize>>,
    /// For each old object, the new one.
    after: Vec<Option<usize>>,
    old_lookup: Lookup,
    new_lookup: Lookup,
    titles: [Vec<String>; 2],
}

impl<'a> Pairs<'a> {
    pub(super) fn of(old: &'a Document, new: &'a Document) -> Self {
        let mut pairs = Self {
            old,
            new,
            before: vec![None; new.objects.len()],
            after: vec![None; old.objects.len()],
            old_lookup: old.lookup(),
            new_lookup: new.lookup(),
            titles: [titles(old), titles(new)],
        };
        pairs.join(|object| object.id);
        pairs.join(|object| (object.component, object.nickname.clone()));
        pairs
    }

    /// Pairs those that are still alone and have the same key, in their order.
    fn join<K: Eq + Hash>(&mut self, key: impl Fn(&Object) -> K) {
        let mut waiting: HashMap<K, Vec<usize>> = HashMap::new();
        for (at, object) in self.old.objects.iter().enumerate().rev() {
            if self.after.get(at) == Some(&None) {
                waiting.entry(key(object)).or_default().push(at);
            }
        }
        for (at, object) in self.new.objects.iter().enumerate() {
            let Some(place) = self.before.get_mut(at).filter(|place| place.is_none()) else { continue };
            let Some(found) = waiting.get_mut(&key(object)).and_then(Vec::pop) else { continue };
            *place = Some(found);
            if let Some(after) = self.after.get_mut(found) {
                *after = Some(at);
            }
        }
    }

    pub(super) fn old_of(&self, new: usize) -> Option<usize> {
        self.before.get(new).copied().flatten()
    }

    pub(super) fn is_kept(&self, old: usize) -> bool {
        self.after.get(old).copied().flatten().is_some()
    }

    pub(super) fn old_title(&self, at: usize) -> String {
        self.titles[0].get(at).cloned().unwrap_or_default()
    }

    pub(super) fn new_title(&self, at: usize) -> String {
        self.titles[1].get(at).cloned().unwrap_or_default()
    }

    /// Whether the wires into an object, and the members of a group, mean the same in both documents: an id may be another
    /// object's, or nobody's, although the object that names it is as it was.
    pub(super) fn refers_alike(&self, object: &Object) -> bool {
        let same = |old: Option<usize>, new: Option<usize>| old == new.and_then(|at| self.old_of(at));
        let wired = object.inputs.iter().flat_map(|port| &port.sources).all(|id| {
            let (old, new) = (self.old_lookup.output(*id), self.new_lookup.output(*id));
            same(old.map(|port| port.object), new.map(|port| port.object))
                && old.map(|port| port.port) == new.map(|port| port.port)
                && old.is_some() == new.is_some()
        });
        let Some(Special::Group(group)) = object.special() else { return wired };
        wired
            && group.members.iter().all(|id| {
                let (old, new) = (self.old_lookup.object(*id), self.new_lookup.object(*id));
                same(old, new) && old.is_some() == new.is_some()
            })
    }

    /// Where a wire of the old document comes from, and what that is called.
    pub(super) fn old_source(&self, id: Uuid) -> (Source, String) {
        match self.old_lookup.output(id) {
            Some(port) => {
                let object = self.old.objects.get(port.object);
                let name = output_name(object, port.port, self.old_title(port.object));
                (Source::Old(port.object, port.port), name)
            }
            None => (Source::Nowhere(id), "nothing".to_owned()),
        }
    }

    /// As [`old_source`](Self::old_source), of the new document.
    pub(super) fn new_source(&self, id: Uuid) -> (Source, String) {
        let Some(port) = self.new_lookup.output(id) else {
            return (Source::Nowhere(id), "nothing".to_owned());
        };
        let object = self.new.objects.get(port.object);
        let name = output_name(object, port.port, self.new_title(port.object));
        let old = self.old_of(port.object);
        let before = old.and_then(|k| self.old.objects.get(k)).zip(object);
        let output = before.and_then(|(before, object)| {
            ports(before, object, Side::Output).into_iter().find(|(_, new)| *new == Some(port.port))?.0
        });
        match old.zip(output) {
            Some((object, output)) => (Source::Old(object, output), name),
            None => (Source::New(port.object, port.port), name),
        }
    }

    /// The object that an id of the old document means, in terms of both; and its name.
    pub(super) fn old_member(&self, id: Uuid) -> (Source, String) {
        match self.old_lookup.object(id) {
            Some(at) => (Source::Old(at, 0), self.old_title(at)),
            None => (Source::Nowhere(id), "something that is not there".to_owned()),
        }
    }

    /// As [`old_member`](Self::old_member), of the new document.
    pub(super) fn new_member(&self, id: Uuid) -> (Source, String) {
        let Some(at) = self.new_lookup.object(id) else {
            return (Source::Nowhere(id), "something that is not there".to_owned());
        };
        let source = self.old_of(at).map_or(Source::New(at, 0), |old| Source::Old(old, 0));
        (source, self.new_title(at))
    }
}

/// The titles of all objects; where two are alike, a part of the id tells them apart.
fn titles(document: &Document) -> Vec<String> {
    let plain: Vec<String> = document.objects.iter().map(title).collect();
    let mut counts: HashMap<&str, usize> = HashMap::new();
    for title in &plain {
        *counts.entry(title).or_default() += 1;
    }
    let alone = |title: &String| counts.get(title.as_str()).is_none_or(|n| *n < 2);
    let name = |(title, object): (&String, &Object)| {
        if alone(title) {
            return title.clone();
        }
        let id: String = object.id.to_string().chars().take(8).collect();
        format!("{title} @{id}")
    };
    plain.iter().zip(&document.objects).map(name).collect()
}

fn output_name(object: Option<&Object>, port: usize, title: String) -> String {
    let Some(object) = object.filter(|object| !object.is_floating() && object.outputs.len() > 1) else {
        // What it is is told where it itself is told about.
        return title.split(" (").next().unwrap_or_default().to_owned();
    };
    let port = object.outputs.get(port).map(port_name).unwrap_or_default();
    format!("{}.{port}", object.title())
}

/// How a port is called.
pub(super) fn port_name(port: &Port) -> String {
    if port.name.is_empty() { port.nickname.clone() } else { port.name.clone() }
}

/// Which port of one object is which of the other: by id, then by nickname, then by place.
pub(super) fn ports(old: &Object, new: &Object, side: Side) -> Vec<(Option<usize>, Option<usize>)> {
    let (old, new) = (old.ports(side), new.ports(side));
    let mut before: Vec<Option<usize>> = vec![None; new.len()];
    let mut taken = vec![false; old.len()];
    let mut join = |test: &dyn Fn(usize, &Port, usize, &Port) -> bool| {
        for (k, port) in new.iter().enumerate() {
            let Some(place) = before.get_mut(k).filter(|place| place.is_none()) else { continue };
            let free = |n: &usize| taken.get(*n) == Some(&false);
            let mut others = old.iter().enumerate();
            let found = others.find(|(n, other)| free(n) && test(*n, other, k, port)).map(|(n, _)| n);
            if let Some(n) = found {
                *place = Some(n);
                if let Some(taken) = taken.get_mut(n) {
                    *taken = true;
                }
            }
        }
    };
    join(&|_, a, _, b| a.id == b.id);
    join(&|_, a, _, b| a.nickname == b.nickname);
    if old.len() == new.len() {
        join(&|n, _, k, _| n == k);
    }
    let mut pairs: Vec<_> = before.iter().enumerate().map(|(k, old)| (*old, Some(k))).collect();
    pairs.extend(taken.iter().enumerate().filter(|(_, taken)| !**taken).map(|(n, _)| (Some(n), None)));
    pairs
}
