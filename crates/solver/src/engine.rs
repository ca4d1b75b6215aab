use std::collections::HashMap;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, OnceLock};
use std::time::Duration;

use katydid_component::{Account, Budget, Deadline, Message};
use katydid_data::Tree;
use katydid_definition::document::{Document, Object};
use web_time::Instant;

use crate::graph::{Graph, Source};
use crate::object::{Turn, solve};
use crate::report::{ObjectReport, Status};
use crate::schedule::Todo;
use crate::{Finished, Options, Progress, Scripts, rounds, schedule, script};

/// A document with its solution: solves what is dirty, and keeps the rest.
///
/// A clone shares documents and results until one of the two changes, so that many may solve one definition, each with
/// inputs of its own.
#[derive(Debug, Clone)]
pub struct Engine {
    pub(crate) document: Document,
    pub(crate) options: Options,
    pub(crate) graph: Arc<Graph>,
    pub(crate) reports: Vec<Option<ObjectReport>>,
    /// The objects without a report: a solve looks at these and at no others.
    pub(crate) dirty: Vec<usize>,
    /// What inputs read in place of their wires and of what they keep, by object and input.
    pub(crate) given: HashMap<(usize, usize), Tree>,
    /// What recorders have recorded, by object; `None` unless the definition runs in time.
    pub(crate) memory: Option<HashMap<usize, Tree>>,
    /// How many processes that run scripts had ended when results were last looked through for what they held.
    losses: u64,
}

/// What one solve did.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Summary {
    /// How many objects were solved.
    pub solved: usize,
    /// How many are dirty still: those that were not done when somebody cancelled, and all that hangs on them.
    pub unfinished: usize,
    /// How long it took; zero where there is no clock.
    pub time: Duration,
}

