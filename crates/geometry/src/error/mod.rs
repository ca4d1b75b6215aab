//! Why something could not be done.

pub(crate) mod refusal;

pub use refusal::{FaceName, Refusal, RefusalClass};

/// The kernel's result.
pub type Result<T> = std::result::Result<T, Error>;

/// Why the kernel refused an input or could not give an answer.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A number is NaN or infinite.
    #[error("{0} is not a finite number")]
    NotFinite(&'static str),
    /// Input that has no direction, no size or no inside: a zero vector, three points on a line, and the like.
    #[error("{what}: {why}")]
    Degenerate {
        /// The input, in the caller's words.
        what: &'static str,
        /// Why it cannot be used.
        why: &'static str,
    },
    /// A count, degree or parameter outside what the function takes.
    #[error("{what} is {value}, which must be {must}")]
    OutOfRange {
        /// The input, in the caller's words.
        what: &'static str,
        /// The value given.
        value: f64,
        /// The rule it breaks.
        must: &'static str,
    },
    /// Parts that do not fit each other: knot counts, weights, mesh indices.
    #[error("invalid {what}: {why}")]
    Invalid {
        /// The object.
        what: &'static str,
        /// The reason.
        why: String,
    },
    /// Nobody waits for the answer any more: `go_on` said no, or [`CancellationToken`](crate::CancellationToken) is over.
    #[error("the work was stopped")]
    Stopped,
    /// A boolean gave no result: the kind of case, the faces and the place.
    #[error("boolean refused: {0}")]
    Refused(Box<Refusal>),
    /// A case the kernel does not handle yet, by name.
    #[error("not supported: {0}")]
    Unsupported(&'static str),
}
