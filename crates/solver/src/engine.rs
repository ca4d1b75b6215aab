use std::collections::HashMap;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Duration;

use katydid_component::{Deadline, Message};
use katydid_data::Tree;
use katydid_definition::document::Document;
use uuid::Uuid;

use crate::graph::Graph;
use crate::object::{Turn, solve};
use crate::report::{ObjectReport, Status};
use crate::{Options, Progress, schedule};

/// A document with its solution: solves what is dirty, and keeps the rest.
#[derive(Debug)]
pub struct Engine {
    document: Document,
    options: Options,
    graph: Graph,
    reports: Vec<Option<ObjectReport>>,
}

/// What one solve did.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Summary {
    /// How many objects were solved.
    pub solved: usize,
    /// How long it took; zero where there is no clock.
    pub time: Duration,
}

impl Engine {
    /// An engine for a document; nothing is solved yet.
    pub fn new(document: Document, options: Options) -> Self {
        let graph = Graph::new(&document);
        let reports = vec![None; document.objects.len()];
        Self { document, options, graph, reports }
    }

    /// The document.
    pub fn document(&self) -> &Document {
        &self.document
    }

    /// What a solve may use, and how it reads the document.
    pub fn options(&self) -> &Options {
        &self.options
    }

    /// The same, to be changed; results that stand are kept.
    pub fn options_mut(&mut self) -> &mut Options {
        &mut self.options
    }

    /// The report of the object at `index` of the document's objects; `None` while it is dirty.
    pub fn report(&self, index: usize) -> Option<&ObjectReport> {
        self.reports.get(index)?.as_ref()
    }

    /// Changes objects without adding, removing or rewiring any. Those that `change` names are dirty then.
    pub fn edit(&mut self, change: impl FnOnce(&mut Document) -> Vec<Uuid>) {
        let changed = change(&mut self.document);
        if self.document.objects.len() != self.reports.len() {
            return self.rebuild();
        }
        for id in changed {
            if let Some(index) = self.document.objects.iter().position(|o| o.id == id) {
                self.touch(index);
            }
        }
    }

    /// Changes the document in any way. Everything is dirty then.
    pub fn replace(&mut self, change: impl FnOnce(&mut Document)) {
        change(&mut self.document);
        self.rebuild();
    }

    fn rebuild(&mut self) {
        self.graph = Graph::new(&self.document);
        self.reports = vec![None; self.document.objects.len()];
    }

    /// Marks an object and all that hangs on it as dirty.
    fn touch(&mut self, index: usize) {
        let mut stack = vec![index];
        while let Some(object) = stack.pop() {
            // What is dirty already has dirty readers.
            if self.reports[object].take().is_some() || object == index {
                stack.extend(
                    self.graph.readers[object].iter().copied().filter(|&r| self.reports[r].is_some()),
                );
            }
        }
    }

    /// Solves what is dirty.
    pub fn solve(&mut self) -> Summary {
        let watch = Watch::start();
        let turn = Turn {
            document: &self.document,
            options: &self.options,
            deadline: Deadline::after(self.options.limits.time),
            depth: 0,
            given: &HashMap::new(),
            wanted: &[],
        };
        let solved = solve_graph(&turn, &self.graph, &mut self.reports);
        Summary { solved, time: watch.elapsed() }
    }
}

/// Solves a whole nested document.
pub(crate) fn solve_nested(
    document: &Document,
    outer: &Turn<'_>,
    given: &HashMap<usize, Tree>,
) -> Vec<ObjectReport> {
    let graph = Graph::new(document);
    let mut reports = vec![None; document.objects.len()];
    // Progress counts the objects of the outermost document.
    let options = Options { progress: None, ..outer.options.clone() };
    let turn = Turn {
        document,
        options: &options,
        deadline: outer.deadline,
        depth: outer.depth + 1,
        given,
        wanted: &[],
    };
    solve_graph(&turn, &graph, &mut reports);
    reports.into_iter().map(|r| r.unwrap_or_else(|| ObjectReport::idle(Status::Ok, Vec::new(), 0))).collect()
}

/// Fills in the reports that are missing.
fn solve_graph(turn: &Turn<'_>, graph: &Graph, reports: &mut [Option<ObjectReport>]) -> usize {
    let objects = &turn.document.objects;
    for members in &graph.loops {
        for &member in members {
            reports[member] = Some(in_loop(turn.document, members, member));
        }
    }
    // Objects in a loop are never run: they have their report by now.
    let todo: Vec<bool> = reports.iter().map(Option::is_none).collect();
    let results: Vec<OnceLock<ObjectReport>> = reports.iter().map(|_| OnceLock::new()).collect();
    let total = todo.iter().filter(|&&t| t).count();
    let done = AtomicUsize::new(0);
    let kept: &[Option<ObjectReport>] = reports;
    schedule::run(graph, &todo, &results, |object| {
        let watch = Watch::start();
        let tree = |source: &crate::graph::Source| -> Option<&Tree> {
            let report = results[source.object].get().or(kept[source.object].as_ref())?;
            report.outputs.get(source.output)
        };
        let wired: Vec<Vec<&Tree>> =
            graph.sources[object].iter().map(|sources| sources.iter().filter_map(tree).collect()).collect();
        let wanted = if turn.options.skip_unread { &graph.wanted[object][..] } else { &[] };
        let turn = Turn { wanted, ..*turn };
        let mut report = solve(&turn, object, &wired);
        report.time = watch.elapsed();
        if let Some(progress) = &turn.options.progress {
            let done = done.fetch_add(1, Ordering::Relaxed) + 1;
            progress(&Progress { done, total, name: objects[object].title().to_owned() });
        }
        report
    });
    for (report, result) in reports.iter_mut().zip(results) {
        if let Some(result) = result.into_inner() {
            *report = Some(result);
        }
    }
    total
}

/// The report of an object in a loop: it names the objects on the way round.
fn in_loop(document: &Document, members: &[usize], member: usize) -> ObjectReport {
    let title = |&index: &usize| document.objects.get(index).map_or("?", |o| o.title());
    let names: Vec<&str> = members.iter().take(12).map(title).collect();
    let more = if members.len() > names.len() { " and others" } else { "" };
    let text = match members.len() {
        1 => format!("{} reads its own output", names.join("")),
        _ => format!("These objects read each other in a loop: {}{more}", names.join(", ")),
    };
    let outputs = document.objects.get(member).map_or(0, |o| o.outputs.len());
    ObjectReport::idle(Status::Error, vec![Message::error(text)], outputs)
}

/// A stopwatch; without a clock it stands still.
struct Watch(#[cfg(not(target_family = "wasm"))] std::time::Instant);

impl Watch {
    fn start() -> Self {
        Self(
            #[cfg(not(target_family = "wasm"))]
            std::time::Instant::now(),
        )
    }

    fn elapsed(&self) -> Duration {
        #[cfg(not(target_family = "wasm"))]
        return self.0.elapsed();
        #[cfg(target_family = "wasm")]
        Duration::ZERO
    }
}
