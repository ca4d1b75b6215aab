use std::fmt;

use katydid_component::shortened;

/// Why something asked for could not be done, as far as the asker has to know.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Cause {
    /// What was sent makes no sense.
    BadRequest,
    /// There is no such thing: a definition that is not kept any more, a function that nobody has.
    NotFound,
    /// It is known and not here; its name.
    NotSupported(String),
    /// More was sent, or would come out, than is allowed.
    TooLarge,
    /// The time that it may take is over.
    TimedOut,
    /// Whoever asked does not want it any more.
    Cancelled,
    /// There is no memory for it beside what else is done now.
    Busy,
    /// It is not allowed here.
    Refused,
    /// It was tried, and went wrong.
    Failed,
}

/// Something that could not be done: the cause, and words for whoever asked.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fault {
    /// Why.
    pub cause: Cause,
    /// What is wrong, in a sentence without a full stop. It names no path of this machine.
    pub message: String,
}

impl Fault {
    /// A fault of that cause.
    pub fn new(cause: Cause, message: impl Into<String>) -> Self {
        Self { cause, message: shortened(message) }
    }

    /// What was sent makes no sense.
    pub fn bad_request(message: impl Into<String>) -> Self {
        Self::new(Cause::BadRequest, message)
    }

    /// There is no such thing.
    pub fn not_found(message: impl Into<String>) -> Self {
        Self::new(Cause::NotFound, message)
    }

    /// It is known and not here.
    pub fn not_supported(name: impl Into<String>) -> Self {
        let name = name.into();
        Self { message: format!("{name} is not supported"), cause: Cause::NotSupported(name) }
    }

    /// More than is allowed.
    pub fn too_large(message: impl Into<String>) -> Self {
        Self::new(Cause::TooLarge, message)
    }

    /// There is no memory for it beside what else is done now.
    pub fn busy() -> Self {
        Self::new(Cause::Busy, "There is no memory for this beside what else is solved now: try again later")
    }

    /// It is not allowed here.
    pub fn refused(message: impl Into<String>) -> Self {
        Self::new(Cause::Refused, message)
    }

    /// It went wrong.
    pub fn failed(message: impl Into<String>) -> Self {
        Self::new(Cause::Failed, message)
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for Fault {}
