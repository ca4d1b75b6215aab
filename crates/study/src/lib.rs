//! A definition as a space of designs: solved at many points, into a table that can be gone on with.
//!
//! A [`Prepared`] definition has its [`Variable`]s and [`Output`]s found, and what does not hang on them is solved. Each worker
//! solves points on a clone of it, on one thread, so that points are what is done side by side. On this stand [`sweep()`],
//! [`effects_here`] and [`effects_over_range`], [`optimise()`] and [`solve_for()`]. A [`Dispatcher`] hands points out to
//! [`PointSolver`]s in other processes, or to a program that asks for them.
//!
//! Without the feature `studies`, which threads, files and plots belong to, there is what needs neither: effects, [`motion()`] and
//! [`solve_for()`], which an [`Inquiry`] finds in slices.

#![cfg_attr(
    not(feature = "studies"),
    allow(dead_code, unreachable_pub, reason = "parts of what is shared are for studies alone")
)]

mod cell;
#[cfg(feature = "studies")]
mod dispatcher;
mod effects;
mod error;
#[cfg(feature = "studies")]
mod folder;
mod inquiry;
mod inside;
mod lock;
mod motion;
#[cfg(feature = "studies")]
mod optimise;
mod output;
#[cfg(feature = "studies")]
mod places;
mod plan;
#[cfg(feature = "studies")]
mod plot;
#[cfg(feature = "studies")]
mod pool;
mod prepared;
mod probe;
mod random;
mod reach;
#[cfg(feature = "studies")]
mod record;
mod solve_for;
#[cfg(feature = "studies")]
mod solver;
#[cfg(feature = "studies")]
mod store;
#[cfg(feature = "studies")]
mod sweep;
#[cfg(feature = "studies")]
mod table;
#[cfg(feature = "studies")]
mod things;
pub mod thresholds;
mod variable;

pub use cell::Cell;
#[cfg(feature = "studies")]
pub use dispatcher::Dispatcher;
#[cfg(feature = "studies")]
pub use effects::effects_over_range;
pub use effects::{Derivative, End, Here, RangeSettings, Ranged, Screening, Share, Slope, effects_here};
pub use error::StudyError;
#[cfg(feature = "studies")]
pub use folder::{About, Column, DefinitionFile, Kind, NamedBound, NamedGoal, Row, State, StudyFolder};
pub use inquiry::Inquiry;
pub use motion::{Arrow, Motion, motion, shown_objects};
#[cfg(feature = "studies")]
pub use optimise::{
    Best, Bound, Constraint, Goal, Method, Objective, OptimiseSettings, Optimum, galapagos, optimise,
};
pub use output::{Output, marked};
#[cfg(feature = "studies")]
pub use plan::{Plan, PlanFile, PlanPoints};
#[cfg(feature = "studies")]
pub use plot::{Plot, PlotOptions, plot};
pub use prepared::{Outcome, Prepared, Status, Worker};
pub use reach::inputs_of;
pub use solve_for::{Effort, Solution, solve_for};
#[cfg(feature = "studies")]
pub use solver::{Batch, PointSolver};
#[cfg(feature = "studies")]
pub use sweep::{Progress, Settings, Summary, sweep};
#[cfg(feature = "studies")]
pub use things::{Thing, Things};
pub use variable::Variable;
