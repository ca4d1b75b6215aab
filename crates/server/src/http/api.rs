//! Everything but the page and the socket.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use axum::Json;
use axum::body::Body;
use axum::extract::rejection::{JsonRejection, QueryRejection};
use axum::extract::{FromRequest, Path as Named, Query, Request, State as Extract};
use axum::http::header::{CACHE_CONTROL, CONTENT_DISPOSITION, CONTENT_LENGTH, CONTENT_TYPE, HeaderValue};
use axum::http::{HeaderMap, StatusCode};
use axum::response::{IntoResponse, Response};
use bytes::Bytes;
use katydid_component::RhinoModel;
use katydid_studio::catalogue;
use serde::Deserialize;
use serde_json::{Value, json};
use uuid::Uuid;

use super::State;
use super::answer::Refused;
use crate::document::{Attached, Command, Source, left_behind};
use crate::files;
use crate::files::{Form, Gallery, Wishes};

pub(super) type Answer<T> = Result<T, Refused>;
pub(super) type Question<T> = Result<Query<T>, QueryRejection>;

pub(super) fn asked<T>(query: Question<T>) -> Answer<T> {
    query.map(|Query(query)| query).map_err(|error| Refused::bad(error.body_text()))
}

/// Work that blocks, away from the threads that serve.
pub(super) async fn blocking<T: Send + 'static>(
    work: impl FnOnce() -> Result<T, String> + Send + 'static,
) -> Answer<T> {
    let failed = || Refused::new(StatusCode::INTERNAL_SERVER_ERROR, "this failed: please report it");
    tokio::task::spawn_blocking(work).await.map_err(|_| failed())?.map_err(Refused::bad)
}

/// So many documents that were never saved are offered.
const MOST_LEFT: usize = 20;

/// What the start page offers.
pub(crate) async fn start(Extract(state): Extract<Arc<State>>) -> Answer<Json<Value>> {
    let shared = Arc::clone(&state.shared);
    let recent = if shared.trust.names_paths() {
        blocking(move || Ok(shared.recent.as_ref().map(files::Recent::entries).unwrap_or_default())).await?
    } else {
        Vec::new()
    };
    let about = state.documents.about().await;
    let mut open: Vec<Value> = about
        .iter()
        .filter(|(_, about)| !about.is_passing)
        .map(|(id, about)| json!({"id": id, "name": about.name, "changed": about.changed}))
        .collect();
    if let Some(journals) = state.shared.journals.clone().filter(|_| state.shared.trust.names_paths()) {
        let left = blocking(move || Ok(left_behind(&journals))).await?;
        let left = left.into_iter().filter(|id| !about.iter().any(|(known, _)| known == id));
        open.extend(left.take(MOST_LEFT).map(|id| json!({"id": id, "name": "Unsaved", "changed": true})));
    }
    Ok(Json(json!({
        "recent": recent,
        "gallery": Gallery::all(),
        "open": open,
        "version": env!("CARGO_PKG_VERSION"),
        "local": state.shared.trust.names_paths(),
    })))
}

/// What is to be opened.
#[derive(Debug, Deserialize)]
pub(crate) struct Opening {
    path: Option<PathBuf>,
    gallery: Option<String>,
    #[serde(default)]
    new: bool,
}

pub(crate) async fn open(
    Extract(state): Extract<Arc<State>>,
    opening: Result<Json<Opening>, JsonRejection>,
) -> Answer<Json<Value>> {
    let Json(opening) = opening.map_err(|error| Refused::new(error.status(), error.body_text()))?;
    let paths = state.shared.trust.names_paths();
    let source = match opening {
        Opening { path: Some(_), .. } if !paths => {
            return Err(Refused::forbidden(
                "files of the server's machine cannot be named from here: send it instead",
            ));
        }
        Opening { path: Some(path), .. } => blocking(move || Source::file(&path)).await?,
        Opening { gallery: Some(id), .. } => {
            let one = Gallery::find(&id).ok_or_else(|| Refused::missing("definition in the gallery"))?;
            blocking(move || from_gallery(one)).await?
        }
        Opening { new: true, .. } => Source::empty(),
        _ => return Err(Refused::bad("name a path or a definition of the gallery, or say that it is new")),
    };
    opened(&state, source).await
}

