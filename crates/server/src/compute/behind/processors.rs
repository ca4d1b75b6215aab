//! A processor for what is quick.

use std::sync::Arc;
use std::time::Duration;

use tokio::sync::{Notify, watch};
use tokio::time::{sleep, timeout};

use super::process::Place;

/// After so long without a quick answer the process behind has all processors again.
const STAY: Duration = Duration::from_secs(2);
/// How often it is said again to threads that have come since.
const AGAIN: Duration = Duration::from_millis(250);

/// Keeps the process behind off one processor while one is wanted in front. It ends with the process that it follows.
pub(super) struct Processors {
    wanted: Arc<Notify>,
}

impl Processors {
    /// Follows the process behind, which may be another one from time to time.
    pub(super) fn of(at: watch::Receiver<Option<Place>>) -> Self {
        let wanted = Arc::new(Notify::new());
        tokio::spawn(follow(at, Arc::clone(&wanted)));
        Self { wanted }
    }

    /// One is wanted now.
    pub(super) fn one_is_wanted(&self) {
        self.wanted.notify_one();
    }
}

async fn follow(mut at: watch::Receiver<Option<Place>>, wanted: Arc<Notify>) {
    let process = |at: &watch::Receiver<Option<Place>>| at.borrow().and_then(|place| place.process);
    loop {
        tokio::select! {
            () = wanted.notified() => {}
            ended = at.changed() => match ended {
                Ok(()) => continue,
                Err(_) => return,
            },
        }
        loop {
            if let Some(process) = process(&at) {
                katydid_priority::keep_off_one_processor(process);
            }
            sleep(AGAIN).await;
            if timeout(STAY, wanted.notified()).await.is_err() {
                break;
            }
        }
        if let Some(process) = process(&at) {
            katydid_priority::let_use_all_processors(process);
        }
    }
}
