//! Messages of the compiler, numbered and worded as C# programmers know them.

use std::fmt;

use crate::source::{Location, Pos};

/// A fault at a place that is not yet a line and a column.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fault {
    /// The place.
    pub pos: Pos,
    /// The number of the message in C#: 1002 is CS1002. Zero for messages of this compiler alone.
    pub code: u16,
    /// The message.
    pub message: String,
}

impl Fault {
    /// A fault.
    pub fn new(pos: Pos, code: u16, message: impl Into<String>) -> Self {
        Self { pos, code, message: message.into() }
    }
}

/// An error found before anything runs.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Diagnostic {
    /// Where.
    pub at: Location,
    /// The number of the message in C#: 1002 is CS1002. Zero for messages of this compiler alone.
    pub code: u16,
    /// The message.
    pub message: String,
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: error", self.at)?;
        if self.code > 0 {
            write!(f, " CS{:04}", self.code)?;
        }
        write!(f, ": {}", self.message)
    }
}

/// The result of what may meet one fault and stop there.
pub(crate) type Checked<T> = Result<T, Fault>;