/// Which document is to be closed.
#[derive(Debug, Deserialize)]
pub(crate) struct Closing {
    document: String,
}

pub(crate) async fn close(
    Extract(state): Extract<Arc<State>>,
    closing: Result<Json<Closing>, JsonRejection>,
) -> Answer<Json<Value>> {
    let Json(Closing { document }) =
        closing.map_err(|error| Refused::new(error.status(), error.body_text()))?;
    match state.documents.close(&document).await {
        Ok(true) => Ok(Json(json!({ "closed": document }))),
        Ok(false) => Err(Refused::missing("document")),
        Err(reason) => Err(Refused::new(StatusCode::CONFLICT, reason)),
    }
}

fn from_gallery(one: &Gallery) -> Result<Source, String> {
    let text = one.text().ok_or("it is not in this program")?;
    let mut source = Source::sent(&format!("{}.kd", one.id), Form::Kd, &text)?;
    source.name.clone_from(&one.name);
    Ok(source)
}

/// Of what a picture is wanted: of a definition of the gallery, or of a recent file.
#[derive(Debug, Deserialize)]
pub(crate) struct Portraying {
    gallery: Option<String>,
    recent: Option<PathBuf>,
}

/// Larger definitions get no picture.
const LARGEST_PORTRAYED: u64 = 16 << 20;

/// A small picture of a definition.
pub(crate) async fn portrait(
    Extract(state): Extract<Arc<State>>,
    query: Question<Portraying>,
) -> Answer<Response> {
    let shared = Arc::clone(&state.shared);
    let picture = match asked(query)? {
        Portraying { gallery: Some(id), .. } => {
            let one = Gallery::find(&id).ok_or_else(|| Refused::missing("definition in the gallery"))?;
            let made = move || {
                let text = one.text().ok_or("it is not in this program")?;
                Ok(shared.portraits.of(&text, &shared.trust, || from_gallery(one)))
            };
            blocking(made).await?
        }
        Portraying { recent: Some(path), .. } if shared.trust.names_paths() => {
            let known = shared.recent.as_ref().and_then(|recent| recent.find(|known| known == path));
            let path = known.ok_or_else(|| Refused::missing("recent file"))?;
            let made = move || {
                let told = |error: &std::io::Error| files::plain(error);
                let size = std::fs::metadata(&path).map_err(|error| told(&error))?.len();
                if size > LARGEST_PORTRAYED {
                    return Ok(None);
                }
                let bytes = std::fs::read(&path).map_err(|error| told(&error))?;
                Ok(shared.portraits.of(&bytes, &shared.trust, || Source::file(&path)))
            };
            blocking(made).await?
        }
        _ => return Err(Refused::bad("name a definition of the gallery or a recent file")),
    };
    let bytes = picture.ok_or_else(|| Refused::missing("picture"))?;
    let headers = [(CONTENT_TYPE, "image/png"), (CACHE_CONTROL, "private, max-age=600")];
    Ok((headers, Body::from(bytes)).into_response())
}

pub(super) async fn opened(state: &State, source: Source) -> Answer<Json<Value>> {
    if state.documents.is_full() {
        state.documents.close_idle().await;
    }
    let id = state
        .documents
        .open(source)
        .map_err(|reason| Refused::new(StatusCode::SERVICE_UNAVAILABLE, reason))?;
    Ok(Json(json!({ "document": id })))
}

