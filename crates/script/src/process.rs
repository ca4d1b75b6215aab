//! The process that runs scripts: started, spoken with, interrupted, ended.

use std::io::{BufReader, BufWriter, Read};
use std::process::{Child, Command, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, SyncSender, TrySendError, sync_channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use katydid_members::codec;
use tempfile::TempDir;

use crate::fence::Fence;
use crate::interpreter::Interpreter;
use crate::sources;

/// What the process may use.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Bounds {
    /// The most bytes of memory that it may address.
    pub memory: u64,
    /// The most seconds of processor time in its life.
    pub processor_seconds: u64,
    /// The most files that it may have open.
    pub files: u64,
    /// The most bytes of a file that it may write.
    pub file_size: u64,
    /// Whether it may use the network.
    pub network: bool,
    /// Folders whose files it may read besides Python's own.
    pub readable: Vec<std::path::PathBuf>,
}

impl Default for Bounds {
    /// 4 GiB of memory, an hour of processor time, 256 files of at most 1 GiB, no network, and no folders.
    fn default() -> Self {
        Self {
            memory: 4 << 30,
            processor_seconds: 3600,
            files: 256,
            file_size: 1 << 30,
            network: false,
            readable: Vec::new(),
        }
    }
}

/// How much of what the process writes to its standard error is kept, for when it dies.
const LAST_WORDS: usize = 4096;

/// A running process.
#[derive(Debug)]
pub(crate) struct Process {
    child: Child,
    answers: Receiver<Result<Vec<u8>, codec::Error>>,
    requests: SyncSender<Vec<u8>>,
    last_words: Arc<Mutex<Vec<u8>>>,
    /// Its own files; they go when it does.
    _folder: TempDir,
}

/// What came, or did not come, from the process.
#[derive(Debug)]
pub(crate) enum Heard {
    /// A message.
    Message(Vec<u8>),
    /// Nothing in this time.
    Nothing,
    /// It has ended, or speaks no sense.
    Ended(String),
}

impl Process {
    /// Starts one.
    ///
    /// # Errors
    /// Why not, in words.
    pub(crate) fn start(interpreter: &Interpreter, bounds: &Bounds) -> Result<Self, String> {
        if !sources::are_there() {
            return Err("This program was built without the modules that run Python scripts".to_owned());
        }
        let failed = |error: &std::io::Error| {
            format!("Python at {} could not be started: {error}", interpreter.0.display())
        };
        let folder = tempfile::Builder::new().prefix("katydid-").tempdir().map_err(|error| failed(&error))?;
        sources::write(folder.path()).map_err(|error| failed(&error))?;
        let mut child = command(interpreter, bounds, &folder).spawn().map_err(|error| failed(&error))?;
        let (Some(input), Some(output), Some(errors)) =
            (child.stdin.take(), child.stdout.take(), child.stderr.take())
        else {
            return Err("Python has no pipes".to_owned());
        };
        let (requests, to_send) = sync_channel::<Vec<u8>>(1);
        // Writing and reading have threads of their own, so that a process that does neither holds nobody up.
        thread::spawn(move || {
            let mut pipe = BufWriter::new(input);
            while let Ok(message) = to_send.recv() {
                if codec::send(&mut pipe, &message).is_err() {
                    break;
                }
            }
        });
        let (heard, answers) = sync_channel(1);
        thread::spawn(move || {
            let mut pipe = BufReader::new(output);
            while let Some(message) = codec::receive(&mut pipe).transpose() {
                let is_over = message.is_err();
                if heard.send(message).is_err() || is_over {
                    break;
                }
            }
        });
        let last_words = Arc::new(Mutex::new(Vec::new()));
        let kept = last_words.clone();
        thread::spawn(move || keep_last(errors, &kept));
        Ok(Self { child, answers, requests, last_words, _folder: folder })
    }

    /// Sends a message, for as long as `go_on` says; tells whether it was sent.
    pub(crate) fn send(&self, mut message: Vec<u8>, mut go_on: impl FnMut() -> bool) -> bool {
        loop {
            match self.requests.try_send(message) {
                Ok(()) => return true,
                Err(TrySendError::Disconnected(_)) => return false,
                Err(TrySendError::Full(unsent)) => {
                    if !go_on() {
                        return false;
                    }
                    message = unsent;
                    thread::sleep(Duration::from_millis(2));
                }
            }
        }
    }

