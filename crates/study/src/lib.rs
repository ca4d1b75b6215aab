//! A definition as a space of designs: solved at many points, into a table that can be gone on with.
//!
//! A [`Prepared`] definition has its [`Variable`]s and [`Output`]s found, and what does not hang on them is solved. Each worker
//! solves points on a clone of it, on one thread, so that points are what is done side by side. On this stands [`sweep()`].

mod cell;
mod error;
mod output;
mod plan;
mod pool;
mod prepared;
mod random;
mod store;
mod sweep;
mod table;
mod things;
pub mod thresholds;
mod variable;

pub use cell::Cell;
pub use error::StudyError;
pub use output::{Output, marked};
pub use plan::{Plan, PlanFile, PlanPoints};
pub use prepared::{Outcome, Prepared, Status, Worker};
pub use sweep::{Progress, Settings, Summary, sweep};
pub use things::Things;
pub use variable::Variable;
