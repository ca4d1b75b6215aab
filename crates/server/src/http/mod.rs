//! The server's addresses.

mod answer;
mod api;
mod assistant;
mod documents;
mod guard;
mod learn;
mod page;
mod socket;
mod study;

use std::sync::Arc;

use axum::Router;
use axum::extract::DefaultBodyLimit;
use axum::middleware;
use axum::routing::{get, post};

use crate::Config;
use crate::document::Shared;
use crate::files::{Portraits, Recent};

pub(crate) use documents::Documents;
pub(crate) use guard::Guard;
pub(crate) use page::has_page;
pub(crate) use study::Study;

/// What all requests share.
#[derive(Debug)]
pub(crate) struct State {
    pub(crate) guard: Guard,
    pub(crate) documents: Documents,
    pub(crate) shared: Arc<Shared>,
    pub(crate) book: learn::Shelf,
    pub(crate) study: Option<Arc<Study>>,
    /// Whether programs of assistants may come in.
    assistant: bool,
    most_upload: usize,
}

/// A question in JSON has no more bytes.
const MOST_QUESTION: usize = 64 << 10;

impl State {
    pub(crate) fn new(config: Config, port: u16, study: Option<Study>) -> Self {
        let shared = Arc::new(Shared {
            portraits: Portraits::new(config.state.as_deref()),
            recent: Some(Recent::new(config.state.as_deref())),
            journals: config.state.as_ref().map(|state| state.join("journals")),
            trust: config.trust(),
            scripts: config.scripts.clone(),
            ..Shared::default()
        });
        Self {
            guard: Guard::new(&config, port),
            documents: Documents::new(Arc::clone(&shared), config.most_documents),
            shared,
            book: learn::Shelf::new(config.book.clone()),
            study: study.map(Arc::new),
            assistant: config.assistant,
            most_upload: config.most_upload,
        }
    }
}

/// All addresses, behind the guard.
pub(crate) fn router(state: Arc<State>) -> Router {
    let upload = post(api::upload).layer(DefaultBodyLimit::max(state.most_upload));
    let convert = post(api::convert).layer(DefaultBodyLimit::max(state.most_upload));
    let step = post(assistant::step).layer(DefaultBodyLimit::max(assistant::LARGEST));
    Router::new()
        .route("/api/assistant", get(assistant::documents))
        .route("/api/assistant/state", get(assistant::state))
        .route("/api/assistant/step", step)
        .route("/api/assistant/walk", post(assistant::walk))
        .route("/api/start", get(api::start))
        .route("/api/open", post(api::open))
        .route("/api/close", post(api::close))
        .route("/api/upload", upload)
        .route("/api/convert", convert)
        .route("/api/portrait", get(api::portrait))
        .route("/api/save", get(api::save))
        .route("/api/export", get(api::export))
        .route("/api/components", get(api::components))
        .route("/api/help", get(api::help))
        .route("/study", get(page::study))
        .route("/api/study", get(study::rows))
        .route("/api/study/open", post(study::open))
        .route("/api/study/file/{*name}", get(study::file))
        .route("/geometry/{hash}", get(api::geometry))
        .route("/image/{hash}", get(api::image))
        .route("/socket", get(socket::join))
        .route("/learn", get(learn::enter))
        .route("/learn/", get(learn::serve))
        .route("/learn/{*path}", get(learn::serve))
        .fallback(page::serve)
        .layer(DefaultBodyLimit::max(MOST_QUESTION))
        .layer(middleware::from_fn_with_state(Arc::clone(&state), guard::check))
        .with_state(state)
}
