//! Asking, and reading what comes back.

use std::io::{ErrorKind, Read};
use std::sync::Arc;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::Duration;

use flate2::read::MultiGzDecoder;
use ureq::http::header::{CONTENT_ENCODING, CONTENT_LENGTH, CONTENT_TYPE};
use ureq::tls::{PemItem, RootCerts, TlsConfig, parse_pem};
use ureq::unversioned::transport::DefaultConnector;
use ureq::{Agent, Error};

use super::hosts::Hosts;
use super::resolver::Listed;
use super::{REACH, WebSettings, keys};
use crate::{Cause, Fault};

/// How long one waits between two looks at whether the work shall stop.
const LOOK: Duration = Duration::from_millis(20);

/// Asks the hosts on a list and no others.
#[derive(Debug)]
pub(crate) struct Web {
    agent: Agent,
    hosts: Arc<Hosts>,
    bytes: usize,
}

/// What is asked.
#[derive(Debug)]
pub(crate) struct Asked<'a> {
    pub(crate) url: &'a str,
    /// The JSON to post; what lies there is got when there is none.
    pub(crate) body: Option<Vec<u8>>,
    /// The key that the host wants to see.
    pub(crate) key: Option<String>,
    /// The most that it may take.
    pub(crate) time: Duration,
}

/// What came back.
#[derive(Debug)]
pub(crate) struct Response {
    pub(crate) status: u16,
    pub(crate) is_json: bool,
    /// The body, unpacked.
    pub(crate) body: Vec<u8>,
}

impl Web {
    pub(crate) fn new(settings: &WebSettings) -> Self {
        let hosts = Arc::new(Hosts::new(&settings.hosts));
        let roots = match settings.authorities.as_slice() {
            [] => RootCerts::WebPki,
            pem => parse_pem(pem)
                .filter_map(|item| match item {
                    Ok(PemItem::Certificate(certificate)) => Some(certificate),
                    _ => None,
                })
                .into(),
        };
        let config = Agent::config_builder()
            .http_status_as_error(false)
            .max_redirects(0)
            .max_redirects_will_error(false)
            .proxy(None)
            .timeout_resolve(Some(REACH))
            .timeout_connect(Some(REACH))
            .max_idle_connections_per_host(2)
            .user_agent(concat!("katydid/", env!("CARGO_PKG_VERSION")))
            .tls_config(TlsConfig::builder().root_certs(roots).build())
            .build();
        let agent = Agent::with_parts(config, DefaultConnector::default(), Listed::new(hosts.clone()));
        Self { agent, hosts, bytes: settings.bytes }
    }

    /// Asks a host. `go_on` is called every now and then while one waits; what it fails with is passed on.
    ///
    /// # Errors
    /// As for the address and its host: `BadRequest`, `Refused`. `NotFound` when it does not answer, `TimedOut`,
    /// `TooLarge`.
    pub(crate) fn ask(
        &self,
        asked: Asked<'_>,
        go_on: impl Fn() -> Result<(), Fault>,
    ) -> Result<Response, Fault> {
        let host = self.hosts.place(asked.url)?.name;
        let (send, receive) = channel();
        let (agent, url, most) = (self.agent.clone(), asked.url.trim().to_owned(), self.bytes);
        let Asked { body, key, time, .. } = asked;
        // The thread ends when the time is over at the latest; whoever stops does not wait for it.
        let thread = std::thread::Builder::new().name("web".to_owned());
        let started = thread.spawn(move || send.send(exchange(&agent, &url, body, key, time, most)));
        started.map_err(|_| Fault::failed(format!("{host} cannot be asked")))?;
        loop {
            match receive.recv_timeout(LOOK) {
                Ok(exchanged) => return exchanged.map_err(|error| fault(&host, most, error)),
                Err(RecvTimeoutError::Timeout) => go_on()?,
                Err(RecvTimeoutError::Disconnected) => {
                    return Err(Fault::failed(format!("{host} cannot be asked")));
                }
            }
        }
    }
}

fn exchange(
    agent: &Agent,
    url: &str,
    body: Option<Vec<u8>>,
    key: Option<String>,
    time: Duration,
    most: usize,
) -> Result<Response, Error> {
    // Redirects are not followed, so that the key goes to no other host.
    let mut response = match body {
        Some(body) => {
            let post = agent.post(url).header(CONTENT_TYPE, "application/json; charset=utf-8");
            let post = key.iter().fold(post, |post, key| post.header(keys::HEADER, key));
            post.config().timeout_global(Some(time)).build().send(&body[..])?
        }
        None => {
            let get = agent.get(url).header("Accept-Encoding", "gzip");
            let get = key.iter().fold(get, |get, key| get.header(keys::HEADER, key));
            get.config().timeout_global(Some(time)).build().call()?
        }
    };
    let header =
        |name| response.headers().get(name).and_then(|value| value.to_str().ok()).unwrap_or_default();
    let is_json = header(CONTENT_TYPE).to_ascii_lowercase().contains("json");
    let is_packed = ["gzip", "x-gzip"].iter().any(|form| header(CONTENT_ENCODING).eq_ignore_ascii_case(form));
    // What says that it is too long is not begun.
    if header(CONTENT_LENGTH).parse().is_ok_and(|length: u64| length > most as u64) {
        return Err(Error::BodyExceedsLimit(most as u64));
    }
    let status = response.status().as_u16();
    let mut body = response.body_mut().with_config().limit(most as u64).read_to_vec()?;
    if is_packed || body.starts_with(&[0x1f, 0x8b]) {
        body = unpacked(&body, most)?;
    }
    Ok(Response { status, is_json, body })
}

/// Unpacks no more than `most` bytes.
fn unpacked(packed: &[u8], most: usize) -> Result<Vec<u8>, Error> {
    let mut bytes = Vec::new();
    let read = MultiGzDecoder::new(packed).take((most as u64).saturating_add(1)).read_to_end(&mut bytes);
    if bytes.len() > most {
        return Err(Error::BodyExceedsLimit(most as u64));
    }
    read.map_err(|_| Error::Other(Box::new(Fault::bad_request("what came is not packed as it says"))))?;
    Ok(bytes)
}

fn fault(host: &str, most: usize, error: Error) -> Fault {
    match error {
        Error::Other(other) => match other.downcast::<Fault>() {
            Ok(fault) => *fault,
            Err(_) => Fault::not_found(format!("{host} does not answer")),
        },
        Error::Timeout(_) => Fault::new(Cause::TimedOut, format!("{host} does not answer in time")),
        Error::BodyExceedsLimit(_) => Fault::too_large(format!("{host} answers with more than {most} bytes")),
        Error::HostNotFound => Fault::not_found(format!("{host} is not known")),
        Error::Rustls(error) => Fault::not_found(format!("{host} cannot be trusted: {error}")),
        // What TLS finds wrong comes as data that is not valid.
        Error::Io(error) if error.kind() == ErrorKind::InvalidData => {
            Fault::not_found(format!("{host} cannot be trusted: {error}"))
        }
        other => Fault::not_found(format!("{host} does not answer: {other}")),
    }
}
