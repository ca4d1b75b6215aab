//! The studio's server: starting and stopping.

use std::net::SocketAddr;
use std::sync::Arc;
use std::time::Duration;

use crate::document::Source;
use crate::files::AddressFile;
use crate::http::{self, State, Study};
use crate::listen::{Listening, bind, url};
use crate::{Config, Error};

/// Connections that are busy have so long to end.
const GRACE: Duration = Duration::from_secs(2);

/// A server that runs.
pub struct Server {
    url: String,
    opening: String,
    state: Arc<State>,
    listening: Listening,
    /// Tells programs of assistants the address, as long as the server runs.
    told: Option<AddressFile>,
}

impl std::fmt::Debug for Server {
    /// Without the addresses: the token is in them.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Server").field("address", &self.address()).finish_non_exhaustive()
    }
}

/// Starts a server.
///
/// # Errors
/// The port is taken, or the definition or model that it shall open cannot be read.
pub async fn start(config: Config) -> Result<Server, Error> {
    katydid_components::link();
    let (listener, address) = bind(SocketAddr::new(config.address, config.port)).await?;
    let (file, model, player) = (config.file.clone(), config.model.clone(), config.player);
    let study = config.study.as_ref().map(Study::open).transpose().map_err(Error::Open)?;
    let page = if study.is_some() { "study" } else { "" };
    let wants_told = config.assistant && config.is_local();
    let told = config.state.as_deref().filter(|_| wants_told).map(Config::address_file);
    let state = Arc::new(State::new(config, address.port(), study));
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
    let with = |secret: String| {
        format!("{}{page}?{}", url(address, ""), [query.as_slice(), &[secret]].concat().join("&"))
    };
    let opening = with(format!("ticket={}", state.guard.ticket()));
    let url = with(format!("token={}", state.guard.token()));
    let listening = Listening::start(listener, address, http::router(Arc::clone(&state)), GRACE);
    let told = told.and_then(|file| AddressFile::write(file, &url).ok());
    Ok(Server { url, opening, state, listening, told })
}

fn opened(file: &std::path::Path, model: Option<&std::path::Path>) -> Result<Source, String> {
    let source = Source::file(file)?;
    match model {
        Some(path) => source.with_model(path),
        None => Ok(source),
    }
}

impl Server {
    /// Where it listens.
    pub fn address(&self) -> SocketAddr {
        self.listening.address()
    }

    /// The address of the page, with the token.
    pub fn url(&self) -> &str {
        &self.url
    }

    /// The address of the page for the command that starts a browser: it works once. Other users of the machine can see
    /// the words of that command, and the token must not be among them.
    pub fn opening(&self) -> &str {
        &self.opening
    }

    /// Whether programs of assistants find the address by themselves: it stands in a file that only its owner can read.
    pub fn tells_assistants(&self) -> bool {
        self.told.is_some()
    }

    /// Whether the page is here: it is built apart.
    pub fn has_page(&self) -> bool {
        http::has_page()
    }

    /// Stops listening, and closes the documents: what was not saved is in their journals.
    pub async fn stop(self) {
        self.listening.close();
        self.state.documents.close_all().await;
        self.listening.ended(GRACE).await;
    }
}
