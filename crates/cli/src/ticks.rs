//! Solving a definition once, or in time.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use katydid_component::Cancel;
use katydid_session::Session;

use crate::args::DefinitionArgs;
use crate::output::{YELLOW, note};
use crate::progress;
use crate::serving::Signals;

/// Solves the definition, with as many ticks as are asked for; tells whether it came to their end.
pub(crate) fn solve(session: &mut Session, args: &DefinitionArgs) -> bool {
    let Some(wanted) = args.ticks else {
        session.solve();
        progress::clear();
        return true;
    };
    let limit = session.options_mut().limits.time;
    let start = Instant::now();
    let interrupted = interrupted();
    let mut ticks = session.begin_ticks();
    let mut done = 0;
    let ended_early = loop {
        if done == wanted {
            break None;
        }
        if interrupted.load(Ordering::Relaxed) {
            break Some("interrupted".to_owned());
        }
        if let Some(limit) = limit {
            let left = limit.saturating_sub(start.elapsed());
            if left.is_zero() {
                break Some(format!("the time limit of {} seconds is over", limit.as_secs_f64()));
            }
            session.options_mut().limits.time = Some(left);
        }
        if !session.tick(&mut ticks) {
            progress::clear();
            note(&format!("{YELLOW}nothing happens any more{YELLOW:#}: {}", why(ticks.timers(), done)));
            break None;
        }
        done += 1;
    };
    progress::clear();
    note(&format!("{done} of {wanted} ticks, {} in the definition's time", words(ticks.elapsed())));
    if let Some(reason) = &ended_early {
        note(&format!("{YELLOW}ended early{YELLOW:#}: {reason}"));
    }
    ended_early.is_none()
}

fn why(timers: usize, done: u64) -> &'static str {
    match (timers, done) {
        (0, 0) => {
            "no Trigger is on that has a target, and no wire leads back through a Data Dam or Data Recorder"
        }
        _ => "no dam holds anything back, and no Trigger is on",
    }
}

fn words(time: Duration) -> String {
    format!("{} s", time.as_secs_f64())
}

/// A flag that Ctrl+C raises; a second one ends the program.
fn interrupted() -> Arc<AtomicBool> {
    let flag = Arc::new(AtomicBool::new(false));
    let raised = Arc::clone(&flag);
    when_interrupted(move || {
        raised.store(true, Ordering::Relaxed);
        note("ends after this tick; Ctrl+C once more ends at once");
    });
    flag
}

/// Has Ctrl+C cancel what heeds the flag; a second one ends the program.
pub(crate) fn on_interrupt(cancel: Cancel) {
    when_interrupted(move || cancel.cancel());
}

fn when_interrupted(first: impl FnOnce() + Send + 'static) {
    std::thread::spawn(move || {
        let Ok(runtime) = tokio::runtime::Builder::new_current_thread().enable_all().build() else { return };
        runtime.block_on(async {
            // Without signals the program ends at the first one, as programs do.
            let Ok(mut signals) = Signals::listen() else { return };
            signals.next().await;
            first();
            std::process::exit(signals.next().await.into());
        });
    });
}
