//! The loop over the data: runs a component's function once for each iteration of the matching, long runs
//! in parallel. The results are the same to the last bit on any number of threads: a run of iterations is cut
//! into pieces, and the pieces are joined in order.

use std::any::Any;
use std::ops::Range;
use std::sync::{Mutex, PoisonError};
#[cfg(feature = "parallel")]
use std::time::Duration;

use katydid_data::Tree;
#[cfg(feature = "parallel")]
use web_time::Instant;

use crate::input::Row;
use crate::matching::{Matching, Ranges};
use crate::output::Sinks;
use crate::pace::Pace;
use crate::{Access, Budget, Call, Context, Message, Notes, Outcome};

/// What takes less on one thread is not worth handing to another.
#[cfg(feature = "parallel")]
const WORTH_A_THREAD: Duration = Duration::from_micros(50);

/// So long the first iterations run on one thread, until it is known what one takes.
#[cfg(feature = "parallel")]
const TRIAL: Duration = Duration::from_micros(100);

/// A first iteration that takes so long is taken for what the others will take.
#[cfg(feature = "parallel")]
const LONG: Duration = Duration::from_millis(2);

/// Pieces for each thread: what is costly is seldom spread evenly.
#[cfg(feature = "parallel")]
const PIECES: usize = 8;

/// So many places are made ready for results without asking whether they fit.
const SURELY_READY: usize = 1 << 16;

/// The most small results that are counted together.
const COUNTED_TOGETHER: usize = 1024;

/// Runs `function` over the data of `call`. It gives `Ok(None)` when a required item is null.
///
/// Only what depends on the types of the results is compiled for each component; the loop is [`iterate`].
#[doc(hidden)]
pub fn run<S: Sinks>(
    call: &Call<'_>,
    access: &[Access],
    function: impl Fn(&Row<'_>, &Context<'_>) -> Result<Option<S::Results>, Message> + Sync,
) -> Outcome {
    let sizes = Sizes { item: S::ITEM_BYTES, results: size_of::<S::Results>() };
    iterate(call, access, &Worker::<S, _>::maker(&function, call.output_count), sizes)
}

/// The bytes that results take.
#[derive(Clone, Copy)]
struct Sizes {
    /// The most of an item of one of the outputs.
    item: usize,
    /// Of what one iteration gives.
    results: usize,
}

