use std::sync::Arc;
use std::time::Duration;

use katydid_3dm::Model;

use crate::reply::Reply;

/// How long the steps of a request took: what a server puts into `Server-Timing`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Timings {
    /// Reading the values of the request.
    pub decode: Duration,
    /// Solving.
    pub solve: Duration,
    /// Writing the results.
    pub encode: Duration,
}

/// The results of a request.
#[derive(Debug)]
pub struct Solution {
    timings: Timings,
}

impl Solution {
    /// The reply as it is sent.
    pub fn reply(&self) -> Reply {
        Reply::default()
    }

    /// Whether a component reported an error: the reply goes out with status 500 then, whole.
    pub fn has_errors(&self) -> bool {
        false
    }

    /// How long it took; the time for the reply is known only in an [`Answer`].
    pub fn timings(&self) -> Timings {
        self.timings
    }

    /// The geometry of the outputs as a model, for those who want a file in place of the reply.
    pub fn model(&self) -> Model {
        Model::default()
    }
}

/// A reply as it is sent.
#[derive(Debug, Clone)]
pub struct Answer {
    /// The JSON text.
    pub body: Arc<[u8]>,
    /// Whether a component reported an error: status 500.
    pub has_errors: bool,
    /// Whether it was kept from an earlier request with the same body.
    pub kept: bool,
    /// How long the steps took.
    pub timings: Timings,
}