/// What a file that is sent is called, and which document it belongs to.
#[derive(Debug, Deserialize)]
pub(crate) struct Sending {
    name: String,
    document: Option<String>,
    /// Whether a definition is only to be looked at: nothing is solved until somebody says so.
    #[serde(default)]
    locked: bool,
    /// Whether it is only shown for a while: edits are not kept, and it goes when nobody shows it.
    #[serde(default)]
    passing: bool,
}

pub(crate) async fn upload(
    Extract(state): Extract<Arc<State>>,
    query: Question<Sending>,
    headers: HeaderMap,
    body: Request,
) -> Answer<Json<Value>> {
    let Sending { name, document, locked, passing } = asked(query)?;
    let too_large = || {
        let most = state.most_upload >> 20;
        Refused::new(StatusCode::PAYLOAD_TOO_LARGE, format!("more than {most} MB cannot be sent"))
    };
    // Who says how much comes is refused before it comes.
    let told = headers.get(CONTENT_LENGTH).and_then(|length| length.to_str().ok()?.parse::<u64>().ok());
    if told.is_some_and(|length| length > state.most_upload as u64) {
        return Err(too_large());
    }
    let name = Path::new(&name).file_name().map(|name| name.to_string_lossy().into_owned());
    let name = name.ok_or_else(|| Refused::bad("a file has a name"))?;
    let bytes = Bytes::from_request(body, &()).await.map_err(|error| match error.status() {
        StatusCode::PAYLOAD_TOO_LARGE => too_large(),
        status => Refused::new(status, error.body_text()),
    })?;
    if name.to_lowercase().ends_with(".3dm") {
        let id = document.ok_or_else(|| Refused::bad("a model belongs to a document: say to which"))?;
        let handle = state.documents.get(&id).ok_or_else(|| Refused::missing("document"))?;
        let model = blocking(move || {
            let model = RhinoModel::read(&bytes).map_err(|error| format!("{name}: {error}"))?;
            Ok(Attached { name, model: Arc::new(model) })
        })
        .await?;
        handle.ask(|done| Command::Model(model, done)).await.ok_or_else(|| Refused::missing("document"))?;
        return Ok(Json(json!({ "document": id })));
    }
    let form =
        Form::of(Path::new(&name)).ok_or_else(|| Refused::bad("a definition is a .gh, .ghx or .kd file"))?;
    let source = blocking(move || Source::sent(&name, form, &bytes)).await?;
    opened(&state, Source { is_locked: locked, is_passing: passing, ..source }).await
}

/// Which document, in which form.
#[derive(Debug, Deserialize)]
pub(crate) struct Saving {
    document: String,
    format: String,
}

pub(crate) async fn save(Extract(state): Extract<Arc<State>>, query: Question<Saving>) -> Answer<Response> {
    let Saving { document, format } = asked(query)?;
    let form = Form::from_extension(&format)
        .ok_or_else(|| Refused::bad("a definition is saved as gh, ghx or kd"))?;
    let handle = state.documents.get(&document).ok_or_else(|| Refused::missing("document"))?;
    let made = handle.ask(|answer| Command::Bytes(form, answer)).await;
    let download = made.ok_or_else(|| Refused::missing("document"))?.map_err(Refused::bad)?;
    Ok(kept(&download.name, "application/octet-stream", download.bytes))
}

/// What a definition that is sent is called, and the form that it is wanted in.
#[derive(Debug, Deserialize)]
pub(crate) struct Converting {
    name: String,
    format: String,
}

/// A definition in another form; no document is opened.
pub(crate) async fn convert(query: Question<Converting>, body: Bytes) -> Answer<Response> {
    let Converting { name, format } = asked(query)?;
    let unknown = || Refused::bad("a definition is a .gh, .ghx or .kd file");
    let from = Form::of(Path::new(&name)).ok_or_else(unknown)?;
    let to = Form::from_extension(&format).ok_or_else(unknown)?;
    let stem = Path::new(&name).file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let bytes = blocking(move || {
        let source = Source::sent(&name, from, &body)?;
        files::write(to, &source.document).map(|(bytes, _)| bytes)
    })
    .await?;
    Ok(kept(&format!("{stem}.{}", to.extension()), "application/octet-stream", bytes))
}

