//! The JSON that goes back.

mod messages;
mod tree;

use serde::Serialize;

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
