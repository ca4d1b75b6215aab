//! What every request passes: it gets an id, other sites' pages and keys are looked at, and what came of it is noted.

use std::hash::{BuildHasher, RandomState};
use std::net::IpAddr;
use std::sync::{Arc, OnceLock};
use std::time::Instant;

use axum::extract::{Request, State};
use axum::http::header::{CONTENT_LENGTH, HeaderName, HeaderValue};
use axum::http::{HeaderMap, Method, StatusCode};
use axum::response::Response;
use bytes::Bytes;
use uuid::Uuid;

use super::asked::{Asking, cache_control};
use super::behind::{Head, waited};
use super::body::Received;
use super::cors::is_preflight;
use super::pool::Client;
use super::query::Query;
use super::refusal::Refusal;
use super::route::{self, Address, Route};
use super::sent::{Sent, accepts_gzip};
use super::service::Service;
use super::{Processes, about, geometry, health, jobs, metrics, openapi, solve};
use crate::listen::Peer;

const ID: HeaderName = HeaderName::from_static("x-request-id");
/// No id is longer.
const LONGEST_ID: usize = 128;

/// Answers a request.
pub(crate) async fn answer(State(service): State<Arc<Service>>, request: Request) -> Response {
    let now = Instant::now();
    let since = match service.config.processes {
        Processes::Behind(_) => now.checked_sub(waited(request.headers())).unwrap_or(now),
        _ => now,
    };
    let parts = route::parts(request.uri().path());
    let address = route::find(&parts);
    let id = id(request.headers());
    let headers = request.headers().clone();
    let method = request.method().clone();
    let told = headers.get(CONTENT_LENGTH).and_then(|length| length.to_str().ok()?.parse().ok());
    let mut visit = Visit {
        service: Arc::clone(&service),
        since,
        address,
        method: method.clone(),
        id: id.clone(),
        received: told.unwrap_or(0),
        is_over: false,
    };
    let mut response = match before(&service, address, &method, &headers) {
        Some(sent) => sent.into_response(),
        None => match routed(&service, address, &parts, request, since).await {
            Ok(response) => response,
            Err(refusal) => Sent::from(refusal).into_response(),
        },
    };
    if is_preflight(&method, &headers) {
        service.origins.prepare(&headers, "GET, HEAD, POST, DELETE, OPTIONS", response.headers_mut());
    }
    service.origins.mark(&headers, response.headers_mut());
    if let Ok(id) = HeaderValue::from_str(&id) {
        response.headers_mut().insert(ID, id);
    }
    response.headers_mut().insert("x-content-type-options", HeaderValue::from_static("nosniff"));
    visit.ends(&response);
    response
}

/// What is answered before anything is looked at: questions of browsers, and who may not come in.
fn before(
    service: &Service,
    address: Option<&Address>,
    method: &Method,
    headers: &HeaderMap,
) -> Option<Sent> {
    if *method == Method::OPTIONS {
        let allowed = address.map_or_else(|| "OPTIONS".to_owned(), Address::allowed);
        return Some(Sent::empty(StatusCode::NO_CONTENT).allowing(&allowed));
    }
    if address.is_some_and(|address| address.is_open) {
        return None;
    }
    if let Some(why) = service.origins.refuses(headers) {
        return Some(Sent::from(Refusal::new(StatusCode::FORBIDDEN, "refused", why)));
    }
    service.lock.refuses(headers)
}

