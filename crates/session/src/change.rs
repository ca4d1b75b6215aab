use std::sync::Arc;

use katydid_data::cast::Rules;
use katydid_definition::document::{Difference, Document, Misfit};
use katydid_solver::Engine;
use uuid::Uuid;

/// What an edit made of the document.
#[derive(Debug, Clone)]
pub struct Change {
    /// The number of the document's state after it. An edit of which nothing came leaves it as it was.
    pub revision: u64,
    /// The step from the state before to the state after, for whoever follows the document: a solver, a journal, a client.
    pub difference: Arc<Difference>,
    /// The units and tolerances, where they are others now.
    pub rules: Option<Rules>,
    /// The ids of the objects that a paste or copy made.
    pub made: Vec<Uuid>,
    /// The document before.
    pub before: Arc<Document>,
    /// The document after.
    pub after: Arc<Document>,
}

impl Change {
    /// Whether nothing came of the edit.
    pub fn is_empty(&self) -> bool {
        self.difference.is_empty()
    }

    /// Brings an engine whose document is that before to the state after. What need not be solved again keeps its
    /// results.
    ///
    /// # Errors
    /// When the engine's document is another: it has missed a change.
    pub fn bring_to(&self, engine: &mut Engine) -> Result<(), Misfit> {
        engine.apply(&self.difference)?;
        if let Some(rules) = self.rules {
            engine.set_rules(rules);
        }
        Ok(())
    }
}

/// Why a request was not carried out. The document is as it was then.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Refusal {
    /// No object has that id.
    #[error("there is no object with the id {0}")]
    NoObject(Uuid),
    /// No input or output has that id.
    #[error("there is no port with the id {0}")]
    NoPort(Uuid),
    /// The wire would close a loop.
    #[error("the wire would close a loop: {0}")]
    Loop(String),
    /// The object does not take the edit.
    #[error("'{object}': {reason}")]
    Unfit {
        /// The object's name.
        object: String,
        /// Why not.
        reason: String,
    },
    /// The request itself makes no sense.
    #[error("{0}")]
    Senseless(String),
}

impl From<katydid_definition::Error> for Refusal {
    fn from(error: katydid_definition::Error) -> Self {
        match error {
            katydid_definition::Error::Edit { object, reason } => Self::Unfit { object, reason },
            other => Self::Senseless(other.to_string()),
        }
    }
}
