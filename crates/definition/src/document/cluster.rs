use std::collections::HashMap;

use uuid::Uuid;

use super::{Document, Object, ids};
use crate::archive::{self, ItemValue, Limits};
use crate::{Error, Result};

/// How many clusters may stand inside each other. Real files have three.
pub const MOST_NESTED: usize = 16;

/// What is inside a cluster.
#[derive(Debug, Clone, PartialEq)]
pub enum ClusterContent {
    /// A document, and which object in it each outer port belongs to.
    Open {
        /// The document inside.
        document: Box<Document>,
        /// The pairs of outer port and inner object.
        hooks: Vec<Hook>,
    },
    /// Encrypted with a password: its bytes are kept, but nobody can look inside.
    Locked,
    /// In another file, at this path.
    File(String),
}

/// The tie between a cluster's port and the object inside it that gives or takes the data.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Hook {
    /// The id of the cluster's port.
    pub port: Uuid,
    /// The id of the Cluster Input or Cluster Output inside.
    pub object: Uuid,
}

impl Object {
    /// What is inside, when the object is a cluster.
    ///
    /// # Errors
    /// The inner result is an error when the inside is broken, is missing, or lies more than [`MOST_NESTED`]
    /// clusters deep.
    pub fn cluster(&self, limits: &Limits) -> Option<Result<ClusterContent>> {
        let container = self.container();
        let document = container.bytes("ClusterDocument");
        if self.component != ids::CLUSTER && document.is_none() {
            return None;
        }
        Some(match document {
            Some(bytes) => self.open(bytes, limits),
            None if container.bytes("EncryptedDocument").is_some() => Ok(ClusterContent::Locked),
            None => {
                let file = container.child("FileInfo");
                let path = file.and_then(|file| file.str("FilePath").or_else(|| file.str("Path")));
                path.map(|path| ClusterContent::File(path.to_owned()))
                    .ok_or_else(|| self.trouble("the cluster is empty"))
            }
        })
    }

    fn open(&self, bytes: &[u8], limits: &Limits) -> Result<ClusterContent> {
        let nesting = self.nesting + 1;
        if nesting > MOST_NESTED {
            return Err(self.trouble(&format!("more than {MOST_NESTED} clusters stand inside each other")));
        }
        let document = Document::nested(archive::read(bytes, limits)?, nesting)?;
        Ok(ClusterContent::Open { document: Box::new(document), hooks: self.hooks() })
    }

    /// The ties between a cluster's ports and the objects inside, in the file's order.
    pub fn hooks(&self) -> Vec<Hook> {
        let Some(map) = self.container().child("ParamMap") else { return Vec::new() };
        let values: HashMap<i32, _> = map.list("Value").into_iter().collect();
        let hook = |(k, key): (i32, &ItemValue)| {
            Some(Hook { port: key.as_guid()?, object: values.get(&k)?.as_guid()? })
        };
        map.list("Key").into_iter().filter_map(hook).collect()
    }

    fn trouble(&self, reason: &str) -> Error {
        Error::Document { place: self.title().to_owned(), reason: reason.to_owned() }
    }
}
