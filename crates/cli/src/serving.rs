//! Servers, and when they are to end.

/// Runs a server on two threads for its sockets until the command is to end.
pub(crate) fn run(serving: impl Future<Output = Result<u8, String>>) -> Result<u8, String> {
    let runtime = tokio::runtime::Builder::new_multi_thread()
        .enable_all()
        .worker_threads(2)
        .build()
        .map_err(|error| error.to_string())?;
    let ended = runtime.block_on(serving);
    // What still computes then was given up: nobody waits for it.
    runtime.shutdown_background();
    ended
}

/// The signals that end a program: Ctrl+C, and the one by which the system asks for the end.
#[derive(Debug)]
pub(crate) struct Signals {
    #[cfg(unix)]
    interrupt: tokio::signal::unix::Signal,
    #[cfg(unix)]
    terminate: tokio::signal::unix::Signal,
}

impl Signals {
    /// Hears them from now on: none that comes between two calls of [`next`](Self::next) is missed.
    pub(crate) fn listen() -> Result<Self, String> {
        #[cfg(unix)]
        {
            use tokio::signal::unix::{SignalKind, signal};
            let heard = |kind| signal(kind).map_err(|error| format!("signals cannot be heard: {error}"));
            Ok(Self {
                interrupt: heard(SignalKind::interrupt())?,
                terminate: heard(SignalKind::terminate())?,
            })
        }
        #[cfg(not(unix))]
        Ok(Self {})
    }

    /// Waits for one; gives the exit code of a program that it ended.
    pub(crate) async fn next(&mut self) -> u8 {
        #[cfg(unix)]
        {
            tokio::select! {
                _ = self.interrupt.recv() => 130,
                _ = self.terminate.recv() => 143,
            }
        }
        #[cfg(not(unix))]
        {
            let _ = tokio::signal::ctrl_c().await;
            130
        }
    }

    /// Waits for a server to stop; a signal that comes meanwhile ends the waiting at once. Gives the exit code.
    pub(crate) async fn stopping(&mut self, stop: impl Future<Output = ()>) -> u8 {
        tokio::select! {
            () = stop => 0,
            code = self.next() => code,
        }
    }
}
