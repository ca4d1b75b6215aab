//! What keeps a script's process apart from the machine.

use std::ffi::OsString;
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::OnceLock;

/// How far a script's process is kept apart. Python's own audit events guard files, programs and sockets in any case; the
/// namespaces of Linux hold also what goes past Python.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Fence {
    /// Namespaces of its own for users, processes and the network: no network, and nothing of it outlives it.
    Namespaces,
    /// Python's audit events, limits and a process group alone: this system gives no namespaces to its users.
    AuditAlone,
}

impl Fence {
    /// What this machine offers; asked once.
    pub fn of_machine() -> Self {
        static FOUND: OnceLock<Fence> = OnceLock::new();
        *FOUND.get_or_init(|| if works(&unshare(false)) { Self::Namespaces } else { Self::AuditAlone })
    }

    /// The words that go before the interpreter.
    pub(crate) fn words(self, network: bool) -> Vec<OsString> {
        let mut words = Vec::new();
        if dies_with_us() {
            words.extend(["setpriv", "--pdeathsig", "KILL"].map(OsString::from));
        }
        if self == Self::Namespaces {
            words.extend(unshare(network));
        }
        words
    }
}

/// The program that makes namespaces: of users and processes, and unless the network is allowed, of the network. What
/// runs inside is ended with it.
fn unshare(network: bool) -> Vec<OsString> {
    let mut words = vec!["unshare", "--user", "--map-root-user", "--pid", "--fork", "--kill-child"];
    if !network {
        words.push("--net");
    }
    words.into_iter().map(OsString::from).collect()
}

/// Whether a process can be told to end with the one that started it.
fn dies_with_us() -> bool {
    static FOUND: OnceLock<bool> = OnceLock::new();
    *FOUND.get_or_init(|| works(&["setpriv", "--pdeathsig", "KILL"].map(OsString::from)))
}

/// Whether a command line can be put before another one.
fn works(words: &[OsString]) -> bool {
    let [program, arguments @ ..] = words else { return false };
    if !cfg!(target_os = "linux") || !Path::new("/bin/true").exists() {
        return false;
    }
    let mut command = Command::new(program);
    command.args(arguments).arg("/bin/true").stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    command.status().is_ok_and(|status| status.success())
}
