//! A job followed as it goes: server-sent events.

use std::convert::Infallible;
use std::time::Duration;

use axum::body::{Body, Bytes};
use axum::http::header::{CACHE_CONTROL, CONTENT_TYPE, HeaderValue};
use axum::response::Response;
use futures_util::stream;
use tokio::sync::watch;
use tokio::time::{sleep, timeout};

use super::super::refusal::Refusal;
use super::super::service::Service;
use super::{Job, Stage};
use std::sync::Arc;

/// No more often does somebody hear of progress.
const PAUSE: Duration = Duration::from_millis(50);
/// So often they hear that there is still somebody here.
const STILL: Duration = Duration::from_secs(15);

struct Following {
    job: Arc<Job>,
    stage: watch::Receiver<Stage>,
    is_first: bool,
}

/// Tells how far a job is, each time that it goes on, until it is over.
pub(crate) fn events(service: &Service, id: &str) -> Result<Response, Refusal> {
    let job = service.jobs.get(id)?;
    let stage = job.stage.subscribe();
    let following = Some(Following { job, stage, is_first: true });
    let body = Body::from_stream(stream::unfold(following, next));
    let mut response = Response::new(body);
    let headers = response.headers_mut();
    headers.insert(CONTENT_TYPE, HeaderValue::from_static("text/event-stream"));
    headers.insert(CACHE_CONTROL, HeaderValue::from_static("no-store"));
    // Proxies must not gather them.
    headers.insert("x-accel-buffering", HeaderValue::from_static("no"));
    Ok(response)
}

async fn next(following: Option<Following>) -> Option<(Result<Bytes, Infallible>, Option<Following>)> {
    let mut following = following?;
    if !following.is_first {
        sleep(PAUSE).await;
        match timeout(STILL, following.stage.changed()).await {
            Ok(Ok(())) => {}
            // The job is gone.
            Ok(Err(_)) => return None,
            Err(_) => return Some((Ok(Bytes::from_static(b": still here\n\n")), Some(following))),
        }
    }
    following.is_first = false;
    let stage = following.stage.borrow_and_update().clone();
    let name = if matches!(stage, Stage::Running { .. }) { "progress" } else { stage.name() };
    let text = format!("event: {name}\ndata: {}\n\n", following.job.about(&stage));
    let rest = (!stage.is_over()).then_some(following);
    Some((Ok(Bytes::from(text)), rest))
}
