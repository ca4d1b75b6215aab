//! The folder of a study: what is written into it besides the tables, and what can be read of it, while it is made and after.

mod about;
mod file;
mod live;
mod read;
mod rows;
mod table;

pub use about::{About, DefinitionFile, NamedBound, NamedGoal};
pub(crate) use live::Log;
pub use read::{State, StudyFolder};
pub use rows::{Column, Kind, Row};
