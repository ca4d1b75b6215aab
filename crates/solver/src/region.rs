//! Regions of a graph that are solved in rounds: what lies between the start and the end of a loop.
//!
//! No wire of a definition leads back. A Loop Start hands a link to its Loop End; what hangs on the start and is read by the end,
//! be it through others, is the region between them. For the order of a solution the region is one step, its end's: it waits for
//! all that the region reads from outside, and whoever reads an object of the region waits for the end.

use std::collections::{BTreeSet, HashMap};

use katydid_component::{plugin_of_library, registry};
use katydid_definition::document::{Document, Object, ids};

use crate::graph::Source;
use crate::object::of_object;

/// The plug-ins that have loops, by the names of their tabs.
const PLUGINS: [&str; 2] = ["Anemone", "HoopSnake"];

/// So many loops may lie within each other: each takes a part of the thread's stack.
const DEEPEST: usize = 16;

/// So many loops of a document are looked at: finding what lies between takes time in proportion to loops and wires.
const MOST_LOOPS: usize = 1000;

/// What part an object has in a loop.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Role {
    /// It gives the state out at the beginning of each round.
    Start,
    /// It takes the state in at the end of each round.
    End,
    /// It is both, and its wires lead back to it.
    Both,
}

impl Role {
    fn of_component(component: uuid::Uuid) -> Option<Self> {
        match component {
            ids::LOOP_START | ids::FAST_LOOP_START => Some(Self::Start),
            ids::LOOP_END | ids::FAST_LOOP_END => Some(Self::End),
            ids::HOOP_SNAKE => Some(Self::Both),
            _ => None,
        }
    }

    /// The part of an object, found by its component's id or by the names that a file gives.
    pub(crate) fn of(document: &Document, object: &Object) -> Option<Self> {
        if object.locked {
            return None;
        }
        if let Some(component) = registry::by_guid(object.component) {
            return Self::of_component(component.guid);
        }
        let library = document.library(object.lib?)?;
        let plugin = plugin_of_library(&library.name)?;
        if !PLUGINS.contains(&plugin.name) {
            return None;
        }
        Self::of_component(of_object(document, object)?.component.guid)
    }
}

/// A region that is solved in rounds.
#[derive(Debug, Clone)]
pub(crate) struct Region {
    pub(crate) start: usize,
    /// The same as the start where one object is both.
    pub(crate) end: usize,
    /// What is solved in a round, in order.
    pub(crate) steps: Vec<Step>,
    /// All its objects with start and end.
    pub(crate) all: BTreeSet<usize>,
}

/// One step of a round.
#[derive(Debug, Clone)]
pub(crate) enum Step {
    Object(usize),
    /// A loop within the loop.
    Rounds(Region),
}

/// All regions of a graph.
#[derive(Debug, Default)]
pub(crate) struct Regions {
    /// Those that lie in no other, by their ends.
    pub(crate) outermost: HashMap<usize, Region>,
    /// For each object in a region, the end of the outermost one.
    end_of: HashMap<usize, usize>,
    /// The ends of loops that cross others, or whose objects read each other in a circle: these have no rounds.
    pub(crate) refused: BTreeSet<usize>,
}

impl Regions {
    /// The regions of a document with these wires.
    pub(crate) fn find(document: &Document, sources: &[Vec<Vec<Source>>], readers: &[Vec<usize>]) -> Self {
        let mut regions = Self::default();
        let roles: HashMap<usize, Role> = document
            .objects
            .iter()
            .enumerate()
            .filter_map(|(at, object)| Some((at, Role::of(document, object)?)))
            .collect();
        if roles.is_empty() {
            return regions;
        }
        let mut pairs = pairs(&roles, sources, readers, &mut regions.refused);
        // Who holds another stands before it.
        pairs.sort_by_key(|pair| (std::cmp::Reverse(pair.all.len()), pair.end));
        let mut held: Vec<Pair> = Vec::new();
        for pair in pairs {
            let around = held.iter().filter(|other| other.holds(&pair)).count();
            let apart = held.iter().filter(|other| other.all.is_disjoint(&pair.all)).count();
            if around + apart == held.len() && around < DEEPEST {
                held.push(pair);
            } else {
                regions.refused.insert(pair.end);
            }
        }
        let mut rest = held.as_slice();
        while let Some((pair, others)) = rest.split_first() {
            rest = others;
            if regions.end_of.contains_key(&pair.end) {
                continue;
            }
            let inner: Vec<&Pair> = others.iter().filter(|other| pair.holds(other)).collect();
            match region(pair, &inner, readers) {
                Some(region) => {
                    regions.end_of.extend(region.all.iter().map(|member| (*member, region.end)));
                    regions.outermost.insert(region.end, region);
                }
                None => {
                    regions.refused.insert(pair.end);
                }
            }
        }
        regions
    }

    /// The end of the outermost region that the object lies in.
    pub(crate) fn end_of(&self, object: usize) -> Option<usize> {
        self.end_of.get(&object).copied()
    }

    /// All objects of the outermost region that the object lies in.
    pub(crate) fn fellows(&self, object: usize) -> impl Iterator<Item = usize> {
        let region = self.end_of(object).and_then(|end| self.outermost.get(&end));
        region.into_iter().flat_map(|region| region.all.iter().copied())
    }

