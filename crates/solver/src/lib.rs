//! Runs a definition: finds the order, solves what is dirty, in parallel where objects do not depend on each
//! other, within a budget, and tells what each object gave, said and took.
//!
//! The results are the same to the last bit on any number of threads.
//!
//! ```
//! use katydid_definition::document::Document;
//! use katydid_solver::{Engine, Options};
//!
//! let mut engine = Engine::new(Document::new(), Options::default());
//! assert_eq!(engine.solve().solved, 0);
//! ```

mod cluster;
mod collect;
mod engine;
mod given;
mod graph;
mod inputs;
mod modifiers;
mod object;
mod options;
mod outside;
mod recorder;
mod refused;
mod region;
mod remote;
mod report;
mod rounds;
mod schedule;
mod script;
mod ticks;
mod update;

pub use engine::{Engine, Summary};
pub use inputs::Inputs;
pub use object::{is_note, of_object};
pub use options::{Finished, Listener, Options, Progress, ResultListener};
pub use refused::Refused;
pub use remote::{HOPS, Question, Remote, Solved};
pub use report::{ObjectReport, Status};
pub use script::{ScriptDone, ScriptMaker, ScriptTask, Scripts, Unrun};
pub use ticks::Ticks;
