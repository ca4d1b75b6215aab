//! The process behind.
//!
//! A server that solves what anybody sends cannot know what it will take. So it is two processes: the one in front takes
//! requests and answers what is known to be quick; all else it sends to the one behind, which is the same server with a
//! lower priority, and can be asked by the one in front only. What takes all processors or much memory there does not hold
//! up who asks for a small thing, and what ends that process does not end the server: another is started.
//!
//! As long as quick things are asked for, the process behind keeps off one processor: a thread that is interrupted in the
//! middle of a large copy, or in the system, lets others wait for milliseconds, whatever its priority.
//!
//! In front, work has a slice of time and a share of memory. What needs more is given up and done behind.

mod answered;
mod orders;
mod process;
mod processors;

use std::net::SocketAddr;
use std::time::{Duration, Instant};

use axum::body::Body;
use axum::http::header::{
    ACCEPT_ENCODING, CACHE_CONTROL, CONTENT_ENCODING, CONTENT_TYPE, HeaderName, HeaderValue, PRAGMA,
};
use axum::http::{HeaderMap, Method, Request, Uri};
use axum::response::Response;
use bytes::Bytes;
use hyper_util::client::legacy::Client;
use hyper_util::client::legacy::connect::HttpConnector;
use hyper_util::rt::TokioExecutor;
use tokio::sync::watch;
use tokio::task::JoinHandle;
use tokio::time::timeout;

use super::refusal::Refusal;
use answered::{Answered, wants_processor};
use process::{Place, Process, keep};
use processors::Processors;

pub use orders::{Command, Orders};

/// How many microseconds of its time a request has had already. Only the process behind believes it.
pub(crate) const WAITED: HeaderName = HeaderName::from_static("katydid-waited");
/// What takes longer in front is given up there and done behind.
pub(crate) const IN_FRONT: Duration = Duration::from_millis(50);
const KEY: HeaderName = HeaderName::from_static("rhinocomputekey");
const CLIENT: HeaderName = HeaderName::from_static("x-forwarded-for");
/// How long a request waits for the process to be there again.
const AGAIN: Duration = Duration::from_secs(5);
/// It refuses in time itself; if it does not, it is no longer waited for after so much more.
const MORE: Duration = Duration::from_secs(2);
/// What of a request is sent on: the rest was for the one in front.
const SENT_ON: [HeaderName; 5] = [CONTENT_TYPE, CONTENT_ENCODING, ACCEPT_ENCODING, CACHE_CONTROL, PRAGMA];

/// The process behind, as the one in front knows it.
pub(crate) struct Behind {
    client: Client<HttpConnector, Body>,
    key: HeaderValue,
    at: watch::Receiver<Option<Place>>,
    processors: Processors,
    answered: Answered,
    stop: watch::Sender<bool>,
    keeping: tokio::sync::Mutex<Option<JoinHandle<()>>>,
}

/// A request that is sent on, without its body.
#[derive(Debug, Clone)]
pub(crate) struct Head {
    pub(crate) method: Method,
    /// The path and the query.
    pub(crate) uri: Uri,
    pub(crate) headers: HeaderMap,
    /// Who takes turns with others.
    pub(crate) client: u64,
    /// When it came.
    pub(crate) since: Instant,
}

impl Behind {
    /// Starts the process for a server that listens at `front`, and waits until it listens too.
    ///
    /// # Errors
    /// It cannot be started.
    pub(crate) async fn start(command: Command, front: SocketAddr) -> std::io::Result<Self> {
        let orders = Orders::new(front);
        let key = HeaderValue::from_str(orders.key()).map_err(std::io::Error::other)?;
        let process = Process::start(&command, &orders).await?;
        let (place, at) = watch::channel(Some(process.place()));
        let (stop, stopped) = watch::channel(false);
        let processors = Processors::of(at.clone());
        let keeping = tokio::spawn(keep(process, command, orders, place, stopped));
        let mut connector = HttpConnector::new();
        connector.set_nodelay(true);
        let client = Client::builder(TokioExecutor::new()).build(connector);
        let (answered, keeping) = (Answered::now(), tokio::sync::Mutex::new(Some(keeping)));
        Ok(Self { client, key, at, processors, answered, stop, keeping })
    }

    /// Whether it is there.
    pub(crate) fn is_there(&self) -> bool {
        self.at.borrow().is_some()
    }

    /// Whether it is only slow to answer whoever has just waited so long in vain: it has answered somebody meanwhile, or
    /// gets no processor, and that not for too long.
    pub(crate) fn is_slow(&self, waited: Duration) -> bool {
        const TOO_LONG: Duration = Duration::from_secs(30);
        let waits = || self.at.borrow().and_then(|at| at.process).is_some_and(wants_processor);
        self.answered.since() < waited || (self.answered.missed() < TOO_LONG && waits())
    }

