//! `/grasshopper` and `/io`.

use std::sync::Arc;
use std::time::{Duration, Instant};

use axum::http::HeaderMap;
use axum::response::Response;
use katydid_component::Cancel;
use katydid_compute::{CacheControl, Located, SolveRequest};

use super::asked::{Asking, answered, cache_control};
use super::body::Received;
use super::form::Form;
use super::pool::{Client, Clock, Lane, SLICE, Step};
use super::refusal::Refusal;
use super::sent::{SERVER_TIMING, Sent};
use super::service::Service;
use super::work::{self, Outcome, Reins, Wish};

/// What was answered behind within so long is quick: it is kept in front too.
const QUICK: Duration = Duration::from_millis(25);

/// Solves a definition.
pub(crate) async fn grasshopper(
    service: Arc<Service>,
    asking: Asking,
    body: Received,
) -> Result<Response, Refusal> {
    let form = Form::named(asking.query.get("format").unwrap_or_default())?;
    waited(service, asking, body, Wish::Results(form)).await
}

/// Tells what a definition asks for and gives.
pub(crate) async fn io(service: Arc<Service>, asking: Asking, body: Received) -> Result<Response, Refusal> {
    waited(service, asking, body, Wish::Description).await
}

/// The same for a definition that is named in the address.
pub(crate) async fn io_of_pointer(service: Arc<Service>, asking: Asking) -> Result<Response, Refusal> {
    let pointer = asking.query.get("pointer").filter(|pointer| !pointer.is_empty());
    let pointer = pointer.ok_or_else(|| Refusal::bad("GET /io needs a Pointer query parameter."))?;
    let request = SolveRequest::for_pointer(pointer);
    let (packs, held) = (asking.packs, Arc::clone(&service));
    let work = move |reins: Reins| {
        packed(work::with_request(held, request, Wish::Description, reins, Instant::now()), packs)
    };
    answered(&service, &asking, None, work).await.map(|answered| answered.response)
}

async fn waited(
    service: Arc<Service>,
    asking: Asking,
    body: Received,
    wish: Wish,
) -> Result<Response, Refusal> {
    let (packs, held, own) = (asking.packs, Arc::clone(&service), body.clone());
    let work = move |reins: Reins| packed(work::begin(held, own, wish, reins), packs);
    let since = Instant::now();
    let answered = answered(&service, &asking, Some(&body), work).await?;
    let may_keep = cache_control(&asking.head.headers) == CacheControl::Allowed;
    if may_keep && answered.is_from_behind && answered.response.status().is_success() && !body.is_large() {
        let took = match wish {
            Wish::Description => Some(since.elapsed()),
            _ => timed(answered.response.headers()),
        };
        if took.is_some_and(|took| took <= QUICK) {
            tokio::spawn(adopt(service, body, wish != Wish::Description));
        }
    }
    Ok(answered.response)
}

/// How long all steps of an answer took, as it says.
fn timed(headers: &HeaderMap) -> Option<Duration> {
    let steps = headers.get(SERVER_TIMING)?.to_str().ok()?.split(',');
    let times =
        steps.map(|step| step.split_once("dur=").and_then(|(_, time)| time.trim().parse::<f64>().ok()));
    let all: f64 = times.sum::<Option<f64>>()?;
    Duration::try_from_secs_f64(all / 1e3).ok()
}

/// Keeps the definition of a request that was quick behind: the next one is answered here, if it was solved.
async fn adopt(service: Arc<Service>, body: Received, is_solved: bool) {
    let held = Arc::clone(&service);
    let work = move || {
        let adopted = || {
            let bytes = body.unpacked().ok()?;
            let request = SolveRequest::read(&bytes, &held.compute.settings().request).ok()?;
            let Ok(Located::Here(definition)) = held.compute.locate(&request) else { return None };
            let is_new = held.pace.lane(definition.key()) == Lane::New;
            (is_new && is_solved).then(|| held.pace.is(definition.key(), Lane::Quick))
        };
        Step::Done(adopted())
    };
    let _ = service.pool.run(Client(0), &Cancel::default(), (Clock::Begun, SLICE), work).await;
}

/// Packs what comes out, on the thread that solved it.
fn packed(step: Step<Result<Outcome, Refusal>>, packs: bool) -> Step<Result<Sent, Refusal>> {
    match step {
        Step::Done(Ok(Outcome::Sent(sent))) => Step::Done(Ok(sent.packed(packs))),
        Step::Done(Ok(Outcome::Kept(solved))) => Step::Done(solved.sent(None).map(|sent| sent.packed(packs))),
        Step::Done(Err(refusal)) => Step::Done(Err(refusal)),
        Step::Later(lane, rest) => Step::Later(lane, Box::new(move || packed(rest(), packs))),
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test may fail")]

    use axum::http::HeaderValue;

    use super::*;

    #[test]
    fn times_of_steps_are_added() {
        let told = |text: &str| {
            let value = HeaderValue::from_str(text).unwrap();
            timed(&HeaderMap::from_iter([(SERVER_TIMING, value)]))
        };
        let all = told("decode;dur=0.250, solve;dur=1.500, encode;dur=0.250");
        assert_eq!(all, Some(Duration::from_millis(2)));
        for other in ["", "solve", "solve;dur=x", "solve;dur=-1", "a;dur=1, b"] {
            assert_eq!(told(other), None, "{other}");
        }
        assert_eq!(timed(&HeaderMap::new()), None);
    }
}
