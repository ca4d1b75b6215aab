//! Who reads whom: the objects of a document as nodes, its wires as arrows between them.

use std::collections::{BTreeMap, HashMap};

use katydid_definition::document::Document;
use uuid::Uuid;

use crate::region::Regions;

/// An output that an input reads.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Source {
    /// The object.
    pub(crate) object: usize,
    /// Its output.
    pub(crate) output: usize,
}

/// The wires of a document, between indices into its objects.
#[derive(Debug, Default)]
pub(crate) struct Graph {
    /// For each object, for each input, the outputs it reads in wire order.
    pub(crate) sources: Vec<Vec<Vec<Source>>>,
    /// For each object, the objects that read it; each once.
    pub(crate) readers: Vec<Vec<usize>>,
    /// For each object, those that wait for it in a solution: they read it, or are solved in rounds with who reads it. Empty
    /// where nothing is solved in rounds: those that wait are its readers then.
    followers: Vec<Vec<usize>>,
    /// What is solved in rounds.
    pub(crate) regions: Regions,
    /// For each object, for each output, whether anybody reads it.
    pub(crate) wanted: Vec<Vec<bool>>,
    /// The objects in an order in which each stands behind all it reads. Objects in a loop are left out.
    pub(crate) order: Vec<usize>,
    /// For each object, its place in `order`; `None` in a loop.
    pub(crate) rank: Vec<Option<u32>>,
    /// The loops: the objects of each, in the order of the document.
    pub(crate) loops: Vec<Vec<usize>>,
    /// The objects that read their sources later than in the same solution, with those sources: they have none in
    /// `sources`, and read nobody as far as the order is concerned.
    pub(crate) late: BTreeMap<usize, Vec<Vec<Source>>>,
}

impl Graph {
    pub(crate) fn new(document: &Document) -> Self {
        Self::with_late(document, &[])
    }

    /// The graph of a document in which the objects of `late` read their wires in a later solution.
    pub(crate) fn with_late(document: &Document, late: &[usize]) -> Self {
        let objects = &document.objects;
        let mut outputs: HashMap<Uuid, Source> = HashMap::new();
        for (object, o) in objects.iter().enumerate() {
            for (output, port) in o.outputs.iter().enumerate() {
                // The first of two equal ids keeps it, as in Grasshopper.
                outputs.entry(port.id).or_insert(Source { object, output });
            }
        }
        let mut graph = Self {
            sources: Vec::with_capacity(objects.len()),
            readers: vec![Vec::new(); objects.len()],
            wanted: objects.iter().map(|o| vec![false; o.outputs.len()]).collect(),
            ..Self::default()
        };
        for (reader, o) in objects.iter().enumerate() {
            let is_late = late.contains(&reader);
            let mut inputs = Vec::with_capacity(o.inputs.len());
            for port in &o.inputs {
                let sources: Vec<Source> =
                    port.sources.iter().filter_map(|id| outputs.get(id).copied()).collect();
                for source in &sources {
                    graph.wanted[source.object][source.output] = true;
                    if !is_late && !graph.readers[source.object].contains(&reader) {
                        graph.readers[source.object].push(reader);
                    }
                }
                inputs.push(sources);
            }
            if is_late {
                let none = vec![Vec::new(); inputs.len()];
                graph.late.insert(reader, std::mem::replace(&mut inputs, none));
            }
            graph.sources.push(inputs);
        }
        graph.regions = Regions::find(document, &graph.sources, &graph.readers);
        if !graph.regions.outermost.is_empty() {
            graph.followers = graph.regions.followers(&graph.readers);
        }
        graph.sort();
        graph
    }

    /// Those that wait for an object in a solution.
    pub(crate) fn followers(&self, object: usize) -> &[usize] {
        let all = if self.followers.is_empty() { &self.readers } else { &self.followers };
        all.get(object).map_or(&[], Vec::as_slice)
    }

    /// Those that are solved anew when an object is: who reads it, and who goes rounds with it.
    pub(crate) fn hanging(&self, object: usize) -> impl Iterator<Item = usize> {
        let readers = self.readers.get(object).into_iter().flatten().copied();
        readers.chain(self.regions.fellows(object))
    }

    /// Kahn's algorithm for the order; what it leaves is in a loop or behind one, and Tarjan's tells which.
    fn sort(&mut self) {
        let n = self.readers.len();
        let mut missing: Vec<usize> = vec![0; n];
        for object in 0..n {
            for &reader in self.followers(object) {
                missing[reader] += 1;
            }
        }
        let looped = self.components_of_loops();
        for members in &looped {
            for &member in members {
                // An object in a loop never runs; those behind it do, without its data.
                missing[member] = usize::MAX;
            }
        }
        let mut ready: std::collections::VecDeque<usize> =
            (0..n).filter(|&object| missing[object] == 0).chain(looped.iter().flatten().copied()).collect();
        let mut order = Vec::with_capacity(n);
        while let Some(object) = ready.pop_front() {
            if missing[object] != usize::MAX {
                order.push(object);
            }
            for &reader in self.followers(object) {
                if missing[reader] != usize::MAX {
                    missing[reader] -= 1;
                    if missing[reader] == 0 {
                        ready.push_back(reader);
                    }
                }
            }
        }
        self.order = order;
        self.rank = vec![None; n];
        for (rank, &object) in (0..).zip(&self.order) {
            self.rank[object] = Some(rank);
        }
        self.loops = looped;
    }

    /// The strongly connected components of more than one object, and objects that read themselves.
    /// R. Tarjan, "Depth-first search and linear graph algorithms" (1972), with a stack of its own.
    fn components_of_loops(&self) -> Vec<Vec<usize>> {
        let n = self.readers.len();
        let mut index: Vec<Option<usize>> = vec![None; n];
        let mut low = vec![0; n];
        let mut on_stack = vec![false; n];
        let (mut stack, mut loops, mut next) = (Vec::new(), Vec::new(), 0);
        for root in 0..n {
            if index[root].is_some() {
                continue;
            }
            let mut walk = vec![(root, 0)];
            while let Some(&mut (v, ref mut edge)) = walk.last_mut() {
                if *edge == 0 {
                    index[v] = Some(next);
                    low[v] = next;
                    next += 1;
                    stack.push(v);
                    on_stack[v] = true;
                }
                if let Some(&w) = self.followers(v).get(*edge) {
                    *edge += 1;
                    match index[w] {
                        None => walk.push((w, 0)),
                        Some(seen) if on_stack[w] => low[v] = low[v].min(seen),
                        Some(_) => {}
                    }
                    // A first visit is told from a later one by the count of edges: keep it above zero.
                    continue;
                }
                walk.pop();
                if let Some(&(parent, _)) = walk.last() {
                    low[parent] = low[parent].min(low[v]);
                }
                if Some(low[v]) == index[v] {
                    let mut members = Vec::new();
                    while let Some(w) = stack.pop() {
                        on_stack[w] = false;
                        members.push(w);
                        if w == v {
                            break;
                        }
                    }
                    if members.len() > 1 || self.followers(v).contains(&v) {
                        members.sort_unstable();
                        loops.push(members);
                    }
                }
            }
        }
        loops.sort();
        loops
    }
}
