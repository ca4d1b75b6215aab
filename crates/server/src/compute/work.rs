//! A solve from the bytes of a request to those of the answer, as a solving thread does it.

use std::sync::Arc;
use std::time::{Duration, Instant};

use katydid_3dm::Model;
use katydid_component::{Account, Cancel, Limits};
use katydid_compute::{
    Bounds, CacheControl, Cause, Definition, Fault, Located, Solution, SolveRequest, Timings,
};
use katydid_solver::Listener;

use super::body::Received;
use super::form::Form;
use super::pool::{Lane, Step};
use super::query::Query;
use super::refusal::Refusal;
use super::sent::{CACHE_STATUS, JSON, Sent};
use super::service::Service;
use axum::http::StatusCode;

/// What a request may use; it may ask for less than the server allows, never for more.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Allowance {
    pub(crate) time: Duration,
    pub(crate) items: u64,
    pub(crate) bytes: u64,
}

impl Allowance {
    pub(crate) fn new(time: Duration, limits: Limits, query: &Query) -> Result<Self, Refusal> {
        let seconds = match query.get("seconds") {
            None => None,
            Some(text) => {
                let seconds: Option<f64> = text.parse().ok();
                let time = seconds.and_then(|seconds| Duration::try_from_secs_f64(seconds).ok());
                Some(time.ok_or_else(|| Refusal::bad("seconds is a number that is not below 0"))?)
            }
        };
        let count = |name: &str, most: u64| match query.get(name) {
            None => Ok(most),
            Some(text) => {
                let count: Result<u64, _> = text.parse();
                count.map(|n| n.min(most)).map_err(|_| Refusal::bad(format!("{name} is a whole number")))
            }
        };
        Ok(Self {
            time: seconds.map_or(time, |seconds| seconds.min(time)),
            items: count("items", limits.items)?,
            bytes: count("bytes", limits.bytes)?,
        })
    }
}

/// How a solve is followed and stopped.
#[derive(Clone)]
pub(crate) struct Reins {
    pub(crate) cancel: Cancel,
    pub(crate) progress: Option<Listener>,
    pub(crate) allowance: Allowance,
    /// What may be taken from earlier requests and left for later ones.
    pub(crate) cache: CacheControl,
    /// What counts its memory.
    pub(crate) memory: Arc<Account>,
    /// When its time is over.
    pub(crate) end: Option<Instant>,
}

impl Reins {
    pub(crate) fn bounds(&self) -> Result<Bounds, Refusal> {
        let time = self.end.map(|end| end.saturating_duration_since(Instant::now()));
        if time.is_some_and(|time| time.is_zero()) {
            return Err(self.late());
        }
        let Allowance { items, bytes, .. } = self.allowance;
        let limits = Limits { items, time, ..Limits::default() }.with_bytes(bytes);
        let (cancel, progress) = (self.cancel.clone(), self.progress.clone());
        Ok(Bounds { limits, memory: Some(Arc::clone(&self.memory)), cancel, progress, recursion: 0 })
    }

    /// Whether its time is over.
    pub(crate) fn is_late(&self) -> bool {
        self.end.is_some_and(|end| Instant::now() >= end)
    }

    pub(crate) fn late(&self) -> Refusal {
        let seconds = self.allowance.time.as_secs_f64();
        Refusal::late(format!("the time limit of {seconds} seconds is over"))
    }

    /// A fault in the words of whoever set the limits: what the solver was told is what was left of the time.
    pub(crate) fn refusal(&self, fault: Fault) -> Refusal {
        match fault.cause {
            Cause::TimedOut => self.late(),
            _ => fault.into(),
        }
    }
}

/// What shall come out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Wish {
    /// What the definition asks for and gives.
    Description,
    /// The reply, or a file.
    Results(Option<Form>),
    /// The results as they are, to be asked for later.
    Kept,
}

/// What came out.
#[derive(Debug)]
pub(crate) enum Outcome {
    Sent(Sent),
    Kept(Box<Solved>),
}

/// Results that are kept: what the outputs gave, and nothing of what was on the way there.
#[derive(Debug)]
pub(crate) struct Solved {
    /// What it takes is counted here for as long as it is there.
    memory: Arc<Account>,
    reply: Sent,
    model: Model,
    has_errors: bool,
    version: i32,
    timings: Timings,
}

impl Solved {
    fn new(solution: &Solution, version: i32, decode: Duration, memory: Arc<Account>) -> Self {
        let timings = solution.timings();
        let timings = Timings { decode: decode + timings.decode, ..timings };
        let has_errors = solution.has_errors();
        let reply = Sent::json(&solution.reply()).with_status(status(has_errors));
        Self { memory, reply, model: solution.model(), has_errors, version, timings }
    }

    /// The reply, or a file.
    pub(crate) fn sent(&self, form: Option<Form>) -> Result<Sent, Refusal> {
        let start = Instant::now();
        let sent = match form {
            Some(form) if !self.has_errors => form.write(&self.model, self.version)?,
            _ => self.reply.clone(),
        };
        Ok(timed(sent, Timings { encode: start.elapsed(), ..self.timings }))
    }

    pub(crate) fn has_errors(&self) -> bool {
        self.has_errors
    }

    /// The bytes that it takes.
    pub(crate) fn weight(&self) -> u64 {
        self.memory.bytes()
    }
}

