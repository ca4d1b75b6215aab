//! Whether the server can do what it is for: a small definition is read, solved and written as any other.
//!
//! It is told within two seconds, and what is busy is told from what is stuck: work that has time left is busy, work that
//! was told to stop and does not is stuck.

mod told;

use std::sync::{Arc, OnceLock};
use std::time::{Duration, Instant};

use katydid_component::{Cancel, Limits};
use katydid_compute::{Bounds, Definition, SolveRequest};
use katydid_definition::kd;
use katydid_session::Registry;
use tokio::time::timeout;

use super::behind::Behind;
use super::pool::{Client, Clock, Step, Undone};
use super::query::Query;
use super::sent::Sent;
use super::service::Service;
use told::Health;

/// Two and three are five.
const SUM: &str = "katydid 1\na = Number Slider(2.0, 0..10)\nsum = Addition(a, 3)\n\"RH_OUT:sum\": sum\n";
/// It takes no longer where all is well, waiting included. What does not heed that is given up a little later.
const TIME: Duration = Duration::from_secs(1);
/// The process behind has so long to say how it is.
const BEHIND: Duration = Duration::from_millis(1900);

/// The definition that is tried, in the form that clients send.
#[derive(Debug, Default)]
pub(crate) struct Trial(OnceLock<Result<Vec<u8>, String>>);

impl Trial {
    fn bytes(&self) -> Result<&[u8], String> {
        self.0.get_or_init(written).as_deref().map_err(Clone::clone)
    }
}

fn written() -> Result<Vec<u8>, String> {
    let definition = kd::read(SUM, &Registry).map_err(|problems| problems.to_string())?;
    definition.document.to_gh().map_err(|error| error.to_string())
}

/// How the server is: the worse of what this process and the one behind are.
pub(crate) async fn check(service: Arc<Service>, query: &Query) -> Sent {
    let (own, other) = tokio::join!(own(&service), other(service.behind.as_ref()));
    let health = own.worse(other);
    let is_json = query.get("format").is_some_and(|format| format.eq_ignore_ascii_case("json"));
    if is_json { health.json(service.pool.load()) } else { health.text() }
}

/// How this process is.
async fn own(service: &Arc<Service>) -> Health {
    let load = service.pool.load();
    if load.stuck > 0 {
        return Health::stuck(load.stuck);
    }
    let cancel = Cancel::default();
    let (held, inside) = (Arc::clone(service), cancel.clone());
    let work = move || Step::Done(tried(&held, inside));
    match service.pool.run(Client(0), &cancel, (Clock::Asked, TIME), work).await {
        Ok(Ok(())) => Health::Healthy,
        Ok(Err((part, reason))) => Health::unhealthy(part, &reason),
        Err(Undone::Full | Undone::Waited) => Health::busy(service.pool.load()),
        Err(Undone::Late) => Health::unhealthy("solve", "it does not end"),
        Err(Undone::Failed) => Health::unhealthy("solve", "it failed as it must not"),
    }
}

/// How the process behind is, if there is one.
async fn other(behind: Option<&Behind>) -> Health {
    let Some(behind) = behind else { return Health::Healthy };
    if !behind.is_there() {
        return Health::unhealthy("processes", "the second one is being started");
    }
    match timeout(BEHIND, behind.text("/healthcheck")).await {
        Ok(Some(text)) => Health::read(&text),
        // It has a lower priority: where others take all processors, it is slow to answer, and still does.
        _ if behind.is_slow(BEHIND) => Health::Busy("the second process answers slowly".to_owned()),
        _ => Health::unhealthy("processes", "the second one does not answer"),
    }
}

fn tried(service: &Service, cancel: Cancel) -> Result<(), (&'static str, String)> {
    let bytes = service.trial.bytes().map_err(|reason| ("definition", reason))?;
    let definition = read(service, bytes).map_err(|reason| ("read", reason))?;
    let limits = Limits { time: Some(TIME), ..Limits::default() };
    let bounds = Bounds { limits, cancel, ..Bounds::default() };
    let request = SolveRequest::default();
    let start = Instant::now();
    let solution = service.compute.solve(&definition, &request, &bounds);
    let solution = solution.map_err(|fault| ("solve", fault.message))?;
    if solution.has_errors() {
        return Err(("solve", "a component reports an error".to_owned()));
    }
    let text = serde_json::to_string(&solution.reply()).map_err(|error| ("encode", error.to_string()))?;
    if !text.contains("\"data\":\"5.0\"") {
        return Err(("solve", "two and three are not five".to_owned()));
    }
    tracing::debug!(ms = start.elapsed().as_secs_f64() * 1e3, "the health check solved");
    Ok(())
}

fn read(service: &Service, bytes: &[u8]) -> Result<Arc<Definition>, String> {
    service.compute.load_bytes("healthcheck".to_owned(), bytes).map_err(|fault| fault.message)
}
