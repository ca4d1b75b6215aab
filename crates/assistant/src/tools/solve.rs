//! Solves are begun, followed and cancelled.

use std::time::Duration;

use schemars::JsonSchema;
use serde::Deserialize;
use serde_json::json;

use super::{Does, Entry, Reply, entry};
use crate::fault::Fault;
use crate::store::Store;
use crate::thresholds::{LONGEST_WAIT, USUAL_WAIT};

pub(super) fn entries() -> Vec<Entry> {
    vec![
        entry(
            "solve",
            "Solve",
            "Solves a definition as it stands; only what has changed is solved. Waits some seconds for the end and then tells \
             how the objects came out; a solve that takes longer goes on as a job, and all other tools answer meanwhile: \
             follow it with job_status, end it with cancel_job. Edits during a solve are kept for the next one.",
            Does::Edits,
            solve,
        ),
        entry(
            "job_status",
            "Job status",
            "Tells how a solve stands: running with the objects that are done, done, cancelled or failed. Can wait for its end.",
            Does::Reads,
            status,
        ),
        entry(
            "cancel_job",
            "Cancel job",
            "Cancels the solve of a definition. What was solved until then is kept; the next solve goes on from there.",
            Does::Edits,
            cancel,
        ),
    ]
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct Solve {
    /// The definition's id, as d1; may be left out while only one is open.
    document: Option<String>,
    /// How many seconds to wait for the end, at most 50; 10 when not given, 0 to go on at once.
    wait_seconds: Option<f64>,
    /// Whether everything is solved again, also what has not changed.
    #[serde(default)]
    everything: bool,
}

fn wait(what: &str, seconds: Option<f64>, usual: Duration) -> Result<Duration, Fault> {
    let Some(seconds) = seconds else { return Ok(usual) };
    let wait = Duration::try_from_secs_f64(seconds).ok().filter(|wait| *wait <= LONGEST_WAIT);
    let most = LONGEST_WAIT.as_secs();
    wait.ok_or_else(|| Fault::new(what, "wait_seconds", format!("it goes from 0 to {most}")))
}

fn solve(store: &Store, given: Solve) -> Result<Reply, Fault> {
    const WHAT: &str = "nothing was solved";
    let wait = wait(WHAT, given.wait_seconds, USUAL_WAIT)?;
    let document = store.find(WHAT, given.document.as_deref())?;
    let job = document.solve(|| store.next_job(), given.everything)?;
    Ok(Reply::Waits { document, job, wait, owns: true })
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct Status {
    /// The job's number; the last one of the definition when not given.
    job: Option<u64>,
    /// The definition's id, as d1; may be left out while only one is open.
    document: Option<String>,
    /// How many seconds to wait for the end, at most 50; none when not given.
    wait_seconds: Option<f64>,
}

fn status(store: &Store, given: Status) -> Result<Reply, Fault> {
    const WHAT: &str = "no job was told of";
    let wait = wait(WHAT, given.wait_seconds, Duration::ZERO)?;
    let (document, job) = find(store, WHAT, given.document.as_deref(), given.job)?;
    Ok(Reply::Waits { document, job, wait, owns: false })
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct CancelJob {
    /// The job's number; the one that runs when not given.
    job: Option<u64>,
    /// The definition's id, as d1; may be left out while only one is open.
    document: Option<String>,
}

/// How long a call that cancels waits for the solve to notice.
const NOTICES: Duration = Duration::from_secs(2);

fn cancel(store: &Store, given: CancelJob) -> Result<Reply, Fault> {
    const WHAT: &str = "nothing was cancelled";
    let (document, job) = find(store, WHAT, given.document.as_deref(), given.job)?;
    if !job.is_running() {
        let told = job.told();
        return Err(Fault::new(
            WHAT,
            format!("job {}", job.number),
            format!("it has ended: {}", told["state"]),
        ));
    }
    job.cancel.cancel();
    Ok(Reply::Waits { document, job, wait: NOTICES, owns: false })
}

type Of = (std::sync::Arc<crate::document::Opened>, std::sync::Arc<crate::job::Job>);

/// The job of that number, or the last one of a definition.
fn find(store: &Store, what: &str, document: Option<&str>, number: Option<u64>) -> Result<Of, Fault> {
    if let (Some(number), None) = (number, document) {
        let all = store.all();
        let found = all.into_iter().find_map(|one| {
            let job = one.job().filter(|job| job.number == number)?;
            Some((one, job))
        });
        let why = "there is no such job: of each definition the last one is known";
        return found.ok_or_else(|| Fault::new(what, format!("job {number}"), why));
    }
    let document = store.find(what, document)?;
    let job =
        document.job().ok_or_else(|| Fault::new(what, &document.id, "it was never solved: call solve"))?;
    if number.is_some_and(|number| number != job.number) {
        let why = json!(format!("the last job of {} is {}", document.id, job.number));
        return Err(Fault::new(
            what,
            format!("job {}", number.unwrap_or_default()),
            why.as_str().unwrap_or_default(),
        ));
    }
    Ok((document, job))
}
