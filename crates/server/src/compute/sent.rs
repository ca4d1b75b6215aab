//! What goes back over the wire.

use std::io::Write;
use std::sync::{Arc, OnceLock};
use std::time::Duration;

use axum::body::Body;
use axum::http::header::{
    ALLOW, CONTENT_DISPOSITION, CONTENT_ENCODING, CONTENT_TYPE, HeaderName, HeaderValue, LOCATION,
    RETRY_AFTER, VARY,
};
use axum::http::{HeaderMap, StatusCode};
use axum::response::Response;
use bytes::Bytes;
use flate2::Compression;
use flate2::write::GzEncoder;
use katydid_component::Account;
use katydid_geometry::CancellationToken;

use super::refusal::Refusal;

/// Less is not worth packing.
const WORTH_PACKING: usize = 2048;
/// So much is packed between two looks at whether somebody still waits.
const PIECE: usize = 1 << 18;

pub(crate) const JSON: &str = "application/json; charset=utf-8";
pub(crate) const TEXT: &str = "text/plain; charset=utf-8";
pub(crate) const HTML: &str = "text/html; charset=utf-8";

/// The name of the header that tells how long the steps took.
pub(crate) const SERVER_TIMING: HeaderName = HeaderName::from_static("server-timing");

/// The name of the header that tells that an answer is that of an earlier request (RFC 9211).
pub(crate) const CACHE_STATUS: HeaderName = HeaderName::from_static("cache-status");

/// A whole answer: its length is known before its head is sent.
#[derive(Debug, Clone)]
pub(crate) struct Sent {
    status: StatusCode,
    body: Bytes,
    headers: HeaderMap,
}

impl Sent {
    pub(crate) fn new(kind: &'static str, body: impl Into<Bytes>) -> Self {
        let mut headers = HeaderMap::new();
        headers.insert(CONTENT_TYPE, HeaderValue::from_static(kind));
        Self { status: StatusCode::OK, body: body.into(), headers }
    }

    /// Without anything.
    pub(crate) fn empty(status: StatusCode) -> Self {
        Self { status, body: Bytes::new(), headers: HeaderMap::new() }
    }

    pub(crate) fn text(text: impl Into<String>) -> Self {
        Self::new(TEXT, text.into())
    }

    pub(crate) fn json(value: &impl serde::Serialize) -> Self {
        match katydid_compute::to_json(value) {
            Ok(body) => Self::new(JSON, body),
            Err(fault) => Refusal::from(fault).into(),
        }
    }

    #[must_use]
    pub(crate) fn with_status(mut self, status: StatusCode) -> Self {
        self.status = status;
        self
    }

    #[must_use]
    pub(crate) fn with(mut self, name: HeaderName, value: &str) -> Self {
        if let Ok(value) = HeaderValue::from_str(value) {
            self.headers.insert(name, value);
        }
        self
    }

    /// To be kept as a file of that name.
    #[must_use]
    pub(crate) fn named(self, name: &str) -> Self {
        self.with(CONTENT_DISPOSITION, &format!("attachment; filename=\"{name}\""))
    }

    #[must_use]
    pub(crate) fn at(self, location: &str) -> Self {
        self.with(LOCATION, location)
    }

    #[must_use]
    pub(crate) fn allowing(self, methods: &str) -> Self {
        self.with(ALLOW, methods)
    }

    #[must_use]
    pub(crate) fn timed(self, steps: &[(&str, Duration)]) -> Self {
        let steps: Vec<String> =
            steps.iter().map(|(name, took)| format!("{name};dur={:.3}", took.as_secs_f64() * 1e3)).collect();
        self.with(SERVER_TIMING, &steps.join(", "))
    }

    /// Packed, where the client understands that and it is worth it.
    #[must_use]
    pub(crate) fn packed(mut self, accepts: bool) -> Self {
        if self.body.len() < WORTH_PACKING || self.headers.contains_key(CONTENT_ENCODING) {
            return self;
        }
        self.headers.insert(VARY, HeaderValue::from_static("Accept-Encoding"));
        if !accepts {
            return self;
        }
        let mut packer = GzEncoder::new(Vec::with_capacity(self.body.len() / 3), Compression::fast());
        let mut pieces = self.body.chunks(PIECE);
        if pieces.all(|piece| !CancellationToken::is_over() && packer.write_all(piece).is_ok())
            && let Ok(packed) = packer.finish()
            && packed.len() < self.body.len()
        {
            self.body = packed.into();
            self.headers.insert(CONTENT_ENCODING, HeaderValue::from_static("gzip"));
        }
        self
    }

    /// Counted on the account of its request for as long as it is there: a client may take its time to hear it.
    #[must_use]
    pub(crate) fn counted(mut self, account: Arc<Account>) -> Self {
        struct Held(Bytes, #[expect(dead_code, reason = "it gives back when it is dropped")] Arc<Account>);

        impl AsRef<[u8]> for Held {
            fn as_ref(&self) -> &[u8] {
                &self.0
            }
        }

        self.body = Bytes::from_owner(Held(self.body, account));
        self
    }

    pub(crate) fn into_response(self) -> Response {
        let mut response = Response::new(Body::from(self.body));
        *response.status_mut() = self.status;
        *response.headers_mut() = self.headers;
        response
    }
}

/// An answer that is always the same: made and packed once. The threads that serve sockets have nothing else to do for it.
#[derive(Debug, Default)]
pub(crate) struct Page([OnceLock<Sent>; 2]);

impl Page {
    pub(crate) const fn new() -> Self {
        Self([OnceLock::new(), OnceLock::new()])
    }

    pub(crate) fn sent(&self, packs: bool, make: impl FnOnce() -> Sent) -> Sent {
        self.0[usize::from(packs)].get_or_init(|| make().packed(packs)).clone()
    }
}

impl From<Refusal> for Sent {
    fn from(refusal: Refusal) -> Self {
        let sent = Self::new(JSON, refusal.body()).with_status(refusal.status);
        match refusal.retry {
            Some(seconds) => sent.with(RETRY_AFTER, &seconds.to_string()),
            None => sent,
        }
    }
}

/// Whether the client takes gzip.
pub(crate) fn accepts_gzip(headers: &HeaderMap) -> bool {
    let all = headers.get_all(axum::http::header::ACCEPT_ENCODING).iter();
    all.filter_map(|value| value.to_str().ok()).flat_map(|value| value.split(',')).any(|one| {
        let mut parts = one.split(';').map(str::trim);
        let name = parts.next().unwrap_or_default();
        let is_refused = parts.any(|part| {
            let quality = part.strip_prefix("q=").or_else(|| part.strip_prefix("Q="));
            quality.is_some_and(|quality| quality.parse::<f32>().is_ok_and(|quality| quality <= 0.0))
        });
        (name.eq_ignore_ascii_case("gzip") || name.eq_ignore_ascii_case("x-gzip") || name == "*")
            && !is_refused
    })
}