    /// Who waits for an object, from who reads it: a region waits at its end, and its objects are there when the end is.
    pub(crate) fn followers(&self, readers: &[Vec<usize>]) -> Vec<Vec<usize>> {
        let follow = |(object, readers): (usize, &Vec<usize>)| {
            let own = self.end_of(object);
            let mut followers: Vec<usize> = Vec::with_capacity(readers.len());
            for &reader in readers {
                let end = self.end_of(reader);
                let waits = end.unwrap_or(reader);
                let within = own.is_some() && own == end;
                if !within && !followers.contains(&waits) {
                    followers.push(waits);
                }
            }
            if own == Some(object) {
                followers.extend(self.fellows(object).filter(|fellow| *fellow != object));
            }
            followers
        };
        readers.iter().enumerate().map(follow).collect()
    }
}

/// A start and an end that belong together, with all that lies between them.
#[derive(Debug)]
struct Pair {
    start: usize,
    end: usize,
    all: BTreeSet<usize>,
}

impl Pair {
    /// Whether the other lies between this start and this end.
    fn holds(&self, other: &Self) -> bool {
        let own = |at: &usize| *at == self.start || *at == self.end;
        other.all.iter().all(|at| self.all.contains(at) && !own(at))
    }
}

/// Each end with the start whose link it reads; of several ends of a start the first.
fn pairs(
    roles: &HashMap<usize, Role>,
    sources: &[Vec<Vec<Source>>],
    readers: &[Vec<usize>],
    refused: &mut BTreeSet<usize>,
) -> Vec<Pair> {
    let mut ends: Vec<usize> = roles.keys().copied().collect();
    ends.sort_unstable();
    let mut taken = BTreeSet::new();
    let mut pairs = Vec::new();
    for end in ends {
        let start = match roles.get(&end) {
            Some(Role::Both) => Some(end),
            Some(Role::End) => linked_start(roles, sources, end),
            _ => None,
        };
        let Some(start) = start else { continue };
        if pairs.len() == MOST_LOOPS || !taken.insert(start) {
            refused.insert(end);
            continue;
        }
        let behind = reached(start, end, |at| readers.get(at).into_iter().flatten().copied());
        let before = reached(end, start, |at| {
            sources.get(at).into_iter().flatten().flatten().map(|source| source.object)
        });
        let mut all: BTreeSet<usize> = behind.intersection(&before).copied().collect();
        // A snake whose tail hangs in the air goes no rounds.
        if start == end && all.is_empty() {
            continue;
        }
        all.extend([start, end]);
        pairs.push(Pair { start, end, all });
    }
    pairs
}

/// The start whose first output, the link, an end reads.
fn linked_start(roles: &HashMap<usize, Role>, sources: &[Vec<Vec<Source>>], end: usize) -> Option<usize> {
    let links = sources.get(end)?.iter().flatten().filter(|source| source.output == 0);
    links.map(|source| source.object).find(|object| roles.get(object) == Some(&Role::Start))
}

/// What is reached from an object, without going on from the last one.
fn reached<I: Iterator<Item = usize>>(
    first: usize,
    last: usize,
    next: impl Fn(usize) -> I,
) -> BTreeSet<usize> {
    let mut seen = BTreeSet::new();
    let mut stack: Vec<usize> = next(first).collect();
    while let Some(at) = stack.pop() {
        if at != last && at != first && seen.insert(at) {
            stack.extend(next(at));
        }
    }
    seen
}

/// The region of a pair: what lies between in order (Kahn), each loop inside as one step; `None` when the order has a circle.
fn region(pair: &Pair, inner: &[&Pair], readers: &[Vec<usize>]) -> Option<Region> {
    let mut steps_at: HashMap<usize, Step> = HashMap::new();
    let mut step_of: HashMap<usize, usize> = HashMap::new();
    for (k, loop_inside) in inner.iter().enumerate() {
        if step_of.contains_key(&loop_inside.end) {
            continue;
        }
        let deeper: Vec<&Pair> =
            inner.iter().skip(k + 1).copied().filter(|other| loop_inside.holds(other)).collect();
        step_of.extend(loop_inside.all.iter().map(|member| (*member, loop_inside.end)));
        steps_at.insert(loop_inside.end, Step::Rounds(region(loop_inside, &deeper, readers)?));
    }
    let between = || pair.all.iter().copied().filter(|at| *at != pair.start && *at != pair.end);
    for at in between() {
        step_of.entry(at).or_insert_with(|| {
            steps_at.insert(at, Step::Object(at));
            at
        });
    }
    let mut follows: HashMap<usize, BTreeSet<usize>> = HashMap::new();
    let mut missing: HashMap<usize, usize> = steps_at.keys().map(|step| (*step, 0)).collect();
    for at in between() {
        let Some(&from) = step_of.get(&at) else { continue };
        let all = readers.get(at).into_iter().flatten();
        for &to in all.filter_map(|reader| step_of.get(reader)).filter(|to| **to != from) {
            if follows.entry(from).or_default().insert(to) {
                *missing.entry(to).or_default() += 1;
            }
        }
    }
    let mut ready: BTreeSet<usize> =
        missing.iter().filter(|(_, count)| **count == 0).map(|(step, _)| *step).collect();
    let mut steps = Vec::with_capacity(steps_at.len());
    while let Some(step) = ready.pop_first() {
        steps.extend(steps_at.remove(&step));
        for next in follows.get(&step).into_iter().flatten() {
            if let Some(count) = missing.get_mut(next) {
                *count = count.saturating_sub(1);
                if *count == 0 {
                    ready.insert(*next);
                }
            }
        }
    }
    steps_at.is_empty().then(|| Region { start: pair.start, end: pair.end, steps, all: pair.all.clone() })
}