/// A component's error makes the whole answer one, though it is there: clients know it so.
fn status(has_errors: bool) -> StatusCode {
    if has_errors { StatusCode::INTERNAL_SERVER_ERROR } else { StatusCode::OK }
}

fn timed(sent: Sent, timings: Timings) -> Sent {
    let Timings { decode, solve, encode } = timings;
    sent.timed(&[("decode", decode), ("solve", solve), ("encode", encode)])
}

type Came = Result<Outcome, Refusal>;

/// Reads the request and solves it there and then, when its definition is kept and known to be quick. What is large, or
/// has to be read or fetched first, waits with what is new.
pub(crate) fn begin(service: Arc<Service>, body: Received, wish: Wish, reins: Reins) -> Step<Came> {
    if body.is_large() {
        return Step::Later(Lane::New, Box::new(move || read(service, body, wish, reins)));
    }
    read(service, body, wish, reins)
}

fn read(service: Arc<Service>, body: Received, wish: Wish, reins: Reins) -> Step<Came> {
    let start = Instant::now();
    let read = || {
        let bytes = body.unpacked()?;
        Ok(SolveRequest::read(&bytes, &service.compute.settings().request)?)
    };
    let request = match read() {
        Ok(request) => request,
        Err(refusal) => return Step::Done(Err(refusal)),
    };
    with_request(service, request, wish, reins, start)
}

/// The same for a request that has been read.
pub(crate) fn with_request(
    service: Arc<Service>,
    request: SolveRequest,
    wish: Wish,
    reins: Reins,
    start: Instant,
) -> Step<Came> {
    let request = SolveRequest { cache: reins.cache, ..request };
    let kept = service.compute.at_hand(&request);
    let lane = match &kept {
        None => Lane::New,
        Some(_) if wish == Wish::Description => Lane::Quick,
        Some(definition) => match service.pace.lane(definition.key()) {
            // Another solve waits for this one, maybe one of ours: it must not stand behind it.
            Lane::Slow if request.recursion_level > 0 => Lane::New,
            lane => lane,
        },
    };
    let decode = start.elapsed();
    let rest = move || Step::Done(came(&service, kept, &request, wish, &reins, decode));
    match lane {
        Lane::Quick => rest(),
        lane => Step::Later(lane, Box::new(rest)),
    }
}

fn came(
    service: &Service,
    kept: Option<Arc<Definition>>,
    request: &SolveRequest,
    wish: Wish,
    reins: &Reins,
    decode: Duration,
) -> Came {
    let start = Instant::now();
    let definition = kept.map_or_else(|| definition(service, request, reins), Ok)?;
    if wish == Wish::Description {
        return Ok(Outcome::Sent(Sent::json(&*service.compute.describe(&definition))));
    }
    solve(service, &definition, request, wish, reins, decode + start.elapsed())
}

fn definition(service: &Service, request: &SolveRequest, reins: &Reins) -> Result<Arc<Definition>, Refusal> {
    match service.compute.locate(request)? {
        Located::Here(definition) => Ok(definition),
        Located::Url(url) => {
            let time = reins.end.map(|end| end.saturating_duration_since(Instant::now()));
            let fetched = service.compute.fetch(&url, time, &reins.cancel, reins.cache);
            match (fetched, request.algo.as_deref().filter(|algo| !algo.trim().is_empty())) {
                (Ok(definition), _) => Ok(definition),
                // What cannot be fetched may have been sent along.
                (Err(_), Some(algo)) => Ok(service.compute.load_with(algo, reins.cache)?),
                (Err(fault), None) => Err(fault.into()),
            }
        }
    }
}

fn solve(
    service: &Service,
    definition: &Arc<Definition>,
    request: &SolveRequest,
    wish: Wish,
    reins: &Reins,
    decode: Duration,
) -> Came {
    let bounds = reins.bounds()?;
    service.idle.touch();
    let start = Instant::now();
    let came = solved(service, definition, request, wish, reins, &bounds, decode);
    service.solved(Some(definition.key()), start.elapsed(), came.as_ref().err());
    came
}

fn solved(
    service: &Service,
    definition: &Arc<Definition>,
    request: &SolveRequest,
    wish: Wish,
    reins: &Reins,
    bounds: &Bounds,
    decode: Duration,
) -> Came {
    if definition.interface().outputs.is_empty() {
        return Err(Refusal::bad(
            "the definition has no outputs: it needs a Context Bake, a Context Print or a group called RH_OUT:name",
        ));
    }
    if wish == Wish::Results(None) {
        let answer = service.compute.answer(definition, request, bounds);
        let answer = answer.map_err(|fault| reins.refusal(fault))?;
        let timings = Timings { decode: decode + answer.timings.decode, ..answer.timings };
        let body = bytes::Bytes::from_owner(answer.body);
        let mut sent = Sent::new(JSON, body).with_status(status(answer.has_errors));
        if answer.kept {
            sent = sent.with(CACHE_STATUS, "katydid; hit");
        }
        return Ok(Outcome::Sent(timed(sent, timings)));
    }
    let solution = service.compute.solve(definition, request, bounds);
    let solution = solution.map_err(|fault| reins.refusal(fault))?;
    let solved = Solved::new(&solution, request.archive(), decode, Arc::clone(&reins.memory));
    match wish {
        Wish::Results(form) => solved.sent(form).map(Outcome::Sent),
        _ => Ok(Outcome::Kept(Box::new(solved))),
    }
}
