use std::fmt;
use std::sync::Arc as Shared;

/// What holds an object of a script's own language: a process that runs scripts. When the last token of an object goes, it
/// lets go of it.
pub trait Keeper: fmt::Debug + Send + Sync {
    /// The number of the object.
    fn number(&self) -> u64;

    /// Whether the object is gone with its process.
    fn is_lost(&self) -> bool;

    /// How its language writes it, for panels; none where that is not known.
    fn text(&self) -> Option<&str> {
        None
    }

    /// As it, to ask which keeper it is.
    fn as_any(&self) -> &dyn std::any::Any;
}

/// An object of a script's own language, on its way from one script to another. It stays in the process that runs them.
#[derive(Debug, Clone)]
pub struct Token(pub Shared<dyn Keeper>);

impl PartialEq for Token {
    fn eq(&self, other: &Self) -> bool {
        Shared::ptr_eq(&self.0, &other.0)
    }
}
