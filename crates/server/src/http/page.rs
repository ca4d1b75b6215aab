//! The page and its files, out of the binary; in debug builds from the folder that it is built in.

use axum::body::Body;
use axum::http::header::{CACHE_CONTROL, CONTENT_TYPE};
use axum::http::{Method, StatusCode, Uri};
use axum::response::{IntoResponse, Response};
use rust_embed::Embed;

use super::answer::Refused;

#[derive(Embed)]
#[folder = "$CARGO_MANIFEST_DIR/../../studio/dist"]
// What the pages of the book load is in the crate that makes them.
#[exclude = "learn/*"]
#[allow_missing = true]
struct Page;

/// What is shown where the page was never built.
const MISSING: &str = include_str!("missing.html");

/// Whether the page is here.
pub(crate) fn has_page() -> bool {
    Page::get("index.html").is_some()
}

/// A file of the page; the page itself for `/`.
pub(crate) async fn serve(method: Method, uri: Uri) -> Response {
    if !matches!(method, Method::GET | Method::HEAD) {
        return Refused::new(StatusCode::METHOD_NOT_ALLOWED, "this cannot be done here").into_response();
    }
    let path = uri.path().trim_start_matches('/');
    let path = if path.is_empty() { "index.html" } else { path };
    // Names are those that were embedded: nothing leads out of the folder, in debug builds neither.
    let is_plain = path.split('/').all(|part| !part.is_empty() && !part.starts_with('.'))
        && !path.contains(['\\', '%', '\0', ':']);
    file(if is_plain { path } else { "" })
}

/// The page on a study.
pub(crate) async fn study() -> Response {
    file("study.html")
}

fn file(path: &str) -> Response {
    match Page::get(path) {
        Some(file) => {
            // Files of the page have the hash of what is in them in their names.
            let lasting = path.starts_with("assets/");
            let cache = if lasting { "public, max-age=31536000, immutable" } else { "no-cache" };
            let kind = file.metadata.mimetype().to_owned();
            ([(CONTENT_TYPE, kind), (CACHE_CONTROL, cache.to_owned())], Body::from(file.data.into_owned()))
                .into_response()
        }
        None if matches!(path, "index.html" | "study.html") => {
            let kind = "text/html; charset=utf-8";
            (StatusCode::SERVICE_UNAVAILABLE, [(CONTENT_TYPE, kind)], MISSING).into_response()
        }
        None => Refused::missing("page").into_response(),
    }
}
