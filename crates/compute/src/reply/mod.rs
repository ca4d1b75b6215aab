//! The JSON that goes back.

use serde::Serialize;

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
            dataversion: 7,
            algo: "",
            pointer: String::new(),
            cachesolve: false,
            warnings: Vec::new(),
            errors: Vec::new(),
        }
    }
}
