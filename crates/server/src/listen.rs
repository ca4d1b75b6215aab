//! The loop that takes connections and serves them: the studio's and the compute server's alike.

use std::net::SocketAddr;
use std::sync::Arc;
use std::sync::atomic::Ordering;
use std::time::Duration;

use axum::Router;
use axum::body::Body;
use axum::extract::Request;
use axum::http::StatusCode;
use axum::http::header::{CONNECTION, CONTENT_TYPE};
use axum::response::{IntoResponse, Response};
use hyper::service::service_fn;
use hyper_util::rt::{TokioIo, TokioTimer};
use tokio::net::{TcpListener, TcpStream};
use tokio::sync::{Semaphore, watch};
use tokio::task::JoinHandle;
use tower_service::Service;

use crate::Error;
use crate::framing::Followed;

/// So many connections at a time.
const MOST_CONNECTIONS: u32 = 1024;
/// A request's head must be here after so long.
const HEAD_TIME: Duration = Duration::from_secs(15);
/// And has no more bytes.
const HEAD_BYTES: usize = 64 << 10;

/// Who is at the other end of the connection: every request brings it along.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Peer(pub(crate) SocketAddr);

/// A port that is listened on.
#[derive(Debug)]
pub(crate) struct Listening {
    address: SocketAddr,
    stop: watch::Sender<bool>,
    task: JoinHandle<()>,
    /// A place for each connection.
    room: Arc<Semaphore>,
}

/// Takes the port without answering on it yet.
///
/// # Errors
/// Somebody else has it, or the machine has no such address.
pub(crate) async fn bind(wanted: SocketAddr) -> Result<(TcpListener, SocketAddr), Error> {
    let fail = |source| Error::Listen { address: wanted, source };
    let listener = TcpListener::bind(wanted).await.map_err(fail)?;
    let address = listener.local_addr().map_err(fail)?;
    Ok((listener, address))
}

/// The address as a browser of this machine writes it.
pub(crate) fn url(address: SocketAddr, query: &str) -> String {
    let host = match address {
        SocketAddr::V4(v4) if v4.ip().is_unspecified() => "127.0.0.1".to_owned(),
        SocketAddr::V6(v6) if v6.ip().is_unspecified() => "[::1]".to_owned(),
        SocketAddr::V4(v4) => v4.ip().to_string(),
        SocketAddr::V6(v6) => format!("[{}]", v6.ip()),
    };
    let query = if query.is_empty() { String::new() } else { format!("?{query}") };
    format!("http://{host}:{}/{query}", address.port())
}

impl Listening {
    /// Serves who comes. Connections that are busy when it stops have `grace` to end.
    pub(crate) fn start(listener: TcpListener, address: SocketAddr, router: Router, grace: Duration) -> Self {
        let (stop, stopped) = watch::channel(false);
        let room = Arc::new(Semaphore::new(MOST_CONNECTIONS as usize));
        let task = tokio::spawn(accept(listener, router, stopped, Arc::clone(&room), grace));
        Self { address, stop, task, room }
    }

    pub(crate) fn address(&self) -> SocketAddr {
        self.address
    }

    /// Takes nobody in any more.
    pub(crate) fn close(&self) {
        let _ = self.stop.send(true);
    }

    /// Waits until every connection has ended, but no longer than `at_most`.
    pub(crate) async fn ended(self, at_most: Duration) {
        let all = async {
            let _ = self.task.await;
            let _ = self.room.acquire_many(MOST_CONNECTIONS).await;
        };
        let _ = tokio::time::timeout(at_most, all).await;
    }
}

async fn accept(
    listener: TcpListener,
    router: Router,
    mut stopped: watch::Receiver<bool>,
    room: Arc<Semaphore>,
    grace: Duration,
) {
    loop {
        let (stream, peer) = tokio::select! {
            accepted = listener.accept() => match accepted {
                Ok(accepted) => accepted,
                // Too many files are open, as a rule: some will be closed soon.
                Err(_) => {
                    tokio::time::sleep(Duration::from_millis(50)).await;
                    continue;
                }
            },
            _ = stopped.changed() => return,
        };
        let Ok(permit) = Arc::clone(&room).try_acquire_owned() else { continue };
        let (router, stopped) = (router.clone(), stopped.clone());
        tokio::spawn(async move {
            serve(stream, Peer(peer), router, stopped, grace).await;
            drop(permit);
        });
    }
}

async fn serve(
    stream: TcpStream,
    peer: Peer,
    router: Router,
    mut stopped: watch::Receiver<bool>,
    grace: Duration,
) {
    let _ = stream.set_nodelay(true);
    let (stream, is_doubtful) = Followed::new(stream);
    let service = service_fn(move |mut request: hyper::Request<hyper::body::Incoming>| {
        request.extensions_mut().insert(peer);
        let request: Request = request.map(Body::new);
        let answer = (!is_doubtful.load(Ordering::Acquire)).then(|| router.clone().call(request));
        async move {
            match answer {
                Some(answer) => answer.await,
                None => Ok(doubtful()),
            }
        }
    });
    let mut builder = hyper::server::conn::http1::Builder::new();
    builder.timer(TokioTimer::new()).header_read_timeout(HEAD_TIME).max_buf_size(HEAD_BYTES);
    let connection = builder.serve_connection(TokioIo::new(stream), service).with_upgrades();
    tokio::pin!(connection);
    tokio::select! {
        // A connection that breaks concerns nobody but who is gone.
        _ = connection.as_mut() => {}
        _ = stopped.changed() => {
            connection.as_mut().graceful_shutdown();
            let _ = tokio::time::timeout(grace, connection).await;
        }
    }
}

/// The answer to a request that says twice how long it is. What follows on its connection cannot be told apart.
fn doubtful() -> Response {
    let why = "it has both Content-Length and Transfer-Encoding: how long it is, is in doubt";
    let body = serde_json::json!({ "error": why, "cause": "bad-request", "errors": [why] }).to_string();
    (StatusCode::BAD_REQUEST, [(CONNECTION, "close"), (CONTENT_TYPE, "application/json")], body)
        .into_response()
}
