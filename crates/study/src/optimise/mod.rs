//! The best of a definition: inputs by which outputs are small or large, found by a method that asks for points in batches.

mod cma;
mod eigen;
mod front;
mod galapagos;
mod goals;
mod nsga2;
mod run;
mod search;
mod turn;

pub(crate) use front::front;
pub use galapagos::galapagos;
pub use goals::{Bound, Constraint, Goal, Objective};
pub use run::{Best, Method, OptimiseSettings, Optimum, optimise};
