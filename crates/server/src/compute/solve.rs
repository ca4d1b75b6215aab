//! `/grasshopper` and `/io`.

use std::sync::Arc;
use std::time::{Duration, Instant};

use katydid_component::Cancel;
use katydid_compute::SolveRequest;

use super::body::Received;
use super::form::Form;
use super::memory::counted;
use super::pool::{Client, Clock, Step};
use super::query::Query;
use super::refusal::Refusal;
use super::sent::Sent;
use super::service::Service;
use super::work::{self, Allowance, Outcome, Reins, Wish};

/// A request that is waited for.
pub(crate) struct Asking {
    pub(crate) client: Client,
    pub(crate) query: Query,
    /// Whether the client takes gzip.
    pub(crate) packs: bool,
    /// When it came.
    pub(crate) since: Instant,
}

impl Asking {
    pub(crate) fn reins(&self, service: &Service) -> Result<Reins, Refusal> {
        let allowance = Allowance::new(service.config.timeout, service.config.limits, &self.query)?;
        let end = self.since.checked_add(allowance.time);
        let memory = service.memory.account(allowance.bytes);
        Ok(Reins { cancel: Cancel::default(), progress: None, allowance, memory, end })
    }

    /// What is left of the time.
    pub(crate) fn clock(&self, reins: &Reins) -> (Clock, Duration) {
        (Clock::Asked, reins.allowance.time.saturating_sub(self.since.elapsed()))
    }
}

/// Solves a definition.
pub(crate) async fn grasshopper(
    service: Arc<Service>,
    asking: Asking,
    body: Received,
) -> Result<Sent, Refusal> {
    let form = Form::named(asking.query.get("format").unwrap_or_default())?;
    waited(service, asking, body, Wish::Results(form)).await
}

/// Tells what a definition asks for and gives.
pub(crate) async fn io(service: Arc<Service>, asking: Asking, body: Received) -> Result<Sent, Refusal> {
    waited(service, asking, body, Wish::Description).await
}

/// The same for a definition that is named in the address.
pub(crate) async fn io_of_pointer(service: Arc<Service>, asking: Asking) -> Result<Sent, Refusal> {
    let pointer = asking.query.get("pointer").filter(|pointer| !pointer.is_empty());
    let pointer = pointer.ok_or_else(|| Refusal::bad("GET /io needs a Pointer query parameter."))?;
    let request = SolveRequest::for_pointer(pointer);
    let (reins, packs) = (asking.reins(&service)?, asking.packs);
    let (inside, held) = (reins.clone(), Arc::clone(&service));
    let begin =
        move || packed(work::with_request(held, request, Wish::Description, inside, Instant::now()), packs);
    let counting = reins.clone();
    let work = move || counted(counting, begin);
    service.pool.run(asking.client, &reins.cancel, asking.clock(&reins), work).await?
}

async fn waited(service: Arc<Service>, asking: Asking, body: Received, wish: Wish) -> Result<Sent, Refusal> {
    let (reins, packs) = (asking.reins(&service)?, asking.packs);
    let (inside, held) = (reins.clone(), Arc::clone(&service));
    let counting = reins.clone();
    let work = move || counted(counting, move || packed(work::begin(held, body, wish, inside), packs));
    let sent = service.pool.run(asking.client, &reins.cancel, asking.clock(&reins), work).await??;
    Ok(sent.counted(reins.memory))
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
