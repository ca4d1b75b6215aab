//! The pages of the live book, built when somebody asks for the first of them.

use std::fmt::Write as _;
use std::path::PathBuf;
use std::sync::Arc;

use axum::body::Body;
use axum::extract::State as Extract;
use axum::http::header::{CACHE_CONTROL, CONTENT_TYPE};
use axum::http::{StatusCode, Uri};
use axum::response::{IntoResponse, Redirect, Response};
use katydid_book::{Book, Files, Site};
use rust_embed::Embed;
use tokio::sync::OnceCell;

use super::State;
use super::answer::Refused;

/// Katydid's own book.
#[derive(Embed)]
#[folder = "$CARGO_MANIFEST_DIR/../../book"]
#[include = "*.md"]
#[include = "*.kd"]
#[include = "*.json"]
#[include = "*.txt"]
struct Own;

/// The book that is served, once it is built.
#[derive(Debug, Default)]
pub(crate) struct Shelf {
    folder: Option<PathBuf>,
    site: OnceCell<Result<Arc<Site>, String>>,
}

impl Shelf {
    /// With the folder of the book; without one it is Katydid's own.
    pub(crate) fn new(folder: Option<PathBuf>) -> Self {
        Self { folder, site: OnceCell::new() }
    }

    async fn site(&self) -> Result<Arc<Site>, String> {
        let built = self.site.get_or_init(|| async {
            let folder = self.folder.clone();
            let failed = |_| "the book could not be built: please report it".to_owned();
            tokio::task::spawn_blocking(move || built(folder)).await.map_err(failed)?
        });
        built.await.clone()
    }
}

fn built(folder: Option<PathBuf>) -> Result<Arc<Site>, String> {
    let files = match folder {
        Some(folder) => Files::folder(&folder)?,
        None => {
            let mut files = Files::default();
            for name in Own::iter() {
                if let Some(file) = Own::get(&name) {
                    files.put(name.as_ref(), file.data.into_owned());
                }
            }
            files
        }
    };
    let site = Book::read(files).and_then(|book| book.build());
    site.map(Arc::new).map_err(|faults| {
        let mut text = "this book cannot be shown:\n".to_owned();
        for fault in faults {
            let _ = writeln!(text, "{fault}");
        }
        text
    })
}

/// `/learn` is the folder that its pages stand in.
pub(crate) async fn enter() -> Redirect {
    Redirect::permanent("/learn/")
}

/// A file of the book.
pub(crate) async fn serve(Extract(state): Extract<Arc<State>>, uri: Uri) -> Response {
    let site = match state.book.site().await {
        Ok(site) => site,
        Err(why) => {
            return (StatusCode::INTERNAL_SERVER_ERROR, [(CONTENT_TYPE, "text/plain; charset=utf-8")], why)
                .into_response();
        }
    };
    let path = uri.path().trim_start_matches("/learn").trim_start_matches('/');
    let path =
        if path.is_empty() || path.ends_with('/') { format!("{path}index.html") } else { path.to_owned() };
    let Some(bytes) = site.files.get(&path) else {
        return Refused::missing("page of the book").into_response();
    };
    // Files there have the hash of what is in them in their names.
    let cache = if path.starts_with("assets/") { "public, max-age=31536000, immutable" } else { "no-cache" };
    ([(CONTENT_TYPE, kind(&path)), (CACHE_CONTROL, cache)], Body::from(bytes.clone())).into_response()
}

/// The media type of a file by its name.
fn kind(path: &str) -> &'static str {
    match path.rsplit_once('.').map_or("", |(_, kind)| kind) {
        "html" => "text/html; charset=utf-8",
        "css" => "text/css; charset=utf-8",
        "js" => "text/javascript; charset=utf-8",
        "svg" => "image/svg+xml",
        "json" => "application/json",
        _ => "text/plain; charset=utf-8",
    }
}
