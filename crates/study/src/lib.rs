//! A definition as a space of designs: solved at many points, into a table that can be gone on with.
//!
//! A [`Prepared`] definition has its [`Variable`]s and [`Output`]s found, and what does not hang on them is solved. Each worker
//! solves points on a clone of it, on one thread, so that points are what is done side by side. On this stand [`sweep()`],
//! [`effects_here`] and [`effects_over_range`], [`optimise()`] and [`solve_for()`]. A [`Dispatcher`] hands points out to
//! [`PointSolver`]s in other processes, or to a program that asks for them.

mod cell;
mod dispatcher;
mod effects;
mod error;
mod folder;
mod inside;
mod motion;
mod optimise;
mod output;
mod places;
mod plan;
mod plot;
mod pool;
mod prepared;
mod probe;
mod random;
mod reach;
mod record;
mod solve_for;
mod solver;
mod store;
mod sweep;
mod table;
mod things;
pub mod thresholds;
mod variable;

pub use cell::Cell;
pub use dispatcher::Dispatcher;
pub use effects::{
    Derivative, End, Here, RangeSettings, Ranged, Screening, Share, Slope, effects_here, effects_over_range,
};
pub use error::StudyError;
pub use folder::{About, Column, DefinitionFile, Kind, NamedBound, NamedGoal, Row, State, StudyFolder};
pub use motion::{Arrow, Motion, motion, shown_objects};
pub use optimise::{
    Best, Bound, Constraint, Goal, Method, Objective, OptimiseSettings, Optimum, galapagos, optimise,
};
pub use output::{Output, marked};
pub use plan::{Plan, PlanFile, PlanPoints};
pub use plot::{Plot, PlotOptions, plot};
pub use prepared::{Outcome, Prepared, Status, Worker};
pub use reach::inputs_of;
pub use solve_for::{Effort, Solution, solve_for};
pub use solver::{Batch, PointSolver};
pub use sweep::{Progress, Settings, Summary, sweep};
pub use things::{Thing, Things};
pub use variable::Variable;
