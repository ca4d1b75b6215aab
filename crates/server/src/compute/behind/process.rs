//! The process behind, for as long as the server runs: when it ends, another is started.

use std::net::SocketAddr;
use std::process::Stdio;
use std::time::{Duration, Instant};

use tokio::io::{AsyncBufReadExt, AsyncWriteExt, BufReader};
use tokio::process::{Child, ChildStdin, ChildStdout};
use tokio::sync::watch;
use tokio::time::{sleep, timeout};

use super::orders::{Command, Orders};

/// It listens after so long.
const BEGIN: Duration = Duration::from_secs(20);
/// One that ends sooner than this is not started again at once.
const SHORT: Duration = Duration::from_secs(10);
/// How long after that, at first and at most.
const PAUSE: [Duration; 2] = [Duration::from_millis(50), Duration::from_secs(2)];
/// It has so long to end when it is told so.
const END: Duration = Duration::from_secs(2);

/// A process that listens. It ends when this is dropped.
pub(super) struct Process {
    child: Child,
    /// Closed, it tells the process to end.
    input: ChildStdin,
    /// Kept open: what is written there must not fail.
    _output: BufReader<ChildStdout>,
    address: SocketAddr,
}

impl Process {
    /// Starts one and waits until it listens.
    pub(super) async fn start(command: &Command, orders: &Orders) -> std::io::Result<Self> {
        let missing = || std::io::Error::other("the second process has no pipes");
        let mut start = tokio::process::Command::new(&command.program);
        #[cfg(unix)]
        if let Some(name) = std::env::args_os().next() {
            // Lists of processes show them by one name.
            start.arg0(name);
        }
        let mut child = start
            .args(&command.words)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .kill_on_drop(true)
            .spawn()?;
        let mut input = child.stdin.take().ok_or_else(missing)?;
        let mut output = BufReader::new(child.stdout.take().ok_or_else(missing)?);
        let mut line = String::new();
        let begin = async {
            input.write_all(orders.line().as_bytes()).await?;
            output.read_line(&mut line).await
        };
        let late = |_| std::io::Error::other("the second process does not listen in time");
        timeout(BEGIN, begin).await.map_err(late)??;
        let address = address(&line)
            .ok_or_else(|| std::io::Error::other("the second process does not say where it listens"))?;
        Ok(Self { child, input, _output: output, address })
    }

    pub(super) fn place(&self) -> Place {
        Place { address: self.address, process: self.child.id() }
    }
}

/// Where a process is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Place {
    /// It listens there.
    pub(super) address: SocketAddr,
    /// Its number, as long as it is known to run.
    pub(super) process: Option<u32>,
}

/// The address in what it says: `http://127.0.0.1:40123/`.
fn address(line: &str) -> Option<SocketAddr> {
    line.trim().strip_prefix("http://")?.trim_end_matches('/').parse().ok()
}

/// Follows a process, and starts another when it has ended, until `stop`.
pub(super) async fn keep(
    mut process: Process,
    command: Command,
    orders: Orders,
    at: watch::Sender<Option<Place>>,
    mut stop: watch::Receiver<bool>,
) {
    let mut pause = PAUSE[0];
    loop {
        let since = Instant::now();
        tokio::select! {
            ended = process.child.wait() => {
                at.send_replace(None);
                let how = ended.map_or_else(|error| error.to_string(), |status| status.to_string());
                tracing::warn!(target: "katydid::processes", how, "the second process ended: another is started");
            }
            _ = stop.changed() => {
                at.send_replace(None);
                drop(process.input);
                let _ = timeout(END, process.child.wait()).await;
                return;
            }
        }
        let mut is_short = since.elapsed() < SHORT;
        pause = if is_short { pause } else { PAUSE[0] };
        process = loop {
            // What ends again and again is not started all the time.
            if is_short {
                tokio::select! {
                    () = sleep(pause) => pause = (pause * 2).min(PAUSE[1]),
                    _ = stop.changed() => return,
                }
            }
            match Process::start(&command, &orders).await {
                Ok(process) => break process,
                Err(error) => tracing::error!(target: "katydid::processes", %error, "no second process"),
            }
            is_short = true;
        };
        at.send_replace(Some(process.place()));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn where_it_listens() {
        let told = |line| address(line).map(|address| address.to_string());
        assert_eq!(told("http://127.0.0.1:40123/\n").as_deref(), Some("127.0.0.1:40123"));
        for other in ["", "ready", "http://localhost:1/", "https://127.0.0.1:1/"] {
            assert_eq!(told(other), None, "{other}");
        }
    }
}
