//! Whether the server can do what it is for: a small definition is read, solved and written as any other.

use std::sync::{Arc, OnceLock};
use std::time::{Duration, Instant};

use axum::http::StatusCode;
use katydid_component::{Cancel, Limits};
use katydid_compute::{Bounds, Definition, SolveRequest};
use katydid_definition::kd;
use katydid_session::Registry;

use super::pool::{Client, Clock, Step, Undone};
use super::sent::Sent;
use super::service::Service;

/// Two and three are five.
const SUM: &str = "katydid 1\na = Number Slider(2.0, 0..10)\nsum = Addition(a, 3)\n\"RH_OUT:sum\": sum\n";
/// It takes no longer where all is well, waiting included.
const TIME: Duration = Duration::from_secs(10);

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

/// Solves it, in line with everything else; tells which part fails.
pub(crate) async fn check(service: Arc<Service>) -> Sent {
    let unhealthy = |part: &str, reason: &str| {
        Sent::text(format!("Unhealthy: {part}: {reason}")).with_status(StatusCode::SERVICE_UNAVAILABLE)
    };
    if service.behind.as_ref().is_some_and(|behind| !behind.is_there()) {
        return unhealthy("processes", "the second one is being started");
    }
    let cancel = Cancel::default();
    let (held, inside) = (Arc::clone(&service), cancel.clone());
    let work = move || Step::Done(tried(&held, inside));
    match service.pool.run(Client(0), &cancel, (Clock::Asked, TIME), work).await {
        Ok(Ok(())) => Sent::text("Healthy"),
        Ok(Err((part, reason))) => unhealthy(part, &reason),
        Err(Undone::Full | Undone::Waited) => unhealthy("pool", "too much waits"),
        Err(Undone::Late) => unhealthy("solve", "it does not end"),
        Err(Undone::Failed) => unhealthy("solve", "it failed as it must not"),
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