/// Which document.
#[derive(Debug, Deserialize)]
pub(crate) struct Exporting {
    document: String,
}

pub(crate) async fn export(
    Extract(state): Extract<Arc<State>>,
    query: Question<Exporting>,
    wishes: Question<Wishes>,
) -> Answer<Response> {
    let Exporting { document } = asked(query)?;
    let wishes = asked(wishes)?;
    let handle = state.documents.get(&document).ok_or_else(|| Refused::missing("document"))?;
    let about = handle.ask(Command::About).await.ok_or_else(|| Refused::missing("document"))?;
    let format = wishes.format.clone();
    let made = handle.with(move |engine| files::export(engine, &wishes)).await;
    let (bytes, kind) = made
        .map_err(|reason| Refused::new(StatusCode::SERVICE_UNAVAILABLE, reason))?
        .map_err(Refused::bad)?;
    let stem = Path::new(&about.name).file_stem().map(|stem| stem.to_string_lossy().into_owned());
    let stem = stem.filter(|stem| !stem.is_empty()).unwrap_or_else(|| "definition".to_owned());
    Ok(kept(&format!("{stem}.{format}"), kind, bytes))
}

/// A file for the browser to keep.
fn kept(name: &str, kind: &'static str, bytes: Vec<u8>) -> Response {
    // Header values are plain: other letters are written as the standard for that says (RFC 5987).
    let plain: String = name
        .chars()
        .map(|c| if c.is_ascii_alphanumeric() || " .-_()".contains(c) { c } else { '_' })
        .collect();
    let encoded: String = name
        .bytes()
        .map(|b| {
            if b.is_ascii_alphanumeric() || b".-_".contains(&b) {
                char::from(b).to_string()
            } else {
                format!("%{b:02X}")
            }
        })
        .collect();
    let disposition = if plain == name {
        format!("attachment; filename=\"{plain}\"")
    } else {
        format!("attachment; filename=\"{plain}\"; filename*=UTF-8''{encoded}")
    };
    let mut response = ([(CONTENT_TYPE, kind)], Body::from(bytes)).into_response();
    if let Ok(value) = HeaderValue::from_str(&disposition) {
        response.headers_mut().insert(CONTENT_DISPOSITION, value);
    }
    response
}

pub(crate) async fn components() -> Response {
    ([(CONTENT_TYPE, "application/json"), (CACHE_CONTROL, "no-cache")], catalogue::all()).into_response()
}

/// Which component.
#[derive(Debug, Deserialize)]
pub(crate) struct Helping {
    component: Uuid,
}

pub(crate) async fn help(query: Question<Helping>) -> Answer<Json<Value>> {
    let Helping { component } = asked(query)?;
    catalogue::help(component).map(Json).ok_or_else(|| Refused::missing("component"))
}

pub(crate) async fn geometry(
    Extract(state): Extract<Arc<State>>,
    Named(hash): Named<String>,
) -> Answer<Response> {
    let bytes = state.shared.geometries.get(&hash).ok_or_else(|| Refused::missing("geometry"))?;
    let headers =
        [(CONTENT_TYPE, "application/octet-stream"), (CACHE_CONTROL, "private, max-age=3600, immutable")];
    Ok((headers, Body::from(bytes)).into_response())
}

pub(crate) async fn image(
    Extract(state): Extract<Arc<State>>,
    Named(name): Named<String>,
) -> Answer<Response> {
    let (bytes, kind) = state.documents.picture(&name).await.ok_or_else(|| Refused::missing("picture"))?;
    let headers = [(CONTENT_TYPE, kind), (CACHE_CONTROL, "private, max-age=3600, immutable")];
    Ok((headers, Body::from(bytes)).into_response())
}
