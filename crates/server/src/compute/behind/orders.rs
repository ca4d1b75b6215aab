//! What the first process tells the one that it starts: a line of JSON on its standard input.

use std::ffi::OsString;
use std::io::BufRead;
use std::net::SocketAddr;
use std::path::PathBuf;

use serde::{Deserialize, Serialize};
use uuid::Uuid;

/// How the process behind is started.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Command {
    /// The program.
    pub program: PathBuf,
    /// Its words. It has to read [`Orders`] from its standard input, to print where it listens as the first line of its
    /// standard output, and to end when its standard input does.
    pub words: Vec<OsString>,
}

/// What the process behind has to know.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Orders {
    /// What the first process shows for a key.
    key: String,
    /// Where the first one listens: what it would be asked is answered at once.
    front: SocketAddr,
}

/// More is no line of ours.
const LONGEST: u64 = 4096;

impl Orders {
    /// With a key that nobody else knows.
    pub(super) fn new(front: SocketAddr) -> Self {
        let random = || Uuid::new_v4().simple().to_string();
        Self { key: random() + &random(), front }
    }

    /// Reads them from the standard input of a process that was started with [`Command`].
    ///
    /// # Errors
    /// There is no such line.
    pub fn read(input: impl BufRead) -> std::io::Result<Self> {
        let mut line = String::new();
        input.take(LONGEST).read_line(&mut line)?;
        serde_json::from_str(&line).map_err(std::io::Error::other)
    }

    /// As they are sent.
    pub(super) fn line(&self) -> String {
        // A text and an address can always be written.
        serde_json::to_string(self).unwrap_or_default() + "\n"
    }

    pub(crate) fn key(&self) -> &str {
        &self.key
    }

    pub(crate) fn front(&self) -> SocketAddr {
        self.front
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test may fail")]

    use super::*;

    #[test]
    fn orders_are_a_line() {
        let orders = Orders::new("127.0.0.1:6500".parse().unwrap());
        let sent = orders.line() + "more";
        assert_eq!(Orders::read(sent.as_bytes()).unwrap(), orders);
        assert_ne!(Orders::new(orders.front()).key(), orders.key());
        for wrong in ["", "\n", "{}\n", "[1\n"] {
            assert!(Orders::read(wrong.as_bytes()).is_err(), "{wrong}");
        }
        assert!(Orders::read(&*vec![b'{'; 1 << 20]).is_err());
    }
}