    /// Waits for a message.
    pub(crate) fn hear(&mut self, time: Duration) -> Heard {
        match self.answers.recv_timeout(time) {
            Ok(Ok(message)) => Heard::Message(message),
            Ok(Err(error)) => Heard::Ended(self.end(&format!("its messages make no sense: {error}"))),
            Err(RecvTimeoutError::Timeout) => Heard::Nothing,
            Err(RecvTimeoutError::Disconnected) => Heard::Ended(self.end("it ended")),
        }
    }

    /// Whether it has ended while nobody listened.
    pub(crate) fn has_ended(&mut self) -> bool {
        !matches!(self.child.try_wait(), Ok(None))
    }

    /// Interrupts the script: in it a `KeyboardInterrupt`.
    pub(crate) fn interrupt(&self) {
        self.signal(false);
    }

    /// Ends the process and what it started, and says how it ended.
    fn end(&mut self, why: &str) -> String {
        let until = Instant::now() + Duration::from_millis(200);
        let status = loop {
            match self.child.try_wait() {
                Ok(Some(status)) => break Some(status),
                Ok(None) if Instant::now() < until => thread::sleep(Duration::from_millis(5)),
                _ => break None,
            }
        };
        self.kill();
        let words = String::from_utf8_lossy(&self.last_words.lock().unwrap_or_else(PoisonError::into_inner))
            .into_owned();
        let how = status.map_or_else(|| why.to_owned(), |status| format!("{why}: {status}"));
        match words.trim().lines().last() {
            Some(line) => format!("{how}; its last words: {line}"),
            None => how,
        }
    }

    /// Ends the process and what it started.
    pub(crate) fn kill(&mut self) {
        self.signal(true);
        let _ = self.child.kill();
        let _ = self.child.wait();
    }

    #[cfg(unix)]
    fn signal(&self, kill: bool) {
        use rustix::process::{Pid, Signal, kill_process_group};
        let pid = i32::try_from(self.child.id()).ok().and_then(Pid::from_raw);
        if let Some(pid) = pid {
            // Fails when all of the group has ended.
            let _ = kill_process_group(pid, if kill { Signal::KILL } else { Signal::INT });
        }
    }

    #[cfg(not(unix))]
    fn signal(&self, _: bool) {}
}

impl Drop for Process {
    fn drop(&mut self) {
        self.kill();
    }
}

fn keep_last(mut errors: impl Read, kept: &Mutex<Vec<u8>>) {
    let mut chunk = [0; 1024];
    while let Ok(count @ 1..) = errors.read(&mut chunk) {
        let mut kept = kept.lock().unwrap_or_else(PoisonError::into_inner);
        kept.extend(chunk.get(..count).unwrap_or_default());
        let surplus = kept.len().saturating_sub(LAST_WORDS);
        kept.drain(..surplus);
    }
}

fn command(interpreter: &Interpreter, bounds: &Bounds, folder: &TempDir) -> Command {
    let mut words = Fence::of_machine().words(bounds.network);
    words.push(interpreter.0.clone().into_os_string());
    words.extend(["-I", "-B", "-u"].map(Into::into));
    words.push(folder.path().join("guard.py").into_os_string());
    let mut words = words.into_iter();
    let mut command = Command::new(words.next().unwrap_or_default());
    command.args(words).current_dir(folder.path()).env_clear();
    command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    // What programs before Python are found by; Python's own place follows from its path.
    if let Some(path) = std::env::var_os("PATH") {
        command.env("PATH", path);
    }
    let work = folder.path().join("work");
    command.env("HOME", &work).env("TMPDIR", &work).env("LANG", "C.UTF-8");
    let limits = [
        ("KATYDID_MEMORY", bounds.memory),
        ("KATYDID_SECONDS", bounds.processor_seconds),
        ("KATYDID_FILES", bounds.files),
        ("KATYDID_FILE_SIZE", bounds.file_size),
        ("KATYDID_CORE", 0),
        ("KATYDID_NETWORK", u64::from(bounds.network)),
    ];
    for (name, value) in limits {
        command.env(name, value.to_string());
    }
    if let Ok(readable) = std::env::join_paths(&bounds.readable) {
        command.env("KATYDID_READ", readable);
    }
    #[cfg(unix)]
    std::os::unix::process::CommandExt::process_group(&mut command, 0);
    command
}