async fn routed(
    service: &Arc<Service>,
    address: Option<&Address>,
    parts: &[String],
    request: Request,
    since: Instant,
) -> Result<Response, Refusal> {
    let address = address.ok_or_else(|| Refusal::missing("there is nothing at this address: see /docs"))?;
    if !address.allows(request.method()) {
        let refusal = Refusal::new(
            StatusCode::METHOD_NOT_ALLOWED,
            "bad-request",
            format!("this is asked for with {}", address.methods.join(" or ")),
        );
        return Ok(Sent::from(refusal).allowing(&address.allowed()).into_response());
    }
    let (head, body) = request.into_parts();
    let query = Query::read(head.uri.query().unwrap_or_default());
    let packs = accepts_gzip(&head.headers);
    let client = client(&head.headers, head.extensions.get::<Peer>().copied());
    let asks = head.method == Method::GET || head.method == Method::HEAD;
    let id = parts.get(1).map(String::as_str).unwrap_or_default();
    let Client(turn) = client;
    let head = Head { method: head.method, uri: head.uri, headers: head.headers, client: turn, since };
    if let Some(behind) = service.behind.as_ref().filter(|_| address.route.is_of_jobs()) {
        // Its memory counts until it is sent on.
        let received = match address.route {
            Route::Jobs => Some(service.room.receive(&head.headers, body).await?),
            _ => None,
        };
        service.idle.touch();
        let body = received.as_ref().map_or_else(Bytes::new, Received::as_sent);
        return behind.ask(&head, body, None).await;
    }
    let asking = |head, query| Asking { head, query, packs };
    let owned = Arc::clone(service);
    let sent = match address.route {
        Route::Grasshopper => {
            let body = service.room.receive(&head.headers, body).await?;
            return solve::grasshopper(owned, asking(head, query), body).await;
        }
        Route::Io if asks => return solve::io_of_pointer(owned, asking(head, query)).await,
        Route::Io => {
            let body = service.room.receive(&head.headers, body).await?;
            return solve::io(owned, asking(head, query), body).await;
        }
        Route::Geometry if asks => geometry::help(parts)?,
        Route::Geometry => {
            let body = service.room.receive(&head.headers, body).await?;
            return geometry::call(owned, asking(head, query), parts, body).await;
        }
        Route::Jobs => {
            let body = service.room.receive(&head.headers, body).await?;
            jobs::submit(owned, client, &query, cache_control(&head.headers), body).await?
        }
        Route::Job if asks => jobs::about(service, id)?,
        Route::Job => jobs::cancel(service, id)?,
        Route::JobEvents => return jobs::events(service, id),
        Route::JobResult => jobs::result(service, client, id, &query, packs).await?,
        Route::Health => health::check(owned, &query).await,
        Route::Metrics => metrics::page(service).await,
        Route::OpenApi => openapi::document(packs),
        Route::Docs => openapi::page(packs),
        Route::Sdk => geometry::list(packs),
        Route::SdkSource => return Err(Refusal::unsupported("the source of a client")),
        other => about::answer(service, other),
    };
    Ok(sent.into_response())
}

/// The id that a client gave its request, or a new one.
fn id(headers: &HeaderMap) -> String {
    let given = headers.get(&ID).and_then(|id| id.to_str().ok()).filter(|id| {
        let is_plain = |b: u8| b.is_ascii_alphanumeric() || b"-_.:/+=".contains(&b);
        !id.is_empty() && id.len() <= LONGEST_ID && id.bytes().all(is_plain)
    });
    given.map_or_else(|| Uuid::new_v4().simple().to_string(), str::to_owned)
}

/// Who takes turns with others: a machine of the network. All that comes from this machine comes through something: a
/// proxy, which says for whom, or a program, each connection of which counts.
fn client(headers: &HeaderMap, peer: Option<Peer>) -> Client {
    static HASHES: OnceLock<RandomState> = OnceLock::new();
    let hashes = HASHES.get_or_init(RandomState::new);
    let Some(Peer(peer)) = peer else { return Client(0) };
    let address: IpAddr = peer.ip().to_canonical();
    if !address.is_loopback() {
        return Client(hashes.hash_one(address));
    }
    let named = ["x-forwarded-for", "rhino-compute-client"].into_iter().find_map(|name| headers.get(name));
    match named.and_then(|value| value.to_str().ok()) {
        // The last is the one that the proxy itself has seen.
        Some(value) => Client(hashes.hash_one(value.rsplit(',').next().unwrap_or(value).trim())),
        None => Client(hashes.hash_one(peer)),
    }
}

/// A request on its way: it is noted when it ends, and when its client leaves before.
struct Visit {
    service: Arc<Service>,
    since: Instant,
    address: Option<&'static Address>,
    method: Method,
    id: String,
    received: u64,
    is_over: bool,
}

impl Visit {
    fn ends(&mut self, response: &Response) {
        use axum::body::HttpBody;
        self.is_over = true;
        let sent = response.body().size_hint().exact().unwrap_or(0);
        self.note(response.status().as_u16(), sent);
    }

    fn note(&self, status: u16, sent: u64) {
        let took = self.since.elapsed();
        // Paths are told as the table has them: what clients write into theirs stays out of logs and figures.
        let path = self.address.map_or("unknown", |address| address.path);
        self.service.metrics.answered(path, status, took, self.received, sent);
        let (method, id) = (self.method.as_str(), self.id.as_str());
        let ms = took.as_secs_f64() * 1e3;
        let received = self.received;
        if status >= 500 {
            tracing::warn!(target: "katydid::access", id, method, path, status, ms, received, sent);
        } else {
            tracing::info!(target: "katydid::access", id, method, path, status, ms, received, sent);
        }
    }
}

impl Drop for Visit {
    fn drop(&mut self) {
        if !self.is_over {
            // As nginx has it: the client closed the request.
            self.note(499, 0);
        }
    }
}
