//! Requests that cannot be carried out, all answered in one form.

use axum::http::StatusCode;
use katydid_compute::{Cause, Fault};
use serde::Serialize;

use super::pool::Undone;

/// Why not: `{"error": "…", "cause": "…", "errors": ["…"]}`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Refusal {
    pub(crate) status: StatusCode,
    pub(crate) cause: &'static str,
    pub(crate) message: String,
    /// After how many seconds it may be worth trying again.
    pub(crate) retry: Option<u32>,
}

#[derive(Serialize)]
struct Told<'a> {
    error: &'a str,
    cause: &'a str,
    /// Where clients of `/grasshopper` look for what went wrong.
    errors: [&'a str; 1],
}

impl Refusal {
    pub(crate) fn new(status: StatusCode, cause: &'static str, message: impl Into<String>) -> Self {
        Self { status, cause, message: message.into(), retry: None }
    }

    pub(crate) fn bad(message: impl Into<String>) -> Self {
        Self::new(StatusCode::BAD_REQUEST, "bad-request", message)
    }

    pub(crate) fn missing(message: impl Into<String>) -> Self {
        Self::new(StatusCode::NOT_FOUND, "not-found", message)
    }

    pub(crate) fn unsupported(name: &str) -> Self {
        let message = format!("{name} is not supported");
        Self::new(StatusCode::NOT_IMPLEMENTED, "not-supported", message)
    }

    pub(crate) fn too_large(message: impl Into<String>) -> Self {
        Self::new(StatusCode::PAYLOAD_TOO_LARGE, "too-large", message)
    }

    pub(crate) fn late(message: impl Into<String>) -> Self {
        Self::new(StatusCode::REQUEST_TIMEOUT, "timed-out", message)
    }

    pub(crate) fn busy(message: impl Into<String>, retry: u32) -> Self {
        Self { retry: Some(retry), ..Self::new(StatusCode::SERVICE_UNAVAILABLE, "busy", message) }
    }

    /// Whether it was given up for lack of time or memory.
    pub(crate) fn is_for_lack(&self) -> bool {
        ["timed-out", "too-large", "busy"].contains(&self.cause)
    }

    /// The JSON text.
    pub(crate) fn body(&self) -> Vec<u8> {
        let told = Told { error: &self.message, cause: self.cause, errors: [&self.message] };
        serde_json::to_vec(&told).unwrap_or_default()
    }
}

impl From<Fault> for Refusal {
    fn from(fault: Fault) -> Self {
        if fault.cause == Cause::Busy {
            return Self::busy(fault.message, 5);
        }
        let (status, cause) = match &fault.cause {
            Cause::BadRequest => (StatusCode::BAD_REQUEST, "bad-request"),
            Cause::NotFound => (StatusCode::NOT_FOUND, "not-found"),
            Cause::NotSupported(_) => (StatusCode::NOT_IMPLEMENTED, "not-supported"),
            Cause::TooLarge => (StatusCode::PAYLOAD_TOO_LARGE, "too-large"),
            Cause::TimedOut => (StatusCode::REQUEST_TIMEOUT, "timed-out"),
            // Nobody is there to hear it, as a rule.
            Cause::Cancelled => (StatusCode::CONFLICT, "cancelled"),
            Cause::Refused => (StatusCode::FORBIDDEN, "refused"),
            _ => (StatusCode::INTERNAL_SERVER_ERROR, "failed"),
        };
        Self::new(status, cause, fault.message)
    }
}

impl From<Undone> for Refusal {
    fn from(undone: Undone) -> Self {
        match undone {
            Undone::Full => Self::busy("too many requests wait already: try again soon", 2),
            Undone::Waited => Self {
                retry: Some(5),
                ..Self::late("the time of the request was over before its turn came: try again later")
            },
            Undone::Late => Self::late("the time that a request may take is over"),
            Undone::Failed => Self::new(
                StatusCode::INTERNAL_SERVER_ERROR,
                "failed",
                "this failed as it must not: please report it",
            ),
        }
    }
}
