//! Starting and stopping.

use std::net::SocketAddr;
use std::sync::Arc;
use std::time::Duration;

use axum::Router;
use tokio::task::JoinHandle;

use super::behind::Behind;
use super::middleware;
use super::service::Service;
use super::{Config, Processes};
use crate::Error;
use crate::listen::{Listening, bind, url};

/// So often results of jobs are looked through for those that are kept no longer.
const SWEEP: Duration = Duration::from_secs(30);
/// What was stopped has so long to say so.
const LAST: Duration = Duration::from_secs(2);

/// A compute server that runs.
pub struct Server {
    url: String,
    grace: Duration,
    service: Arc<Service>,
    listening: Listening,
    sweeping: JoinHandle<()>,
}

impl std::fmt::Debug for Server {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Server").field("url", &self.url).finish_non_exhaustive()
    }
}

/// Starts a server.
///
/// # Errors
/// The port is taken, others than this machine could ask and there is no key, or the second process cannot be started.
pub async fn start(config: Config) -> Result<Server, Error> {
    let wanted = SocketAddr::new(config.address, config.port);
    if !config.address.is_loopback() && config.key().is_none() {
        return Err(Error::Key(config.address));
    }
    katydid_components::link();
    let grace = config.grace;
    let (listener, address) = bind(wanted).await?;
    let mut config = config;
    // What it would ask itself it solves at once: otherwise definitions that call others would wait for their own turn.
    let front = match &config.processes {
        Processes::Behind(orders) => orders.front(),
        _ => address,
    };
    config.hops_server = config.hops_server.filter(|url| !leads_to(url, front));
    let behind = match &config.processes {
        Processes::Two(command) => {
            Some(Behind::start(command.clone(), address).await.map_err(Error::Behind)?)
        }
        _ => None,
    };
    let service = Arc::new(Service::new(config, behind));
    let router = Router::new().fallback(middleware::answer).with_state(Arc::clone(&service));
    let listening = Listening::start(listener, address, router, grace);
    let swept = Arc::clone(&service);
    let sweeping = tokio::spawn(async move {
        loop {
            tokio::time::sleep(SWEEP).await;
            swept.jobs.sweep();
        }
    });
    Ok(Server { url: url(address, ""), grace, service, listening, sweeping })
}

/// Whether a URL is that of an address on this machine.
fn leads_to(url: &str, address: SocketAddr) -> bool {
    let rest = url.split_once("://").map_or(url, |(_, rest)| rest);
    let authority = rest.split('/').next().unwrap_or(rest).to_ascii_lowercase();
    let name = format!("localhost:{}", address.port());
    authority == address.to_string() || (authority == name && address.ip().is_loopback())
}

impl Server {
    /// Where it listens.
    pub fn address(&self) -> SocketAddr {
        self.listening.address()
    }

    /// Its address.
    pub fn url(&self) -> &str {
        &self.url
    }

    /// Takes no more requests, lets those that are under way end within the time of grace, and stops jobs.
    pub async fn stop(self) {
        self.sweeping.abort();
        self.listening.close();
        self.service.jobs.cancel_all();
        self.listening.ended(self.grace + LAST).await;
        if let Some(behind) = &self.service.behind {
            behind.stop().await;
        }
    }
}
