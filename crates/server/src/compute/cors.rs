//! Pages of other sites: they may ask, unless only some are named.

use axum::http::header::{
    ACCESS_CONTROL_ALLOW_HEADERS, ACCESS_CONTROL_ALLOW_METHODS, ACCESS_CONTROL_ALLOW_ORIGIN,
    ACCESS_CONTROL_EXPOSE_HEADERS, ACCESS_CONTROL_MAX_AGE, ACCESS_CONTROL_REQUEST_HEADERS,
    ACCESS_CONTROL_REQUEST_METHOD, HeaderName, HeaderValue, ORIGIN, VARY,
};
use axum::http::{HeaderMap, Method};

/// What a page may read of an answer's head beside what it may read anyway.
const READABLE: &str =
    "Server-Timing, X-Request-Id, Retry-After, Location, Content-Encoding, Content-Disposition";

/// The pages that may ask.
#[derive(Debug, Clone, Default)]
pub(crate) struct Origins(Vec<String>);

impl Origins {
    /// These; all where none is named.
    pub(crate) fn new(origins: &[String]) -> Self {
        Self(origins.iter().map(|origin| origin.trim().trim_end_matches('/').to_owned()).collect())
    }

    fn allowed(&self, asking: &HeaderMap) -> Option<HeaderValue> {
        let origin = asking.get(ORIGIN)?;
        if self.0.is_empty() || self.0.iter().any(|one| one == "*") {
            return Some(HeaderValue::from_static("*"));
        }
        let named = self.0.iter().any(|one| one.as_bytes().eq_ignore_ascii_case(origin.as_bytes()));
        named.then(|| origin.clone())
    }

    /// Tells a browser whether the page may read the answer.
    pub(crate) fn mark(&self, asking: &HeaderMap, answer: &mut HeaderMap) {
        if !self.0.is_empty() {
            answer.append(VARY, HeaderValue::from_static("Origin"));
        }
        let Some(origin) = self.allowed(asking) else { return };
        answer.insert(HeaderName::from_static("timing-allow-origin"), origin.clone());
        answer.insert(ACCESS_CONTROL_ALLOW_ORIGIN, origin);
        answer.insert(ACCESS_CONTROL_EXPOSE_HEADERS, HeaderValue::from_static(READABLE));
    }

    /// Answers the question that a browser asks before it sends a request of a page: what may be sent.
    pub(crate) fn prepare(&self, asking: &HeaderMap, methods: &'static str, answer: &mut HeaderMap) {
        if self.allowed(asking).is_none() {
            return;
        }
        let wanted = asking.get(ACCESS_CONTROL_REQUEST_HEADERS).cloned();
        answer.insert(ACCESS_CONTROL_ALLOW_METHODS, HeaderValue::from_static(methods));
        answer.insert(ACCESS_CONTROL_ALLOW_HEADERS, wanted.unwrap_or(HeaderValue::from_static("*")));
        answer.insert(ACCESS_CONTROL_MAX_AGE, HeaderValue::from_static("86400"));
    }
}

/// Whether this is that question.
pub(crate) fn is_preflight(method: &Method, headers: &HeaderMap) -> bool {
    *method == Method::OPTIONS
        && headers.contains_key(ORIGIN)
        && headers.contains_key(ACCESS_CONTROL_REQUEST_METHOD)
}
