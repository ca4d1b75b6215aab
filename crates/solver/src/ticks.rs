//! A definition in time: timers that have objects solved again and again, recorders that remember, dams that hold data
//! back, and loops that are closed from one solution to the next.
//!
//! The time is the definition's own: it goes from one event to the next without waiting for a clock.

use std::time::Duration;

use katydid_data::Tree;
use katydid_definition::document::{Document, Object, Special, ids};

use crate::graph::{Graph, Source};
use crate::{Engine, Summary};

/// Steps of time in a second: the unit of delays in archives, 100 ns.
const SECOND: u64 = 10_000_000;
/// Steps of time in a millisecond: the unit of intervals in archives.
const MILLISECOND: u64 = SECOND / 1000;

/// The course of a definition in time.
///
/// It begins with an ordinary solution. Then each tick is a moment at which a timer fires, or at which a Data Dam lets
/// through what it held back: what hangs on that is solved anew, and nothing else.
///
/// - A **Trigger** fires every so many milliseconds; its targets expire and are solved again. One without an interval is
///   fired by hand in Grasshopper, here as often as the fastest of the others.
/// - A **Data Recorder** adds what comes in with each solution of it to what it has recorded.
/// - A **Value Tracker** keeps the values of each solution of it for its chart, and hands on what comes in.
/// - A **Data Dam** with a delay passes on the newest data so long after data came that it has not passed on.
/// - A **loop of wires** that leads through a dam or a recorder is closed over time: what the object reads is what was
///   there at the end of the tick before, or a dam's delay ago.
#[derive(Debug)]
pub struct Ticks {
    timers: Vec<Timer>,
    late: Vec<Late>,
    now: u64,
}

/// A Trigger that is on.
#[derive(Debug)]
struct Timer {
    period: u64,
    next: u64,
    targets: Vec<usize>,
}

/// An object that reads its wires later than in the same solution.
#[derive(Debug)]
struct Late {
    object: usize,
    sources: Vec<Vec<Source>>,
    /// How long it holds data back; `None` until the next tick.
    delay: Option<u64>,
    /// When it lets through what came.
    due: Option<Due>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Due {
    NextTick,
    At(u64),
}

impl Ticks {
    /// Solves the definition as it stands, and gets ready for the ticks.
    pub fn begin(engine: &mut Engine) -> (Self, Summary) {
        engine.forget();
        engine.given.clear();
        engine.memory = Some(Default::default());
        let document = engine.document().clone();
        let mut ticks = Self { timers: timers(&document), late: Vec::new(), now: 0 };
        // A dam outside of loops passes on what it has, so that the first solution is whole.
        let in_loops = breaking(&document);
        ticks.hold(engine, &in_loops);
        let first = ticks.solve(engine);
        let mut all: Vec<usize> =
            (0..document.objects.len()).filter(|at| delay(&document, *at).is_some()).collect();
        all.extend(in_loops);
        all.sort_unstable();
        all.dedup();
        ticks.hold(engine, &all);
        (ticks, first)
    }

    /// How much time has passed since the first solution.
    pub fn elapsed(&self) -> Duration {
        Duration::from_nanos(self.now.saturating_mul(100))
    }

    /// The timers that are on.
    pub fn timers(&self) -> usize {
        self.timers.len()
    }

    /// Goes on to the next moment at which something happens, and solves what hangs on it; `None` when nothing will
    /// happen ever again.
    pub fn tick(&mut self, engine: &mut Engine) -> Option<Summary> {
        let fires = self.timers.iter().map(|timer| timer.next);
        let releases = self.late.iter().filter_map(|late| match late.due? {
            Due::At(moment) => Some(moment),
            Due::NextTick => None,
        });
        match fires.chain(releases).min() {
            Some(moment) => self.now = self.now.max(moment),
            None if self.late.iter().any(|late| late.due.is_some()) => {}
            None => return None,
        }
        for timer in &mut self.timers {
            if timer.next <= self.now {
                timer.next = self.now.saturating_add(timer.period);
                timer.targets.iter().for_each(|target| engine.expire(*target));
            }
        }
        // All that is let through was there before this tick.
        let due: Vec<(usize, usize, Tree)> = self
            .late
            .iter_mut()
            .filter(|late| match late.due {
                Some(Due::At(moment)) => moment <= self.now,
                Some(Due::NextTick) => true,
                None => false,
            })
            .flat_map(|late| {
                late.due = None;
                let at = late.object;
                late.read(engine).into_iter().enumerate().map(move |(k, tree)| (at, k, tree))
            })
            .collect();
        for (object, input, tree) in due {
            engine.give(object, input, Some(tree));
        }
        Some(self.solve(engine))
    }

