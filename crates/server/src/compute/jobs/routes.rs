//! `/jobs` and what is below it.

use std::sync::Arc;

use axum::http::StatusCode;
use katydid_component::Cancel;
use katydid_compute::CacheControl;
use katydid_solver::Progress;

use super::super::body::Received;
use super::super::form::Form;
use super::super::memory::counted;
use super::super::pool::{Client, Clock, Step, Undone};
use super::super::query::Query;
use super::super::refusal::Refusal;
use super::super::sent::Sent;
use super::super::service::Service;
use super::super::work::{self, Allowance, Outcome, Reins, Solved, Wish};
use super::{Job, Stage};

/// Takes a job: the body is that of `/grasshopper`.
pub(crate) async fn submit(
    service: Arc<Service>,
    client: Client,
    query: &Query,
    cache: CacheControl,
    body: Received,
) -> Result<Sent, Refusal> {
    let allowance = Allowance::new(service.config.job_timeout, service.config.limits, query)?;
    let job = service.jobs.add()?;
    let answer = Sent::json(&job.about(&Stage::Waiting));
    let place = format!("/jobs/{}", job.id);
    tokio::spawn(run(service, client, Arc::clone(&job), body, allowance, cache));
    Ok(answer.with_status(StatusCode::ACCEPTED).at(&place))
}

/// Sees a job through.
async fn run(
    service: Arc<Service>,
    client: Client,
    job: Arc<Job>,
    body: Received,
    allowance: Allowance,
    cache: CacheControl,
) {
    let (own, held) = (Arc::clone(&job), Arc::clone(&service));
    let cancel: Cancel = job.cancel.clone();
    let memory = service.memory.account(allowance.bytes);
    let work = move || {
        let told = Arc::clone(&own);
        let progress = move |progress: &Progress| {
            let Progress { done, total, name } = progress.clone();
            told.go_on(Stage::Running { done, total, name });
        };
        own.go_on(Stage::Running { done: 0, total: 0, name: String::new() });
        let end = std::time::Instant::now().checked_add(allowance.time);
        let cancel = own.cancel.clone();
        let reins = Reins { cancel, progress: Some(Arc::new(progress)), allowance, cache, memory, end };
        counted(reins.clone(), move || kept(work::begin(held, body, Wish::Kept, reins)))
    };
    let solve = service.pool.run(client, &cancel, (Clock::Begun, allowance.time), work);
    // Who cancels a job takes it out of the line, or has its thread given up if it does not stop.
    let came = tokio::select! {
        came = solve => came,
        () = job.cancelled() => return,
    };
    job.go_on(match came {
        Ok(Ok(solved)) => Stage::Done(solved),
        Ok(Err(refusal)) => Stage::Failed(refusal),
        Err(Undone::Waited | Undone::Late) => Stage::Failed(Undone::Late.into()),
        Err(undone) => Stage::Failed(undone.into()),
    });
    service.jobs.sweep();
}

fn kept(step: Step<Result<Outcome, Refusal>>) -> Step<Result<Arc<Solved>, Refusal>> {
    match step {
        Step::Done(Ok(Outcome::Kept(solved))) => Step::Done(Ok(Arc::from(solved))),
        Step::Done(Ok(Outcome::Sent(_))) => Step::Done(Err(Undone::Failed.into())),
        Step::Done(Err(refusal)) => Step::Done(Err(refusal)),
        Step::Later(lane, rest) => Step::Later(lane, Box::new(move || kept(rest()))),
    }
}

/// How far a job is.
pub(crate) fn about(service: &Service, id: &str) -> Result<Sent, Refusal> {
    let job = service.jobs.get(id)?;
    let stage = job.stage.borrow().clone();
    Ok(Sent::json(&job.about(&stage)))
}

/// What came of a job, as `/grasshopper` would have answered, or as a file.
pub(crate) async fn result(
    service: &Service,
    client: Client,
    id: &str,
    query: &Query,
    packs: bool,
) -> Result<Sent, Refusal> {
    let form = Form::named(query.get("format").unwrap_or_default())?;
    let job = service.jobs.get(id)?;
    let stage = job.stage.borrow().clone();
    match stage {
        Stage::Waiting | Stage::Running { .. } => {
            Ok(Sent::json(&job.about(&stage)).with_status(StatusCode::ACCEPTED))
        }
        Stage::Failed(refusal) => Err(refusal),
        Stage::Cancelled => Err(Refusal::new(StatusCode::GONE, "cancelled", "the job was cancelled")),
        Stage::Done(solved) => {
            let allowance = Allowance::new(service.config.timeout, service.config.limits, query)?;
            let memory = service.memory.account(allowance.bytes);
            let end = std::time::Instant::now().checked_add(allowance.time);
            let (cancel, counting) = (Cancel::default(), Arc::clone(&memory));
            let cache = CacheControl::Allowed;
            let reins =
                Reins { cancel: cancel.clone(), progress: None, allowance, cache, memory: counting, end };
            let write = move || Step::Done(solved.sent(form).map(|sent| sent.packed(packs)));
            let clock = (Clock::Asked, allowance.time);
            let sent = service.pool.run(client, &cancel, clock, move || counted(reins, write)).await??;
            Ok(sent.counted(memory))
        }
    }
}

/// Stops a job, if it still runs; one that is over is forgotten, with its result.
pub(crate) fn cancel(service: &Service, id: &str) -> Result<Sent, Refusal> {
    let job = service.jobs.get(id)?;
    if job.age().is_some() {
        service.jobs.forget(id);
    }
    job.cancel.cancel();
    job.go_on(Stage::Cancelled);
    let stage = job.stage.borrow().clone();
    Ok(Sent::json(&job.about(&stage)))
}
