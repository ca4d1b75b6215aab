//! Takes the next state of a document in, and finds out which results it leaves standing.

use std::sync::Arc;

use katydid_data::cast::Rules;
use katydid_definition::archive::Chunk;
use katydid_definition::document::{Difference, Misfit, Object};

use crate::Engine;
use crate::graph::{Graph, Source};

impl Engine {
    /// Takes a step of the document. Results stay where neither the object nor anything that it reads is another than
    /// before; all else is dirty. What only the canvas shows, a place or a colour, makes nothing dirty. A change in
    /// place costs by what hangs on it, any other by the size of the document, without solving.
    ///
    /// # Errors
    /// When the difference was made for another document: nothing is changed then.
    pub fn apply(&mut self, difference: &Difference) -> Result<(), Misfit> {
        let counterparts = difference.counterparts(&self.document);
        let back = self.document.apply(difference)?;
        let changes = || back.put.iter().zip(&difference.put).map(|((at, old), (_, new))| (*at, old, new));
        if difference.is_in_place() && changes().all(|(_, old, new)| same_wires(old, new)) {
            for (at, _, _) in changes().filter(|(_, old, new)| !solve_alike(old, new)) {
                self.touch(at);
            }
            return Ok(());
        }
        // The places that objects come back to are those that they were taken from.
        let old = |at: &usize| {
            let k = back.put.binary_search_by_key(at, |(place, _)| *place).ok()?;
            back.put.get(k).map(|(_, object)| object)
        };
        self.rewire(difference, &pair(difference, &counterparts, old));
        Ok(())
    }

    /// Other units or tolerances: everything is dirty, unless they are those that were.
    pub fn set_rules(&mut self, rules: Rules) {
        if self.options.rules != rules {
            self.options.rules = rules;
            self.forget();
        }
    }

    /// Makes everything dirty.
    pub fn forget(&mut self) {
        self.reports.fill(None);
        self.dirty = (0..self.reports.len()).collect();
    }

    /// Brings the graph and the results in line with a document whose objects or wires are others. `pairs` has, for
    /// each object that was put, where it was before and whether it solves as it did.
    fn rewire(&mut self, difference: &Difference, pairs: &[(usize, Option<(usize, bool)>)]) {
        let count = self.document.objects.len();
        // Where each object was.
        let mut was: Vec<Option<usize>> = Vec::with_capacity(count);
        let mut going = difference.removed.iter().copied().peekable();
        let mut staying = (0..self.reports.len()).filter(|at| going.next_if_eq(at).is_none());
        let mut coming = pairs.iter().peekable();
        for at in 0..count {
            was.push(match coming.next_if(|(place, _)| *place == at) {
                Some((_, from)) => from.map(|(from, _)| from),
                None => staying.next(),
            });
        }
        let mut now: Vec<Option<usize>> = vec![None; self.reports.len()];
        for (at, from) in was.iter().enumerate() {
            if let Some(slot) = from.and_then(|from| now.get_mut(from)) {
                *slot = Some(at);
            }
        }
        // Places are others now: what was given to them is not.
        self.given.clear();
        self.memory = None;
        let graph = std::mem::replace(&mut self.graph, Arc::new(Graph::new(&self.document)));
        let mut reports = std::mem::take(&mut self.reports);
        self.reports = was
            .iter()
            .map(|from| from.and_then(|from| reports.get_mut(from)).and_then(Option::take))
            .collect();
        self.dirty = (0..count).filter(|at| self.reports.get(*at).is_some_and(Option::is_none)).collect();
        for (at, from) in pairs {
            if !from.is_some_and(|(_, alike)| alike) {
                self.touch(*at);
            }
        }
        let moved = |source: &Source| {
            let object = now.get(source.object).copied().flatten()?;
            Some(Source { object, output: source.output })
        };
        for (at, from) in was.iter().enumerate() {
            let Some(from) = *from else { continue };
            let same_sources = same_sources(graph.sources.get(from), self.graph.sources.get(at), &moved);
            // An output that nobody read may have been left out.
            let wanted = match (graph.wanted.get(from), self.graph.wanted.get(at)) {
                (Some(old), Some(new)) => {
                    old.len() == new.len() && old.iter().zip(new).all(|(old, new)| old >= new)
                }
                _ => false,
            };
            if !same_sources || self.options.skip_unread && !wanted {
                self.touch(at);
            }
        }
        // Who is in a loop says with whom.
        let looped = |at: &usize| now.get(*at).copied().flatten();
        let before: Vec<Vec<Option<usize>>> =
            graph.loops.iter().map(|members| members.iter().map(looped).collect()).collect();
        let same = before.len() == self.graph.loops.len()
            && before
                .iter()
                .zip(&self.graph.loops)
                .all(|(a, b)| a.iter().copied().eq(b.iter().copied().map(Some)));
        if !same {
            let members: Vec<usize> = before
                .iter()
                .flatten()
                .filter_map(|at| *at)
                .chain(self.graph.loops.iter().flatten().copied())
                .collect();
            for at in members {
                self.touch(at);
            }
        }
    }
}

