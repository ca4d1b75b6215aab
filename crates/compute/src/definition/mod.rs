//! A definition with what it asks for and what it gives.

use katydid_definition::document::Document;
use serde::Serialize;

/// A definition that requests are solved on.
#[derive(Debug)]
pub struct Definition {
    key: String,
    document: Document,
}

impl Definition {
    /// The key by which it is known in later requests: `md5_…` for one that came as text, else what the caller gave.
    pub fn key(&self) -> &str {
        &self.key
    }

    /// The document as it came.
    pub fn document(&self) -> &Document {
        &self.document
    }
}

/// What `/io` replies.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "PascalCase")]
pub struct Description {
    /// What the definition is for, in its author's words.
    pub description: String,
    /// The key by which it is known in later requests.
    pub cache_key: String,
}
