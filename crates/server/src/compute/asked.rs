//! Requests that are waited for, and where they are worked on.

use std::sync::Arc;
use std::time::{Duration, Instant};

use axum::http::header::{CACHE_CONTROL, PRAGMA};
use axum::http::{HeaderMap, HeaderValue};
use axum::response::Response;
use bytes::Bytes;
use katydid_component::Cancel;
use katydid_compute::CacheControl;

use super::behind::{Head, IN_FRONT};
use super::body::Received;
use super::memory::counted;
use super::pool::{Client, Clock, Step, Undone};
use super::query::Query;
use super::refusal::Refusal;
use super::sent::{SERVER_TIMING, Sent};
use super::service::Service;
use super::work::{Allowance, Reins};

/// A request that is waited for.
pub(crate) struct Asking {
    pub(crate) head: Head,
    pub(crate) query: Query,
    /// Whether the client takes gzip.
    pub(crate) packs: bool,
}

impl Asking {
    fn client(&self) -> Client {
        Client(self.head.client)
    }

    fn reins(&self, service: &Service) -> Result<Reins, Refusal> {
        let allowance = Allowance::new(service.config.timeout, service.config.limits, &self.query)?;
        let end = self.head.since.checked_add(allowance.time);
        let memory = service.memory.account(allowance.bytes);
        let cache = cache_control(&self.head.headers);
        Ok(Reins { cancel: Cancel::default(), progress: None, allowance, cache, memory, end })
    }

    /// What is left of the time.
    fn left(&self, reins: &Reins) -> Duration {
        reins.allowance.time.saturating_sub(self.head.since.elapsed())
    }
}

/// What the head of a request says about caches. `Pragma` is what clients of HTTP/1.0 have for it.
pub(crate) fn cache_control(headers: &HeaderMap) -> CacheControl {
    let values = headers.get_all(CACHE_CONTROL).iter().chain(headers.get_all(PRAGMA));
    let asked = values.filter_map(|value| value.to_str().ok()).map(CacheControl::of_header);
    asked.fold(CacheControl::Allowed, CacheControl::stricter)
}

/// An answer, and which process gave it.
pub(crate) struct Answered {
    pub(crate) response: Response,
    pub(crate) is_from_behind: bool,
}

type Worked = Step<Result<Sent, Refusal>>;

/// Has a request answered: here, or behind when it has not been quick, takes more than there is in front, or has a large
/// body.
pub(crate) async fn answered(
    service: &Arc<Service>,
    asking: &Asking,
    body: Option<&Received>,
    work: impl FnOnce(Reins) -> Worked + Send + 'static,
) -> Result<Answered, Refusal> {
    let reins = asking.reins(service)?;
    let from_here = |sent: Sent, reins: Reins| Answered {
        response: sent.counted(reins.memory).into_response(),
        is_from_behind: false,
    };
    let Some(behind) = &service.behind else {
        let inside = reins.clone();
        let work = move || counted(inside.clone(), move || work(inside));
        let clock = (Clock::Asked, asking.left(&reins));
        let sent = service.pool.run(asking.client(), &reins.cancel, clock, work).await??;
        return Ok(from_here(sent, reins));
    };
    if !body.is_some_and(Received::is_large)
        && let Some(sent) = in_front(service, asking, &reins, work).await?
    {
        behind.was_quick_in_front();
        return Ok(from_here(sent, reins));
    }
    service.idle.touch();
    let bytes = body.map_or_else(Bytes::new, Received::as_sent);
    let since = Instant::now();
    let mut response = behind.ask(&asking.head, bytes, Some(reins.allowance.time)).await?;
    service.idle.touch();
    // Beside what the other process says of its steps.
    let took = format!("behind;dur={:.3}", since.elapsed().as_secs_f64() * 1e3);
    if let Ok(took) = HeaderValue::from_str(&took) {
        response.headers_mut().append(SERVER_TIMING, took);
    }
    Ok(Answered { response, is_from_behind: true })
}

/// Works on a request for a slice of time, with the memory that there is in front. Gives nothing when that is not enough.
async fn in_front(
    service: &Service,
    asking: &Asking,
    reins: &Reins,
    work: impl FnOnce(Reins) -> Worked + Send + 'static,
) -> Result<Option<Sent>, Refusal> {
    let inside = reins.clone();
    let work = move || {
        let end = Instant::now() + IN_FRONT;
        let inside = Reins { end: Some(inside.end.map_or(end, |own| own.min(end))), ..inside };
        match counted(inside.clone(), move || work(inside)) {
            Step::Done(done) => Step::Done(done.map(Some)),
            Step::Later(..) => Step::Done(Ok(None)),
        }
    };
    let run = service.pool.run(asking.client(), &reins.cancel, (Clock::Begun, IN_FRONT), work);
    match tokio::time::timeout(asking.left(reins), run).await {
        Err(_) => Err(Undone::Waited.into()),
        Ok(Ok(Err(refusal))) if refusal.is_for_lack() => Ok(None),
        Ok(Ok(worked)) => worked,
        Ok(Err(Undone::Late)) => Ok(None),
        Ok(Err(undone)) => Err(undone.into()),
    }
}
