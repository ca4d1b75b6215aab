use std::sync::Arc;
use std::time::Duration;

use katydid_3dm::Model;
use katydid_data::Tree;
use katydid_session::{BakeOptions, Baked, bake};
use katydid_solver::{Engine, Inputs};

use crate::definition::{Data, idle_objects};
use crate::reply::{Messages, OutputTree, Reply};
use crate::{Definition, Settings, SolveRequest};

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
    definition: Arc<Definition>,
    engine: Engine,
    messages: Messages,
    archive: i32,
    cache_solve: bool,
    all_types: bool,
    warnings: bool,
    timings: Timings,
}

impl Solution {
    pub(crate) fn new(
        definition: Arc<Definition>,
        engine: Engine,
        request: &SolveRequest,
        settings: &Settings,
        timings: Timings,
    ) -> Self {
        Self {
            messages: Messages::of(&engine, &definition.interface().problems),
            archive: request.archive(),
            cache_solve: request.cache_solve,
            all_types: request.all_types,
            warnings: settings.warnings,
            definition,
            engine,
            timings,
        }
    }

    /// The reply as it is sent.
    pub fn reply(&self) -> Reply {
        let inputs = Inputs::new(&self.engine);
        let outputs = &self.definition.interface().outputs;
        let mut messages = self.messages.clone();
        messages.warnings.extend(idle_objects(self.definition.document()));
        let values = outputs
            .iter()
            .map(|output| {
                let tree = match output.data {
                    Data::Given { object, output } => self.given(object, output),
                    Data::Taken { object, input } => inputs.of(object).into_iter().nth(input),
                };
                let (tree, left_out) =
                    OutputTree::of(&output.name, &tree.unwrap_or_default(), self.archive, self.all_types);
                messages.warnings.extend(left_out);
                tree
            })
            .collect();
        if !self.warnings {
            messages.warnings.clear();
        }
        Reply {
            pointer: self.definition.key().to_owned(),
            cachesolve: self.cache_solve,
            values,
            warnings: messages.warnings,
            errors: messages.errors,
            ..Reply::default()
        }
    }

    fn given(&self, object: usize, output: usize) -> Option<Tree> {
        self.engine.report(object)?.outputs.get(output).cloned()
    }

    /// Whether a component reported an error, or is one that is not supported: the reply goes out with status 500 then,
    /// whole.
    pub fn has_errors(&self) -> bool {
        self.messages.failed
    }

    /// How long it took; the time for the reply is known only in an [`Answer`].
    pub fn timings(&self) -> Timings {
        self.timings
    }

    /// The geometry of the outputs as a model, for those who want a file in place of the reply; of all that is shown,
    /// where nothing is marked as output.
    pub fn model(&self) -> Model {
        self.baked().model
    }

    /// The same with what could not be put into it.
    pub fn baked(&self) -> Baked {
        bake(&self.engine, BakeOptions::default())
    }

    /// The engine with all results.
    pub fn engine(&self) -> &Engine {
        &self.engine
    }

    /// The definition that was solved.
    pub fn definition(&self) -> &Arc<Definition> {
        &self.definition
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