/// A component's function with what its iterations gave so far.
trait Work: Send {
    /// Runs the next iteration and keeps its results.
    ///
    /// # Errors
    /// Why the loop ends here: a limit, or a cancel.
    fn step(&mut self, row: &Row<'_>, context: &Context<'_>, room: &mut Room<'_>) -> Result<(), Message>;
    /// The results of the iterations behind these, by the same function.
    fn append(&mut self, other: Box<dyn Work + '_>);
    /// What was kept: the same type for each work of a component.
    fn into_sinks(self: Box<Self>) -> Box<dyn Any>;
    /// The bytes that the trees take besides what is here.
    fn finishing(&self, matching: &Matching<'_>) -> usize;
    /// The trees of all outputs.
    fn finish(self: Box<Self>, matching: &Matching<'_>) -> Vec<Tree>;
}

struct Worker<'f, S, F> {
    sinks: S,
    function: &'f F,
}

impl<'f, S, F> Worker<'f, S, F>
where
    S: Sinks,
    F: Fn(&Row<'_>, &Context<'_>) -> Result<Option<S::Results>, Message> + Sync,
{
    /// Makes workers with room for a number of results.
    fn maker(function: &'f F, ports: usize) -> impl Fn(usize) -> Box<dyn Work + 'f> + Sync {
        move |count| Box::new(Self { sinks: S::new(count, ports), function })
    }
}

impl<S, F> Work for Worker<'_, S, F>
where
    S: Sinks,
    F: Fn(&Row<'_>, &Context<'_>) -> Result<Option<S::Results>, Message> + Sync,
{
    fn step(&mut self, row: &Row<'_>, context: &Context<'_>, room: &mut Room<'_>) -> Result<(), Message> {
        let results = match (self.function)(row, context) {
            Ok(results) => results,
            Err(message) => {
                room.failed(context, message)?;
                None
            }
        };
        if let Some(results) = &results {
            room.take(S::count(results), || S::bytes(results))?;
        }
        self.sinks.push(results);
        Ok(())
    }

    fn append(&mut self, other: Box<dyn Work + '_>) {
        if let Ok(other) = other.into_sinks().downcast() {
            self.sinks.append(*other);
        }
    }

    fn into_sinks(self: Box<Self>) -> Box<dyn Any> {
        Box::new(self.sinks)
    }

    fn finishing(&self, matching: &Matching<'_>) -> usize {
        self.sinks.finishing(matching)
    }

    fn finish(self: Box<Self>, matching: &Matching<'_>) -> Vec<Tree> {
        self.sinks.finish(matching)
    }
}

/// Asks the budget for the results of a piece. Small results are counted together, so that threads do not queue for the
/// counter.
struct Room<'a> {
    budget: &'a Budget,
    /// Results that the budget does not know of yet.
    untaken: usize,
    is_first: bool,
}

impl Room<'_> {
    /// Asks for `count` more items, which take so many bytes.
    #[inline]
    fn take(&mut self, count: usize, bytes: impl FnOnce() -> usize) -> Result<(), Message> {
        self.untaken += count;
        if self.untaken < COUNTED_TOGETHER {
            return Ok(());
        }
        // Long lists are copied behind those of the iterations before.
        let bytes = if self.is_first { 0 } else { bytes() };
        self.budget.items(self.untaken)?;
        self.untaken = 0;
        self.budget.asked(bytes)
    }

    /// An iteration failed: the user is told, unless it was given up.
    #[cold]
    fn failed(&self, context: &Context<'_>, message: Message) -> Result<(), Message> {
        // What was given up has no fault of its own.
        self.budget.check()?;
        context.tell(message);
        Ok(())
    }
}

/// Makes a work with room for so many results.
type Maker<'m, 'f> = &'m (dyn Fn(usize) -> Box<dyn Work + 'f> + Sync);

fn iterate(call: &Call<'_>, access: &[Access], maker: Maker<'_, '_>, sizes: Sizes) -> Outcome {
    let last = access.last().copied().unwrap_or(Access::Item);
    let access: Vec<Access> =
        (0..call.inputs.len()).map(|k| access.get(k).copied().unwrap_or(last)).collect();
    let principal = call.settings.i32("PrincipalIndex").and_then(|k| usize::try_from(k).ok());
    if let Err(message) = call.budget.bytes(Matching::bytes(call.inputs)).and_then(|()| call.budget.check()) {
        return failed(call, vec![message]);
    }
    let matching = Matching::new(call.inputs, &access, principal);
    let total = matching.iterations();

    let run = |range: Range<usize>, trial: Trial| {
        call.budget.token().during(|| piece(call, &matching, range, maker, sizes, trial))
    };
    let first = run(0..total, Trial::default());
    let cuts = if first.stopped.is_some() { Vec::new() } else { cut(&first, total) };
    let pieces: Vec<Mutex<Option<Piece<'_>>>> = cuts.iter().map(|_| Mutex::new(None)).collect();
    for_each_piece(cuts.len(), &|k| {
        if let (Some(range), Some(slot)) = (cuts.get(k), pieces.get(k)) {
            let piece = run(range.clone(), Trial::none());
            *slot.lock().unwrap_or_else(PoisonError::into_inner) = Some(piece);
        }
    });
    let mut notes = Notes::default();
    let pieces = pieces.into_iter().filter_map(|p| p.into_inner().unwrap_or_else(PoisonError::into_inner));
    let mut parts = Vec::with_capacity(cuts.len() + 1);
    let mut stopped = None;
    for next in std::iter::once(first).chain(pieces) {
        notes.append(next.notes);
        stopped = stopped.or(next.stopped);
        parts.push(next.work);
    }
    if let Some(message) = stopped {
        notes.add(message);
        return failed(call, notes.into_messages());
    }
    // One piece is taken as it is; for several there is room for all of them.
    let work = if parts.len() == 1 { parts.pop() } else { None };
    let mut work = work.unwrap_or_else(|| maker(total));
    parts.into_iter().for_each(|part| work.append(part));
    if let Err(message) = call.budget.bytes(work.finishing(&matching)) {
        notes.add(message);
        return failed(call, notes.into_messages());
    }
    Outcome { outputs: work.finish(&matching), messages: notes.into_messages() }
}

fn failed(call: &Call<'_>, messages: Vec<Message>) -> Outcome {
    Outcome { outputs: vec![Tree::empty(); call.output_count], messages }
}

/// What a run of iterations gave.
struct Piece<'f> {
    work: Box<dyn Work + 'f>,
    notes: Notes,
    /// Why it did not go to its end: a limit, or a cancel.
    stopped: Option<Message>,
    /// The iteration behind its last one.
    end: usize,
    trial: Trial,
}

/// Finds out what an iteration takes, where others could run on other threads meanwhile.
#[derive(Debug)]
struct Trial {
    #[cfg(feature = "parallel")]
    since: Option<Instant>,
    /// The iterations that count, and what they took.
    #[cfg(feature = "parallel")]
    took: (usize, Duration),
}

#[cfg(feature = "parallel")]
impl Trial {
    fn new(is_on: bool) -> Self {
        Self { since: is_on.then(Instant::now), took: (0, Duration::ZERO) }
    }

    /// A run that goes to its end.
    fn none() -> Self {
        Self::new(false)
    }