    /// Notes that something quick was answered in front: as long as that goes on, the process behind leaves a
    /// processor free.
    pub(crate) fn was_quick_in_front(&self) {
        self.processors.one_is_wanted();
    }

    /// Ends it.
    pub(crate) async fn stop(&self) {
        let _ = self.stop.send(true);
        if let Some(keeping) = self.keeping.lock().await.take() {
            let _ = keeping.await;
        }
    }

    /// Sends a request on and gives the answer as it comes. It may take so long, counted from when it came, if that
    /// is given.
    ///
    /// # Errors
    /// The process is not there, ends, or does not answer in time.
    pub(crate) async fn ask(
        &self,
        head: &Head,
        body: Bytes,
        time: Option<Duration>,
    ) -> Result<Response, Refusal> {
        let again = time.map_or(AGAIN, |time| AGAIN.min(time.saturating_sub(head.since.elapsed())));
        let mut at = self.at.clone();
        let Ok(Ok(place)) =
            timeout(again, at.wait_for(Option::is_some)).await.map(|found| found.map(|at| *at))
        else {
            return Err(lost());
        };
        let request = self.request(head, place.ok_or_else(lost)?.address, body).ok_or_else(lost)?;
        let asked = self.client.request(request);
        let answered = match time {
            None => asked.await,
            Some(time) => {
                let left = time.saturating_sub(head.since.elapsed()).saturating_add(MORE);
                let late = |_| Refusal::late("the time that a request may take is over");
                timeout(left, asked).await.map_err(late)?
            }
        };
        let (parts, body) = answered.map_err(|_| lost())?.into_parts();
        self.answered.touch();
        let mut response = Response::new(Body::new(body));
        *response.status_mut() = parts.status;
        *response.headers_mut() = parts.headers;
        Ok(response)
    }

    /// What is at an address there, if it is a text, whatever the status.
    pub(crate) async fn text(&self, path: &'static str) -> Option<String> {
        const SOON: Duration = Duration::from_secs(2);
        const MOST: usize = 1 << 20;
        let head = Head {
            method: Method::GET,
            uri: Uri::from_static(path),
            headers: HeaderMap::new(),
            client: 0,
            since: Instant::now(),
        };
        let text = async {
            let response = self.ask(&head, Bytes::new(), Some(SOON)).await.ok()?;
            let body = axum::body::to_bytes(response.into_body(), MOST).await.ok()?;
            String::from_utf8(body.into()).ok()
        };
        timeout(SOON, text).await.ok()?
    }

    fn request(&self, head: &Head, place: SocketAddr, body: Bytes) -> Option<Request<Body>> {
        let path = head.uri.path_and_query().map_or("/", |path| path.as_str());
        let uri =
            Uri::builder().scheme("http").authority(place.to_string()).path_and_query(path).build().ok()?;
        let mut request = Request::new(Body::from(body));
        *request.method_mut() = head.method.clone();
        *request.uri_mut() = uri;
        let headers = request.headers_mut();
        for name in SENT_ON {
            if let Some(value) = head.headers.get(&name) {
                headers.insert(name, value.clone());
            }
        }
        headers.insert(KEY, self.key.clone());
        headers.insert(CLIENT, HeaderValue::from(head.client));
        let waited = u64::try_from(head.since.elapsed().as_micros()).unwrap_or(u64::MAX);
        headers.insert(WAITED, HeaderValue::from(waited));
        Some(request)
    }
}

fn lost() -> Refusal {
    Refusal::busy("what was worked on beside this ended the process: try again", 1)
}

/// Asks for short turns on a processor: what is answered in front is short. For the process in front, before it starts a
/// thread.
pub fn stand_in_front() {
    katydid_priority::take_short_turns();
}

/// Lowers the priority of this process, and makes it the first that the system ends when memory is short. For the
/// process behind, before it starts a thread.
pub fn stand_behind() {
    katydid_priority::lower();
    // The one in front, which has started it, has short ones.
    katydid_priority::take_usual_turns();
    #[cfg(target_os = "linux")]
    let _ = std::fs::write("/proc/self/oom_score_adj", "500");
}

/// The microseconds that a request has waited already.
pub(crate) fn waited(headers: &HeaderMap) -> Duration {
    let told = headers.get(WAITED).and_then(|waited| waited.to_str().ok()?.parse().ok());
    Duration::from_micros(told.unwrap_or(0))
}
