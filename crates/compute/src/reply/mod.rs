//! The JSON that goes back.

mod messages;
mod tree;

use std::io::{self, Write};

use katydid_geometry::CancellationToken;
use serde::Serialize;

use crate::Fault;
use crate::request::DATA_VERSION;

pub(crate) use messages::Messages;
pub use tree::{OutputItem, OutputTree};

/// What `POST /grasshopper` replies, in the order and with the names that its clients know.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Reply {
    /// Always the default of the protocol, whatever was asked for.
    pub modelunits: &'static str,
    /// Always the default of the protocol, whatever was asked for.
    pub dataversion: i32,
    /// Always empty.
    pub algo: &'static str,
    /// The key by which the definition is known in later requests.
    pub pointer: String,
    /// Whether the reply may be kept.
    pub cachesolve: bool,
    /// The data of every output, in the order of the document.
    pub values: Vec<OutputTree>,
    /// What components warned of.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub warnings: Vec<String>,
    /// What components could not do.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub errors: Vec<String>,
}

impl Default for Reply {
    fn default() -> Self {
        Self {
            modelunits: "Millimeters",
            dataversion: DATA_VERSION,
            algo: "",
            pointer: String::new(),
            cachesolve: false,
            values: Vec::new(),
            warnings: Vec::new(),
            errors: Vec::new(),
        }
    }
}

/// A text that asks for room before it grows.
struct Growing(Vec<u8>);

impl Write for Growing {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let (room, wanted) = (self.0.capacity(), self.0.len().saturating_add(bytes.len()));
        if wanted > room {
            let room = wanted.max(2 * room);
            if !CancellationToken::has_room(room) {
                return Err(io::ErrorKind::OutOfMemory.into());
            }
            self.0.reserve_exact(room - self.0.len());
        }
        self.0.extend_from_slice(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// A value as a text of JSON.
///
/// # Errors
/// `Failed` when it cannot be written, or whoever waits for it gave up ([`CancellationToken`]).
pub fn to_json(value: &impl Serialize) -> Result<Vec<u8>, Fault> {
    let mut text = Growing(Vec::new());
    match serde_json::to_writer(&mut text, value) {
        Ok(()) if CancellationToken::is_over() => Err(Fault::failed("it was given up")),
        Ok(()) => Ok(text.0),
        Err(error) => Err(Fault::failed(error.to_string())),
    }
}