/// For each object that is put: its place, the place of the one of its id before, and whether that one solves alike.
fn pair<'a>(
    difference: &Difference,
    counterparts: &[Option<usize>],
    old: impl Fn(&usize) -> Option<&'a Object>,
) -> Vec<(usize, Option<(usize, bool)>)> {
    let before = |new: &Object, from: usize| old(&from).is_some_and(|old| solve_alike(old, new));
    difference
        .put
        .iter()
        .zip(counterparts)
        .map(|((at, new), from)| (*at, from.map(|from| (from, before(new, from)))))
        .collect()
}

fn same_sources(
    old: Option<&Vec<Vec<Source>>>,
    new: Option<&Vec<Vec<Source>>>,
    moved: &impl Fn(&Source) -> Option<Source>,
) -> bool {
    let (Some(old), Some(new)) = (old, new) else { return false };
    old.len() == new.len()
        && old.iter().zip(new).all(|(old, new)| {
            old.len() == new.len() && old.iter().zip(new).all(|(old, new)| moved(old) == Some(*new))
        })
}

/// Whether two states of an object have the same ports with the same wires.
fn same_wires(a: &Object, b: &Object) -> bool {
    let inputs = a.id == b.id
        && a.inputs.len() == b.inputs.len()
        && a.inputs.iter().zip(&b.inputs).all(|(a, b)| a.id == b.id && a.sources == b.sources);
    inputs
        && a.outputs.len() == b.outputs.len()
        && a.outputs.iter().zip(&b.outputs).all(|(a, b)| a.id == b.id)
}

/// What of an object's chunk only the canvas and the viewport show.
const SHOWN: [&str; 5] = ["Hidden", "WireDisplay", "IconDisplay", "IconOverride", "Description"];

/// Whether two states of an object give the same data and messages when they read the same.
fn solve_alike(a: &Object, b: &Object) -> bool {
    a.is_same(b) || alike(a.chunk(), b.chunk())
}

fn alike(a: &Chunk, b: &Chunk) -> bool {
    // The number of an object among the others is the document's business.
    let numbered_alike = a.index == b.index || a.name == "Object";
    let items = a.items == b.items || {
        let mut of_b = b.items.iter().filter(|item| counts(&item.name));
        let all = a.items.iter().filter(|item| counts(&item.name)).all(|item| of_b.next() == Some(item));
        all && of_b.next().is_none()
    };
    let mut of_b = b.chunks.iter().filter(|chunk| chunk.name != "Attributes");
    let mut of_a = a.chunks.iter().filter(|chunk| chunk.name != "Attributes");
    a.name == b.name
        && numbered_alike
        && items
        && of_a.all(|inner| of_b.next().is_some_and(|other| alike(inner, other)))
        && of_b.next().is_none()
}

/// Whether an item of this name can make a difference to the solution.
fn counts(name: &str) -> bool {
    !SHOWN.contains(&name)
}
