//! The loop over the data: runs a component's function once for each iteration of the matching, long runs
//! in parallel. The results are the same to the last bit on any number of threads: a run of iterations is cut
//! into pieces, and the pieces are joined in order.

use std::ops::Range;
use std::sync::{Mutex, PoisonError};

use katydid_data::{Path, Tree};

use crate::input::Row;
use crate::matching::Matching;
use crate::output::Sinks;
use crate::pace::Pace;
use crate::{Access, Call, Context, Message, Notes, Outcome};

/// Below this many iterations a run is not worth cutting.
#[cfg(feature = "parallel")]
const SMALLEST_PIECE: usize = 256;

/// The most places that are made ready for results: how many there will be is not known to be allowed.
const MOST_READY: usize = 1 << 16;

/// The most small results that are counted together.
const COUNTED_TOGETHER: usize = 1024;

/// Runs `function` over the data of `call`. It gives `Ok(None)` when a required item is null.
#[doc(hidden)]
pub fn run<S: Sinks>(
    call: &Call<'_>,
    access: &[Access],
    function: impl Fn(&Row<'_>, &Context<'_>) -> Result<Option<S::Results>, Message> + Sync,
) -> Outcome {
    let last = access.last().copied().unwrap_or(Access::Item);
    let access: Vec<Access> =
        (0..call.inputs.len()).map(|k| access.get(k).copied().unwrap_or(last)).collect();
    let principal = call.settings.i32("PrincipalIndex").and_then(|k| usize::try_from(k).ok());
    let matching = Matching::new(call.inputs, &access, principal);
    let total = matching.iterations();
    if let Err(message) = call.budget.check() {
        return failed(call, message);
    }

    let cuts = cut(total);
    let pieces: Vec<Mutex<Option<Piece<S>>>> = cuts.iter().map(|_| Mutex::new(None)).collect();
    for_each_piece(cuts.len(), &|k| {
        if let (Some(range), Some(slot)) = (cuts.get(k), pieces.get(k)) {
            let patience = call.budget.patience();
            let piece = patience.during(|| piece::<S>(call, &matching, range.clone(), &function));
            *slot.lock().unwrap_or_else(PoisonError::into_inner) = Some(piece);
        }
    });
    let mut notes = Notes::default();
    let pieces = pieces.into_iter().filter_map(|p| p.into_inner().unwrap_or_else(PoisonError::into_inner));
    let mut parts = Vec::with_capacity(cuts.len());
    let mut stopped = None;
    for next in pieces {
        notes.append(next.notes);
        stopped = stopped.or(next.stopped);
        parts.push(next.sinks);
    }
    if let Some(message) = stopped {
        notes.add(message);
        return Outcome { outputs: vec![Tree::empty(); call.output_count], messages: notes.into_messages() };
    }
    // One piece is taken as it is; for several there is room for all of them.
    let room = if cuts.len() > 1 { total } else { 0 };
    let mut sinks = S::new(room, call.output_count);
    parts.into_iter().for_each(|part| sinks.append(part));
    // Every output has the paths for itself.
    let shape = size_of::<Path>() + size_of::<usize>();
    let shapes = matching.paths.len().saturating_mul(call.output_count).saturating_mul(shape);
    if let Err(message) = call.budget.bytes(sinks.copied().saturating_add(shapes)) {
        notes.add(message);
        return Outcome { outputs: vec![Tree::empty(); call.output_count], messages: notes.into_messages() };
    }
    Outcome { outputs: sinks.finish(&matching), messages: notes.into_messages() }
}

fn failed(call: &Call<'_>, message: Message) -> Outcome {
    Outcome { outputs: vec![Tree::empty(); call.output_count], messages: vec![message] }
}

/// What a run of iterations gave.
struct Piece<S> {
    sinks: S,
    notes: Notes,
    /// Why it did not go to its end: a limit, or a cancel.
    stopped: Option<Message>,
}

fn piece<S: Sinks>(
    call: &Call<'_>,
    matching: &Matching,
    range: Range<usize>,
    function: &(impl Fn(&Row<'_>, &Context<'_>) -> Result<Option<S::Results>, Message> + Sync),
) -> Piece<S> {
    let context = Context::new(call);
    let mut sinks = S::new(range.len().min(MOST_READY), call.output_count);
    let mut set = matching.set_of(range.start);
    let mut at = range.start;
    let mut stopped = None;
    let mut pace = Pace::default();
    // Small results are counted together, so that threads do not queue for the counter.
    let mut untaken = 0;
    'sets: while at < range.end {
        let iterations = matching.set_range(set);
        if let Some(path) = matching.paths.get(set) {
            context.enter_branch(path);
        }
        let ranges = matching.ranges(set);
        for i in at..iterations.end.min(range.end) {
            let budget = call.budget;
            if let Err(message) = if pace.is_due() { budget.check() } else { budget.check_memory() } {
                stopped = Some(message);
                break 'sets;
            }
            let row = Row { inputs: call.inputs, ranges, i: i - iterations.start };
            context.enter_iteration(row.i);
            let results = match function(&row, &context) {
                Ok(results) => results,
                Err(message) => {
                    // What was given up has no fault of its own.
                    if let Err(message) = call.budget.check() {
                        stopped = Some(message);
                        break 'sets;
                    }
                    context.tell(message);
                    None
                }
            };
            untaken += results.as_ref().map_or(0, S::count);
            if untaken >= COUNTED_TOGETHER {
                if let Err(message) = call.budget.items(untaken) {
                    stopped = Some(message);
                    break 'sets;
                }
                untaken = 0;
            }
            sinks.push(results);
        }
        at = iterations.end.max(at);
        set += 1;
    }
    // What was given up on the way is no result.
    let stopped = stopped.or_else(|| call.budget.items(untaken).and_then(|()| call.budget.check()).err());
    Piece { sinks, notes: context.into_notes(), stopped }
}

/// Where a run of iterations is cut.
fn cut(total: usize) -> Vec<Range<usize>> {
    #[cfg(feature = "parallel")]
    if total >= 2 * SMALLEST_PIECE && rayon::current_num_threads() > 1 {
        let size = total.div_ceil(rayon::current_num_threads() * 8).max(SMALLEST_PIECE);
        return (0..total).step_by(size).map(|start| start..(start + size).min(total)).collect();
    }
    std::iter::once(0..total).collect()
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
