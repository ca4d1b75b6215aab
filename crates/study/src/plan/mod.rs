//! Which points a sweep solves.

mod axis;
#[cfg(feature = "studies")]
mod bound;
mod file;
#[cfg(feature = "studies")]
pub(crate) mod rows;
pub(crate) mod sampling;
pub(crate) mod sobol;

pub(crate) use axis::{Axis, whole_range};
#[cfg(feature = "studies")]
pub(crate) use bound::rows_of;
#[cfg(feature = "studies")]
pub use bound::{Plan, PlanPoints};
use file::InputPlan;
#[cfg(feature = "studies")]
pub use file::PlanFile;
pub(crate) use sampling::placed;
