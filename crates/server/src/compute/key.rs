//! The key that clients must know.

use axum::http::{HeaderMap, StatusCode};

use super::sent::Sent;
use crate::secret::Secret;

/// Where clients put it.
const HEADER: &str = "rhinocomputekey";

/// Lets those in who know the key.
#[derive(Debug)]
pub(crate) struct Lock(Option<Secret>);

impl Lock {
    /// Open where there is no key.
    pub(crate) fn new(key: Option<&str>) -> Self {
        Self(key.map(Secret::new))
    }

    pub(crate) fn is_open(&self) -> bool {
        self.0.is_none()
    }

    /// Why a request may not come in, in the words that clients know. Who brings several keys knows none.
    pub(crate) fn refuses(&self, headers: &HeaderMap) -> Option<Sent> {
        let secret = self.0.as_ref()?;
        let mut given = headers.get_all(HEADER).iter();
        let words = match (given.next(), given.next()) {
            (None, _) => "Api Key was not provided.",
            (Some(key), None) if secret.is(key.as_bytes()) => return None,
            _ => "Unauthorized client.",
        };
        Some(Sent::text(words).with_status(StatusCode::UNAUTHORIZED))
    }
}
