//! Starting, listening, stopping.

use std::net::SocketAddr;
use std::sync::Arc;
use std::time::Duration;

use axum::Router;
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::service::TowerToHyperService;
use katydid_component::RhinoModel;
use tokio::net::{TcpListener, TcpStream};
use tokio::sync::{Semaphore, watch};
use tokio::task::JoinHandle;

use crate::document::Source;
use crate::http::{self, State};
use crate::{Config, Error};

/// So many connections at a time.
const MOST_CONNECTIONS: usize = 1024;
/// A request's head must be here after so long.
const HEAD_TIME: Duration = Duration::from_secs(15);
/// And has no more bytes.
const HEAD_BYTES: usize = 64 << 10;
/// Connections that are busy have so long to end.
const GRACE: Duration = Duration::from_secs(2);

/// A server that runs.
#[derive(Debug)]
pub struct Server {
    address: SocketAddr,
    url: String,
    state: Arc<State>,
    stop: watch::Sender<bool>,
    listening: JoinHandle<()>,
}

/// Starts a server.
///
/// # Errors
/// The port is taken, or the definition or model that it shall open cannot be read.
pub async fn start(config: Config) -> Result<Server, Error> {
    katydid_components::link();
    let wanted = SocketAddr::new(config.address, config.port);
    let fail = |source| Error::Listen { address: wanted, source };
    let listener = TcpListener::bind(wanted).await.map_err(fail)?;
    let address = listener.local_addr().map_err(fail)?;
    let (file, model, player) = (config.file.clone(), config.model.clone(), config.player);
    let state = Arc::new(State::new(config));
    let mut query = Vec::new();
    if player {
        query.push("player".to_owned());
    }
    if let Some(file) = file {
        let source = tokio::task::spawn_blocking(move || opened(&file, model.as_deref()));
        let source = source.await.map_err(|error| Error::Open(error.to_string()))?.map_err(Error::Open)?;
        let id = state.documents.open(source).map_err(Error::Open)?;
        query.push(format!("document={id}"));
    }
    query.extend(state.guard.token().map(|token| format!("token={token}")));
    let url = url(address, &query.join("&"));
    let (stop, stopped) = watch::channel(false);
    let listening = tokio::spawn(listen(listener, http::router(Arc::clone(&state)), stopped));
    Ok(Server { address, url, state, stop, listening })
}

fn opened(file: &std::path::Path, model: Option<&std::path::Path>) -> Result<Source, String> {
    let source = Source::file(file)?;
    let Some(path) = model else { return Ok(source) };
    let bytes = std::fs::read(path)
        .map_err(|error| format!("{}: {}", path.display(), crate::files::plain(&error)))?;
    let model = RhinoModel::read(&bytes).map_err(|error| format!("{}: {error}", path.display()))?;
    Ok(source.beside(model))
}

/// The address as a browser of this machine writes it.
fn url(address: SocketAddr, query: &str) -> String {
    let host = match address {
        SocketAddr::V4(v4) if v4.ip().is_unspecified() => "127.0.0.1".to_owned(),
        SocketAddr::V6(v6) if v6.ip().is_unspecified() => "[::1]".to_owned(),
        SocketAddr::V4(v4) => v4.ip().to_string(),
        SocketAddr::V6(v6) => format!("[{}]", v6.ip()),
    };
    let query = if query.is_empty() { String::new() } else { format!("?{query}") };
    format!("http://{host}:{}/{query}", address.port())
}

async fn listen(listener: TcpListener, router: Router, mut stopped: watch::Receiver<bool>) {
    let room = Arc::new(Semaphore::new(MOST_CONNECTIONS));
    loop {
        let stream = tokio::select! {
            accepted = listener.accept() => match accepted {
                Ok((stream, _)) => stream,
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
            serve(stream, router, stopped).await;
            drop(permit);
        });
    }
}

async fn serve(stream: TcpStream, router: Router, mut stopped: watch::Receiver<bool>) {
    let _ = stream.set_nodelay(true);
    let mut builder = hyper::server::conn::http1::Builder::new();
    builder.timer(TokioTimer::new()).header_read_timeout(HEAD_TIME).max_buf_size(HEAD_BYTES);
    let connection =
        builder.serve_connection(TokioIo::new(stream), TowerToHyperService::new(router)).with_upgrades();
    tokio::pin!(connection);
    tokio::select! {
        // A connection that breaks concerns nobody but who is gone.
        _ = connection.as_mut() => {}
        _ = stopped.changed() => {
            connection.as_mut().graceful_shutdown();
            let _ = tokio::time::timeout(GRACE, connection).await;
        }
    }
}

impl Server {
    /// Where it listens.
    pub fn address(&self) -> SocketAddr {
        self.address
    }

    /// The address of the page, with the token where one is needed.
    pub fn url(&self) -> &str {
        &self.url
    }

    /// Whether the page is here: it is built apart.
    pub fn has_page(&self) -> bool {
        http::has_page()
    }

    /// Stops listening, and closes the documents: what was not saved is in their journals.
    pub async fn stop(self) {
        let _ = self.stop.send(true);
        self.state.documents.close_all().await;
        let _ = tokio::time::timeout(GRACE, self.listening).await;
    }
}
