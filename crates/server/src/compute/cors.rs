//! Pages in browsers: which of them may ask.
//!
//! Any page that somebody visits can make the browser send requests to this machine. A server with a key need not mind:
//! pages do not know it. One without a key answers the pages of this machine only, unless it is told which others may ask.

use axum::http::header::{
    ACCESS_CONTROL_ALLOW_HEADERS, ACCESS_CONTROL_ALLOW_METHODS, ACCESS_CONTROL_ALLOW_ORIGIN,
    ACCESS_CONTROL_EXPOSE_HEADERS, ACCESS_CONTROL_MAX_AGE, ACCESS_CONTROL_REQUEST_HEADERS,
    ACCESS_CONTROL_REQUEST_METHOD, HOST, HeaderName, HeaderValue, ORIGIN, VARY,
};
use axum::http::{HeaderMap, Method};

use crate::names::{is_this_machine, of_origin};

/// What a page may read of an answer's head beside what it may read anyway.
const READABLE: &str =
    "Server-Timing, X-Request-Id, Retry-After, Location, Content-Encoding, Content-Disposition";

/// The pages that may ask.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Origins {
    /// All.
    Any,
    /// Those of this machine.
    Local,
    /// These, and the server's own.
    Named {
        /// By scheme and host, as `https://example.org`.
        origins: Vec<String>,
        /// Whether a key is needed besides: then the server's own pages may have any name.
        has_key: bool,
    },
}

impl Origins {
    /// Those that are named, or all for `*`. Where none is named, all may ask a server that has a key.
    pub(crate) fn new(named: &[String], has_key: bool) -> Self {
        let origins: Vec<String> =
            named.iter().map(|origin| origin.trim().trim_end_matches('/').to_owned()).collect();
        match origins.as_slice() {
            [] if has_key => Self::Any,
            [] => Self::Local,
            all if all.iter().any(|one| one == "*") => Self::Any,
            _ => Self::Named { origins, has_key },
        }
    }

    /// Why a request may not be answered: a page sends it that may not ask, or has made its own name point here.
    pub(crate) fn refuses(&self, asking: &HeaderMap) -> Option<&'static str> {
        const PAGE: &str = "this page may not ask: --allow-origin names those that may";
        const NAME: &str =
            "this name is none of the server's: ask 127.0.0.1, or start it with a key or --allow-origin";
        if *self == Self::Any {
            return None;
        }
        // Browsers always say which name they looked up.
        if *self == Self::Local && asking.contains_key(HOST) && !host(asking).is_some_and(is_this_machine) {
            return Some(NAME);
        }
        match asking.get(ORIGIN) {
            Some(origin) => (!self.takes(origin, asking)).then_some(PAGE),
            // Links and pictures bring no origin; the browser says all the same that they are of another site.
            None => {
                let site = asking.get("sec-fetch-site").map(HeaderValue::as_bytes);
                let is_foreign = matches!(site, Some(b"cross-site" | b"same-site"));
                (*self == Self::Local && is_foreign).then_some(PAGE)
            }
        }
    }

    fn takes(&self, origin: &HeaderValue, asking: &HeaderMap) -> bool {
        let of = origin.to_str().ok().and_then(of_origin);
        match self {
            Self::Any => true,
            Self::Local => of.is_some_and(is_this_machine),
            Self::Named { origins, has_key } => {
                let is_own = of.is_some_and(|of| {
                    host(asking).is_some_and(|host| host.eq_ignore_ascii_case(of))
                        && (*has_key || is_this_machine(of))
                });
                is_own || origins.iter().any(|one| one.as_bytes().eq_ignore_ascii_case(origin.as_bytes()))
            }
        }
    }

    fn allowed(&self, asking: &HeaderMap) -> Option<HeaderValue> {
        let origin = asking.get(ORIGIN)?;
        match self {
            Self::Any => Some(HeaderValue::from_static("*")),
            _ => self.takes(origin, asking).then(|| origin.clone()),
        }
    }

    /// Tells a browser whether the page may read the answer.
    pub(crate) fn mark(&self, asking: &HeaderMap, answer: &mut HeaderMap) {
        if *self != Self::Any {
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

/// The name that the server was asked by, when it is there once.
fn host(asking: &HeaderMap) -> Option<&str> {
    let mut all = asking.get_all(HOST).iter();
    let first = all.next()?.to_str().ok()?;
    all.next().is_none().then_some(first)
}

/// Whether this is that question.
pub(crate) fn is_preflight(method: &Method, headers: &HeaderMap) -> bool {
    *method == Method::OPTIONS
        && headers.contains_key(ORIGIN)
        && headers.contains_key(ACCESS_CONTROL_REQUEST_METHOD)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test may fail")]

    use super::*;

    fn refused(origins: &Origins, headers: &[(&'static str, &str)]) -> bool {
        let mut map = HeaderMap::new();
        for (name, value) in headers {
            map.append(*name, HeaderValue::from_str(value).unwrap());
        }
        origins.refuses(&map).is_some()
    }

    #[test]
    fn without_a_key_pages_of_this_machine_may_ask() {
        let local = Origins::new(&[], false);
        let host = ("host", "127.0.0.1:6500");
        assert!(!refused(&local, &[host]));
        for origin in
            ["http://localhost:3000", "https://localhost", "http://127.0.0.1:1", "http://[::1]:8080"]
        {
            assert!(!refused(&local, &[host, ("origin", origin)]), "{origin}");
        }
        for origin in [
            "https://evil.example",
            "null",
            "",
            "file://",
            "http://localhost.evil.example",
            "http://10.0.0.1",
        ] {
            assert!(refused(&local, &[host, ("origin", origin)]), "{origin}");
        }
        assert!(refused(&local, &[host, ("sec-fetch-site", "cross-site")]));
        assert!(!refused(&local, &[host, ("sec-fetch-site", "none")]));
        // A name that was made to point here.
        assert!(refused(&local, &[("host", "evil.example:6500")]));
        assert!(refused(&local, &[("host", "evil.example"), ("origin", "http://evil.example")]));
        assert!(!refused(&local, &[]) && refused(&local, &[host, ("host", "evil.example")]));
    }

    #[test]
    fn it_can_be_told_otherwise() {
        let evil = [("host", "127.0.0.1:6500"), ("origin", "https://evil.example")];
        assert!(!refused(&Origins::new(&["*".to_owned()], false), &evil));
        assert!(!refused(&Origins::new(&[], true), &evil));
        let named = ["https://app.example/".to_owned()];
        for has_key in [false, true] {
            let origins = Origins::new(&named, has_key);
            assert!(refused(&origins, &evil));
            assert!(!refused(&origins, &[("host", "a.example"), ("origin", "https://APP.example")]));
            // The server's own page, which explains the addresses.
            assert!(!refused(&origins, &[("host", "127.0.0.1:6500"), ("origin", "http://127.0.0.1:6500")]));
            let renamed = [("host", "evil.example"), ("origin", "http://evil.example")];
            assert_eq!(refused(&origins, &renamed), !has_key);
        }
    }
}
