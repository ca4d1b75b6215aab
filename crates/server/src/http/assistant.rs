//! What `katydid mcp --studio` asks: the documents that are open, their states, and steps that lead to others.
//!
//! Behind the guard like all else, and only where whoever started the studio lets assistants in. Only programs of this
//! machine may ask.

use std::sync::Arc;

use axum::body::Bytes;
use axum::extract::{FromRequestParts, State as Extract};
use axum::http::StatusCode;
use axum::http::request::Parts;
use axum::{Extension, Json};
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use katydid_session::journal::read_difference;
use serde::Deserialize;
use serde_json::{Value, json};

use super::State;
use super::answer::Refused;
use super::api::{Answer, Question as Asking, asked, blocking};
use super::socket::standing;
use crate::document::assistant::{Question, State as DocumentState};
use crate::document::{Command, Standing};
use crate::files::{self, Form};
use crate::listen::Peer;

/// A step has no more bytes: what is pasted is the largest.
pub(super) const LARGEST: usize = 64 << 20;

/// Proof that the request comes from a program of this machine, and that assistants may come in.
pub(crate) struct Admitted;

impl FromRequestParts<Arc<State>> for Admitted {
    type Rejection = Refused;

    async fn from_request_parts(parts: &mut Parts, state: &Arc<State>) -> Result<Self, Refused> {
        if !state.assistant {
            return Err(Refused::forbidden(
                "this studio lets no assistant in: it must be started with --allow-assistant",
            ));
        }
        let peer = Option::<Extension<Peer>>::from_request_parts(parts, state).await;
        let peer = peer.ok().flatten().map(|Extension(peer)| peer);
        match standing(peer, &parts.headers) {
            Standing::Owner => Ok(Self),
            Standing::Guest => Err(Refused::forbidden("only programs of the studio's own machine may ask")),
        }
    }
}

/// The documents that are open.
pub(crate) async fn documents(_: Admitted, Extract(state): Extract<Arc<State>>) -> Json<Value> {
    let about = state.documents.about().await;
    let open: Vec<Value> = about
        .iter()
        .filter(|(_, about)| !about.is_passing)
        .map(|(id, about)| json!({ "id": id, "name": about.name, "changed": about.changed, "shown": about.clients > 0 }))
        .collect();
    Json(json!({ "documents": open, "version": env!("CARGO_PKG_VERSION") }))
}

/// Which document, and the revision that is known.
#[derive(Debug, Deserialize)]
pub(crate) struct Reading {
    document: String,
    known: Option<u64>,
}

/// The state of a document: its revision, and all of it where that is another than is known.
pub(crate) async fn state(
    _: Admitted,
    Extract(state): Extract<Arc<State>>,
    query: Asking<Reading>,
) -> Answer<Json<Value>> {
    let Reading { document, known } = asked(query)?;
    told(ask(&state, &document, Question::State { known }).await?).await
}

/// To which document a step belongs, from which state it leads, and what it is called.
#[derive(Debug, Deserialize)]
pub(crate) struct Stepping {
    document: String,
    revision: u64,
    name: String,
}

/// Takes a step.
pub(crate) async fn step(
    _: Admitted,
    Extract(state): Extract<Arc<State>>,
    query: Asking<Stepping>,
    body: Bytes,
) -> Answer<Json<Value>> {
    let Stepping { document, revision, name } = asked(query)?;
    let read = move || read_difference(&body).ok_or_else(|| "the body is no step".to_owned());
    let difference = blocking(read).await?;
    told(ask(&state, &document, Question::Step { revision, name, difference }).await?).await
}

/// In which document, from which state, and which way.
#[derive(Debug, Deserialize)]
pub(crate) struct Walking {
    document: String,
    revision: u64,
    #[serde(default)]
    again: bool,
}

/// Takes the assistant's last step back, or makes it again.
pub(crate) async fn walk(
    _: Admitted,
    Extract(state): Extract<Arc<State>>,
    query: Asking<Walking>,
) -> Answer<Json<Value>> {
    let Walking { document, revision, again } = asked(query)?;
    told(ask(&state, &document, Question::Walk { revision, again }).await?).await
}

async fn ask(state: &State, document: &str, question: Question) -> Answer<DocumentState> {
    let handle = state.documents.get(document).ok_or_else(|| Refused::missing("document"))?;
    let answer = handle.ask(|done| Command::Assistant((question, done))).await;
    answer
        .ok_or_else(|| Refused::missing("document"))?
        .map_err(|reason| Refused::new(StatusCode::CONFLICT, reason))
}

async fn told(state: DocumentState) -> Answer<Json<Value>> {
    let rules = state.rules;
    let mut told = json!({
        "revision": state.revision,
        "name": state.name,
        "units": rules.units.name(),
        "tolerance": rules.tolerance.absolute,
        "angle": rules.tolerance.angle,
        "model": state.model,
        "locked": state.is_locked,
        "step": state.step,
    });
    if let Some(document) = state.document {
        let written = move || files::write(Form::Gh, &document).map(|(bytes, _)| STANDARD.encode(bytes));
        told["document"] = json!(blocking(written).await?);
    }
    Ok(Json(told))
}