    /// Solves what is dirty, and notes for whom data has come.
    fn solve(&mut self, engine: &mut Engine) -> Summary {
        let mut fresh = vec![false; engine.document().objects.len()];
        for at in engine.dirty() {
            if let Some(fresh) = fresh.get_mut(*at) {
                *fresh = true;
            }
        }
        let summary = engine.solve();
        for late in &mut self.late {
            let came = late.sources.iter().flatten().any(|source| fresh.get(source.object) == Some(&true));
            if came && late.due.is_none() {
                late.due =
                    Some(late.delay.map_or(Due::NextTick, |delay| Due::At(self.now.saturating_add(delay))));
            }
        }
        summary
    }

    /// Has these objects read their wires late from now on. Those that have results keep what they read for them.
    fn hold(&mut self, engine: &mut Engine, objects: &[usize]) {
        let graph = Graph::with_late(engine.document(), objects);
        let before = std::mem::take(&mut self.late);
        for (&object, sources) in &graph.late {
            let due = before.iter().find(|late| late.object == object).and_then(|late| late.due);
            let late =
                Late { object, sources: sources.clone(), delay: delay(engine.document(), object), due };
            if engine.report(object).is_some() && !before.iter().any(|late| late.object == object) {
                for (k, tree) in late.read(engine).into_iter().enumerate() {
                    engine.given.insert((object, k), tree);
                }
            }
            self.late.push(late);
        }
        engine.graph = std::sync::Arc::new(graph);
    }
}

impl Late {
    /// What its wires bring as of now.
    fn read(&self, engine: &Engine) -> Vec<Tree> {
        let tree = |source: &Source| engine.report(source.object)?.outputs.get(source.output);
        self.sources.iter().map(|sources| Tree::merge(sources.iter().filter_map(&tree))).collect()
    }
}

/// The timers of a document that are on and have something to do.
fn timers(document: &Document) -> Vec<Timer> {
    let lookup = document.lookup();
    let read = |object: &Object| match object.special() {
        Some(Special::Trigger(trigger)) if !object.locked => {
            let targets: Vec<usize> = trigger.targets.iter().filter_map(|id| lookup.object(*id)).collect();
            let period = u64::try_from(trigger.interval).ok().filter(|interval| *interval > 0);
            (!targets.is_empty()).then(|| (period.map(|ms| ms.saturating_mul(MILLISECOND)), targets))
        }
        _ => None,
    };
    let found: Vec<(Option<u64>, Vec<usize>)> = document.objects.iter().filter_map(read).collect();
    let fastest = found.iter().filter_map(|(period, _)| *period).min().unwrap_or(SECOND);
    let timer = |(period, targets): (Option<u64>, Vec<usize>)| {
        let period = period.unwrap_or(fastest);
        Timer { period, next: period, targets }
    };
    found.into_iter().map(timer).collect()
}

/// How long the object holds data back, when it is a dam that does.
fn delay(document: &Document, at: usize) -> Option<u64> {
    match document.objects.get(at)?.special()? {
        Special::DataDam(dam) => u64::try_from(dam.delay).ok().filter(|delay| *delay > 0),
        _ => None,
    }
}

/// The dams and recorders that have to read late, so that no loop is left that can be closed in time: of each loop all
/// its dams, or else its first recorder.
fn breaking(document: &Document) -> Vec<usize> {
    let mut late: Vec<usize> = Vec::new();
    let is = |at: &usize, component| {
        document.objects.get(*at).is_some_and(|object| object.component == component && !object.locked)
    };
    loop {
        let graph = Graph::with_late(document, &late);
        let before = late.len();
        for members in &graph.loops {
            let dams: Vec<usize> = members.iter().filter(|at| is(at, ids::DATA_DAM)).copied().collect();
            let recorder = members.iter().find(|at| is(at, ids::DATA_RECORDER));
            late.extend(recorder.filter(|_| dams.is_empty()));
            late.extend(dams);
        }
        if late.len() == before {
            return late;
        }
    }
}
