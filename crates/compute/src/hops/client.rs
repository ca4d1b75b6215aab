//! Plain HTTP to servers that may be asked.

use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::Duration;

use katydid_component::{Budget, Message};
use ureq::Agent;

use super::HopsSettings;

/// How long one waits between two looks at whether the work shall stop.
const LOOK: Duration = Duration::from_millis(20);

/// Asks the servers on a list and no others, follows no redirects, and reads so many bytes.
#[derive(Debug)]
pub(super) struct Client {
    agent: Agent,
    /// The servers that may be asked, in lower case.
    hosts: Vec<String>,
    bytes: u64,
}

/// What came back.
pub(super) struct Response {
    pub(super) status: u16,
    pub(super) is_json: bool,
    pub(super) body: Vec<u8>,
}

impl Client {
    pub(super) fn new(settings: &HopsSettings) -> Self {
        let config = Agent::config_builder()
            .http_status_as_error(false)
            .max_redirects(0)
            .max_redirects_will_error(false)
            .proxy(None)
            .timeout_global(Some(settings.time))
            .user_agent("katydid")
            .build();
        let compute = settings.compute.as_deref().and_then(|url| authority(url).ok());
        let hosts = settings.hosts.iter().map(|host| host.trim().to_ascii_lowercase()).chain(compute);
        Self { agent: config.into(), hosts: hosts.collect(), bytes: settings.bytes }
    }

    /// Gets a URL.
    ///
    /// # Errors
    /// The message to show when it may not be asked or does not answer, and when the work shall stop.
    pub(super) fn get(&self, url: &str, budget: &Budget) -> Result<Response, Message> {
        self.ask(url, None, budget)
    }

    /// Posts JSON to a URL.
    ///
    /// # Errors
    /// As for [`get`](Self::get).
    pub(super) fn post(&self, url: &str, body: Vec<u8>, budget: &Budget) -> Result<Response, Message> {
        self.ask(url, Some(body), budget)
    }

    fn ask(&self, url: &str, body: Option<Vec<u8>>, budget: &Budget) -> Result<Response, Message> {
        let authority = authority(url)?;
        let host = authority.rsplit_once(':').map_or(authority.as_str(), |(host, _)| host);
        if !self.hosts.iter().any(|known| *known == authority || known == host) {
            return Err(Message::error(format!("{authority} is not among the servers that may be asked")));
        }
        let (send, receive) = channel();
        let (agent, url, bytes) = (self.agent.clone(), url.to_owned(), self.bytes);
        // The thread ends with the time for an answer at the latest; whoever stops does not wait for it.
        std::thread::Builder::new()
            .name("hops".to_owned())
            .spawn(move || send.send(exchange(&agent, &url, body, bytes)))
            .map_err(|error| Message::error(format!("{authority} cannot be asked: {error}")))?;
        loop {
            match receive.recv_timeout(LOOK) {
                Ok(Ok(response)) => return Ok(response),
                Ok(Err(error)) => {
                    return Err(Message::error(format!("{authority} does not answer: {error}")));
                }
                Err(RecvTimeoutError::Timeout) => budget.check()?,
                Err(RecvTimeoutError::Disconnected) => {
                    return Err(Message::error(format!("{authority} cannot be asked")));
                }
            }
        }
    }
}

fn exchange(agent: &Agent, url: &str, body: Option<Vec<u8>>, most: u64) -> Result<Response, ureq::Error> {
    let mut response = match body {
        Some(body) => {
            agent.post(url).header("Content-Type", "application/json; charset=utf-8").send(&body[..])?
        }
        None => agent.get(url).call()?,
    };
    let kind = response.headers().get("content-type").and_then(|kind| kind.to_str().ok());
    Ok(Response {
        status: response.status().as_u16(),
        is_json: kind.is_some_and(|kind| kind.to_ascii_lowercase().contains("json")),
        body: response.body_mut().with_config().limit(most).read_to_vec()?,
    })
}

/// The server of a URL, as `host:port` or `host`, in lower case.
///
/// # Errors
/// The message to show when it is no URL of plain HTTP. Who the server is stands between the slashes and nothing else
/// may stand there: no user, no backslash.
pub(super) fn authority(url: &str) -> Result<String, Message> {
    let (scheme, rest) = url.split_once("://").ok_or_else(|| {
        Message::error(
            "Only definitions at a URL can be asked for: paths of files are not followed".to_owned(),
        )
    })?;
    if !scheme.eq_ignore_ascii_case("http") {
        return Err(Message::error(format!("{scheme} is not supported: servers are asked by plain http")));
    }
    let authority = rest.split(['/', '?', '#']).next().unwrap_or_default();
    let fits = |c: char| c.is_ascii_alphanumeric() || "-._:[]".contains(c);
    if authority.is_empty() || !authority.chars().all(fits) {
        return Err(Message::error("The URL names no server".to_owned()));
    }
    Ok(authority.to_ascii_lowercase())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_server_is_what_stands_between_the_slashes() {
        assert_eq!(authority("http://Localhost:5000/add").unwrap(), "localhost:5000");
        assert_eq!(authority("HTTP://host?x=@other").unwrap(), "host");
        for bad in [
            "https://h/x",
            "file:///etc/passwd",
            "C:\\x.gh",
            "http://",
            "http://a@b/x",
            "http://a\\@b/x",
            "http:///x",
        ] {
            assert!(authority(bad).is_err(), "{bad}");
        }
    }

    #[test]
    fn servers_that_are_not_on_the_list_are_not_asked() {
        let settings =
            HopsSettings { hosts: vec!["localhost:1".to_owned(), "Other".to_owned()], ..Default::default() };
        let client = Client::new(&settings);
        let text = |url: &str| client.get(url, &Budget::default()).err().map(|message| message.text);
        assert_eq!(
            text("http://localhost:2/x").unwrap(),
            "localhost:2 is not among the servers that may be asked"
        );
        assert!(text("http://127.0.0.1:1/x").unwrap().contains("not among"));
        // Nobody listens there.
        assert!(text("http://localhost:1/x").unwrap().starts_with("localhost:1 does not answer"));
    }
}
