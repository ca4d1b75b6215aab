//! The functions: their table, and how they are called.

mod call;
pub(crate) mod numeric;
mod table;
mod text;

pub(crate) use call::call;
pub(crate) use table::Function;
pub use table::FunctionHelp;

/// Every function of the language in the order of a help page: trigonometry, logarithms, rounding, statistics,
/// angles and casts, vectors, texts, logic.
pub fn functions() -> impl Iterator<Item = &'static FunctionHelp> {
    table::TABLE.iter().map(|(_, help)| help)
}