impl Engine {
    /// An engine for a document; nothing is solved yet.
    pub fn new(document: Document, options: Options) -> Self {
        let count = document.objects.len();
        Self {
            graph: Arc::new(Graph::new(&document)),
            document,
            options,
            reports: vec![None; count],
            dirty: (0..count).collect(),
            given: HashMap::new(),
            memory: None,
            losses: 0,
        }
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

    /// Changes the object at `index` of the document's objects, but not its wires. It and all that hangs on it are
    /// dirty then. Nothing happens when there is no such object.
    pub fn edit(&mut self, index: usize, change: impl FnOnce(&mut Object)) {
        if let Some(object) = self.document.objects.get_mut(index) {
            change(object);
            self.touch(index);
        }
    }

    /// Has the object at `index` solved anew by the next solve, and all that hangs on it. Nothing happens when there is
    /// no such object.
    pub fn expire(&mut self, index: usize) {
        if index < self.reports.len() {
            self.touch(index);
        }
    }

    /// Has scripts run by somebody else from now on. What objects hold in the process that ran them until now is made again by
    /// the next solve.
    pub fn run_scripts_by(&mut self, scripts: Arc<dyn Scripts>) {
        if self.options.scripts.as_ref().is_some_and(|known| Arc::ptr_eq(known, &scripts)) {
            return;
        }
        self.losses = scripts.losses();
        self.options.scripts = Some(scripts);
        self.expire_where(script::has_held);
    }

    /// Marks an object and all that hangs on it as dirty.
    pub(crate) fn touch(&mut self, index: usize) {
        let mut stack = vec![index];
        while let Some(object) = stack.pop() {
            // What is dirty already has dirty readers.
            if self.reports[object].take().is_some() {
                self.dirty.push(object);
                stack.extend(self.graph.hanging(object));
            }
        }
    }

    /// Marks all objects of a loop as dirty where one is: they are solved together or not at all.
    fn make_regions_whole(&mut self) {
        let graph = self.graph.clone();
        for region in graph.regions.outermost.values() {
            let is_dirty = |at: &usize| self.reports.get(*at).is_some_and(Option::is_none);
            if region.all.iter().any(is_dirty) {
                region.all.iter().for_each(|at| self.touch(*at));
            }
        }
    }

    /// The places of the objects that a solve would look at.
    pub fn dirty(&self) -> &[usize] {
        &self.dirty
    }

    /// Solves what is dirty. When somebody cancels, what is not done by then stays dirty, and keeps so until a solve
    /// with another [`Cancel`](katydid_component::Cancel).
    ///
    /// What scripts made and a process that has ended held is made again, once a solve: a script that ends its process
    /// each time does not keep it going for ever.
    pub fn solve(&mut self) -> Summary {
        self.expire_lost();
        let mut summary = self.solve_dirty();
        if self.expire_lost() {
            let again = self.solve_dirty();
            summary =
                Summary { solved: summary.solved + again.solved, time: summary.time + again.time, ..again };
        }
        summary
    }

    /// Expires what was lost with a process that ran scripts; tells whether anything was.
    fn expire_lost(&mut self) -> bool {
        let losses = self.options.scripts.as_ref().map_or(0, |scripts| scripts.losses());
        if losses == std::mem::replace(&mut self.losses, losses) {
            return false;
        }
        self.expire_where(script::has_lost)
    }

    /// Expires the objects with such reports; tells whether there were any.
    fn expire_where(&mut self, is_meant: impl Fn(&ObjectReport) -> bool) -> bool {
        let is_meant = |report: &Option<ObjectReport>| report.as_ref().is_some_and(&is_meant);
        let meant: Vec<usize> =
            (0..self.reports.len()).filter(|at| self.reports.get(*at).is_some_and(is_meant)).collect();
        meant.iter().for_each(|at| self.touch(*at));
        !meant.is_empty()
    }

    fn solve_dirty(&mut self) -> Summary {
        let watch = Instant::now();
        self.make_regions_whole();
        let most = self.options.limits.solve_bytes;
        let account = Arc::new(match &self.options.memory {
            Some(whole) => Account::part_of(whole.clone(), most),
            None => Account::new(most),
        });
        let turn = Turn {
            document: &self.document,
            options: &self.options,
            account: &account,
            deadline: Deadline::after(self.options.limits.time),
            depth: 0,
            given: &HashMap::new(),
            brought: &self.given,
            memory: self.memory.as_ref(),
            wanted: &[],
        };
        let solved = solve_graph(&turn, &self.graph, &mut self.reports, &self.dirty);
        if let Some(memory) = &mut self.memory {
            for &at in &self.dirty {
                let report = self.reports.get(at).and_then(Option::as_ref);
                memory.extend(report.and_then(|report| Some((at, report.recorded.clone()?))));
            }
        }
        let reports = &self.reports;
        self.dirty.retain(|at| reports.get(*at).is_some_and(Option::is_none));
        Summary { solved, unfinished: self.dirty.len(), time: watch.elapsed() }
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
    let options = Options { progress: None, finished: None, ..outer.options.clone() };
    let turn = Turn {
        document,
        options: &options,
        account: outer.account,
        deadline: outer.deadline,
        depth: outer.depth + 1,
        given,
        brought: &HashMap::new(),
        memory: None,
        wanted: &[],
    };
    let all: Vec<usize> = (0..reports.len()).collect();
    solve_graph(&turn, &graph, &mut reports, &all);
    reports.into_iter().map(|r| r.unwrap_or_else(|| ObjectReport::idle(Status::Ok, Vec::new(), 0))).collect()
}

/// Fills in the reports of the `dirty` objects, which are missing, and gives the number of those that ran. The time is
/// in proportion to them, not to the document.
fn solve_graph(
    turn: &Turn<'_>,
    graph: &Graph,
    reports: &mut [Option<ObjectReport>],
    dirty: &[usize],
) -> usize {
    let objects = &turn.document.objects;
    let (todo, looped) = Todo::new(graph, dirty);
    // Objects in a loop are never run, they only say so.
    for object in looped {
        let members = graph.loops.iter().find(|members| members.contains(&object));
        let report = in_loop(turn.document, members.map_or(&[], Vec::as_slice), object);
        tell(turn, object, &report);
        reports[object] = Some(report);
    }
    let results: Vec<OnceLock<Option<ObjectReport>>> = todo.iter().map(|_| OnceLock::new()).collect();
    let total = results.len();
    let done = AtomicUsize::new(0);
    let kept: &[Option<ObjectReport>] = reports;
    let cancelled = || turn.options.cancel.is_cancelled();
    // What objects of loops gave in the last round, from their ends to when it is their turn to say so.
    let last_round: Mutex<HashMap<usize, ObjectReport>> = Mutex::default();
    schedule::run(graph, &todo, &results, |object| {
        if cancelled() {
            return None;
        }
        let watch = Instant::now();
        let tree = |source: &Source| -> Option<&Tree> {
            let report = match todo.place(source.object) {
                Some(place) => results[place].get().and_then(Option::as_ref),
                None => kept[source.object].as_ref(),
            };
            report?.outputs.get(source.output)
        };
        let report = match (graph.regions.outermost.get(&object), graph.regions.end_of(object)) {
            (Some(region), _) => {
                let mut report = rounds::solve(turn, graph, region, &tree, &last_round);
                report.time = watch.elapsed();
                report
            }
            (None, Some(_)) => last_round.lock().ok()?.remove(&object)?,
            (None, None) => {
                let mut report = solve_object(turn, graph, object, &tree);
                report.time = watch.elapsed();
                report
            }
        };
        // It may have noticed, and stopped half-way.
        if cancelled() {
            return None;
        }
        tell(turn, object, &report);
        if let Some(progress) = &turn.options.progress {
            let done = done.fetch_add(1, Ordering::Relaxed) + 1;
            progress(&Progress { done, total, name: objects[object].title().to_owned() });
        }
        Some(report)
    });
    let mut solved = 0;
    for (object, result) in todo.iter().zip(results) {
        reports[object] = result.into_inner().flatten();
        solved += usize::from(reports[object].is_some());
    }
    solved
}

/// Solves one object, whose sources have the trees that `tree` gives.
pub(crate) fn solve_object<'a>(
    turn: &Turn<'_>,
    graph: &Graph,
    object: usize,
    tree: &dyn Fn(&Source) -> Option<&'a Tree>,
) -> ObjectReport {
    let wired: Vec<Vec<&Tree>> =
        graph.sources[object].iter().map(|sources| sources.iter().filter_map(tree).collect()).collect();
    let wanted = if turn.options.skip_unread { &graph.wanted[object][..] } else { &[] };
    let turn = Turn { wanted, ..*turn };
    let limits = turn.options.limits;
    let budget = Budget::new(limits, turn.options.cancel.clone(), turn.deadline, turn.account.clone());
    let report = budget.token().during(|| {
        let report = solve(&turn, object, &wired, &budget);
        // What an object gives may be made larger by its outputs' modifiers and casts.
        budget.bytes(0).err().map_or(report, |message| {
            let outputs = turn.document.objects.get(object).map_or(0, |object| object.outputs.len());
            ObjectReport::idle(Status::Error, vec![message], outputs)
        })
    });
    match graph.regions.refused.contains(&object) {
        true => rounds::refused(report),
        false => report,
    }
}

/// Gives a result out as soon as it is there.
fn tell(turn: &Turn<'_>, index: usize, report: &ObjectReport) {
    if let (Some(finished), Some(object)) = (&turn.options.finished, turn.document.objects.get(index)) {
        finished(&Finished { index, object, report });
    }
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