    /// Whether it may end before the run does.
    fn is_on(&self) -> bool {
        self.since.is_some()
    }

    /// Whether enough is known, asked before each iteration with the number of those done. The first one counts only
    /// where it is long: it also prepares what the others use.
    #[inline]
    fn is_over(&mut self, done: usize) -> bool {
        match self.since {
            Some(since) if done > 0 => self.has_seen(done, since.elapsed()),
            _ => false,
        }
    }

    fn has_seen(&mut self, done: usize, took: Duration) -> bool {
        if done == 1 && took < LONG {
            self.since = Some(Instant::now());
            return false;
        }
        self.took = (done.max(2) - 1, took);
        took >= TRIAL
    }
}

#[cfg(feature = "parallel")]
impl Default for Trial {
    fn default() -> Self {
        Self::new(rayon::current_num_threads() > 1)
    }
}

#[cfg(not(feature = "parallel"))]
impl Default for Trial {
    fn default() -> Self {
        Self::none()
    }
}

#[cfg(not(feature = "parallel"))]
impl Trial {
    fn none() -> Self {
        Self {}
    }

    fn is_on(&self) -> bool {
        false
    }

    fn is_over(&mut self, _: usize) -> bool {
        false
    }
}

fn piece<'f>(
    call: &Call<'_>,
    matching: &Matching<'_>,
    range: Range<usize>,
    maker: Maker<'_, 'f>,
    sizes: Sizes,
    mut trial: Trial,
) -> Piece<'f> {
    let context = Context::new(call, sizes.item);
    let count =
        if trial.is_on() { range.len().min(SURELY_READY) } else { ready(call, range.len(), sizes.results) };
    let mut work = maker(count);
    let mut room = Room { budget: call.budget, untaken: 0, is_first: true };
    let mut set = matching.set_of(range.start);
    let mut at = range.start;
    let mut stopped = None;
    let mut end = range.end;
    let mut pace = Pace::default();
    let mut ranges = Ranges::new();
    'sets: while at < range.end {
        let iterations = matching.set_range(set);
        if let Some(path) = matching.paths.get(set) {
            context.enter_branch(path);
        }
        matching.ranges(set, &mut ranges);
        for i in at..iterations.end.min(range.end) {
            if trial.is_over(i - range.start) {
                end = i;
                break 'sets;
            }
            let budget = call.budget;
            let goes_on = if pace.is_due() { budget.check() } else { budget.check_memory() };
            let row = Row { inputs: call.inputs, ranges: &ranges, i: i - iterations.start };
            context.enter_iteration(row.i);
            if let Err(message) = goes_on.and_then(|()| work.step(&row, &context, &mut room)) {
                stopped = Some(message);
                break 'sets;
            }
            room.is_first = false;
        }
        at = iterations.end.max(at);
        set += 1;
    }
    // What was given up on the way is no result.
    let stopped =
        stopped.or_else(|| call.budget.items(room.untaken).and_then(|()| call.budget.check()).err());
    Piece { work, notes: context.into_notes(), stopped, end, trial }
}

/// For how many results of so many, each of so many bytes, room is made at once: for all of them where they fit, as a
/// table that grows is copied again and again.
fn ready(call: &Call<'_>, count: usize, bytes: usize) -> usize {
    let fits = || call.budget.fits(count).is_ok() && call.budget.has_room(count.saturating_mul(bytes));
    if count <= SURELY_READY || fits() { count } else { SURELY_READY }
}

/// Where the iterations behind a trial are cut.
fn cut(first: &Piece<'_>, total: usize) -> Vec<Range<usize>> {
    let rest = first.end..total;
    if rest.is_empty() {
        return Vec::new();
    }
    let size = size(&first.trial, rest.len());
    rest.step_by(size).map(|start| start..(start + size).min(total)).collect()
}

/// How many iterations of so many are worth a piece.
#[cfg(feature = "parallel")]
fn size(trial: &Trial, rest: usize) -> usize {
    let (count, took) = trial.took;
    let worth = count as f64 * WORTH_A_THREAD.as_secs_f64() / took.as_secs_f64().max(1e-9);
    rest.div_ceil(rayon::current_num_threads() * PIECES).max(worth.ceil() as usize).max(1)
}

#[cfg(not(feature = "parallel"))]
fn size(_: &Trial, rest: usize) -> usize {
    rest
}

/// Calls `task` for 0 to `count`, on any thread. Not generic, so that the pool's code is compiled once and not for
/// each component.
fn for_each_piece(count: usize, task: &(dyn Fn(usize) + Sync)) {
    #[cfg(feature = "parallel")]
    if count > 1 {
        use rayon::prelude::*;
        (0..count).into_par_iter().for_each(task);
        return;
    }
    (0..count).for_each(task);
}
