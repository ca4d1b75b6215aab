//! A server on a free port, and a client that says exactly what it is told to say.

use std::collections::HashMap;
use std::time::Duration;

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use katydid_server::compute::{Config, Server};
use serde_json::{Value, json};
use tokio::io::{AsyncReadExt, AsyncWriteExt};
use tokio::net::TcpStream;
use tokio::time::timeout;

/// Nothing takes so long.
pub(crate) const WAIT: Duration = Duration::from_secs(120);

pub(crate) struct Compute {
    pub(crate) server: Server,
}

#[derive(Debug)]
pub(crate) struct Answer {
    pub(crate) status: u16,
    pub(crate) headers: HashMap<String, String>,
    pub(crate) body: Vec<u8>,
}

impl Answer {
    pub(crate) fn text(&self) -> String {
        String::from_utf8_lossy(&self.body).into_owned()
    }

    pub(crate) fn json(&self) -> Value {
        serde_json::from_slice(&self.body).unwrap_or_else(|_| panic!("{}: {}", self.status, self.text()))
    }

    pub(crate) fn header(&self, name: &str) -> &str {
        self.headers.get(name).map_or("", String::as_str)
    }

    /// What the first item of an output says.
    pub(crate) fn output(&self, name: &str) -> Value {
        let reply = self.json();
        let values = reply["values"].as_array().unwrap_or_else(|| panic!("{}: {reply}", self.status)).clone();
        let tree = values.iter().find(|tree| tree["ParamName"] == name);
        let tree = tree.unwrap_or_else(|| panic!("no output '{name}': {reply}"));
        let branch = tree["InnerTree"].as_object().unwrap().values().next().expect("a branch").clone();
        serde_json::from_str(branch[0]["data"].as_str().expect("data")).unwrap()
    }

    /// A refusal of the client's making that says why, and nothing of this machine.
    pub(crate) fn is_refused(&self) -> bool {
        let says = |body: &Value| body["error"].as_str().is_some_and(|error| !error.is_empty());
        let shows = |text: &str| self.text().contains(text);
        (400..500).contains(&self.status)
            && says(&self.json())
            && !shows("/work")
            && !shows(".rs")
            && !shows("root:")
    }
}

impl Compute {
    pub(crate) async fn start() -> Self {
        Self::start_with(|config| config).await
    }

    pub(crate) async fn start_with(change: impl FnOnce(Config) -> Config) -> Self {
        let grace = Duration::from_secs(5);
        let config = change(Config { port: 0, grace, ..Config::default() });
        Self { server: katydid_server::compute::start(config).await.unwrap() }
    }

    pub(crate) fn host(&self) -> String {
        self.server.address().to_string()
    }

    pub(crate) async fn connect(&self) -> TcpStream {
        TcpStream::connect(self.server.address()).await.unwrap()
    }

    pub(crate) async fn ask(&self, method: &str, path: &str, headers: &str, body: &[u8]) -> Answer {
        let head = format!(
            "{method} {path} HTTP/1.1\r\nHost: {}\r\nConnection: close\r\nContent-Length: {}\r\n{headers}\r\n",
            self.host(),
            body.len()
        );
        self.raw(&[head.as_bytes(), body].concat()).await
    }

    pub(crate) async fn raw(&self, request: &[u8]) -> Answer {
        let mut stream = self.connect().await;
        let (mut reading, mut writing) = stream.split();
        let mut bytes = Vec::new();
        // Who is refused early may be answered before all is said.
        let say = async {
            let _ = writing.write_all(request).await;
        };
        let hear = async {
            let _ = reading.read_to_end(&mut bytes).await;
        };
        timeout(WAIT, async { tokio::join!(say, hear) }).await.expect("an answer in time");
        let (answer, rest) = parsed(&bytes).expect("an answer");
        assert!(rest.is_empty(), "more than one answer");
        answer
    }

    pub(crate) async fn get(&self, path: &str) -> Answer {
        self.ask("GET", path, "", b"").await
    }

    pub(crate) async fn post(&self, path: &str, body: &Value) -> Answer {
        self.ask("POST", path, "", body.to_string().as_bytes()).await
    }

    pub(crate) async fn solve(&self, algo: &str, values: Value) -> Answer {
        self.post("/grasshopper", &json!({"algo": algo, "pointer": null, "values": values})).await
    }

    /// The server does what it is for, once it has finished what it is at and what it stopped has ended.
    pub(crate) async fn is_well(&self) {
        let start = tokio::time::Instant::now();
        let mut answer = self.get("/healthcheck").await;
        let passes = |text: &str| text.starts_with("Busy: ") || text.starts_with("Unhealthy: workers: ");
        while passes(&answer.text()) && start.elapsed() < WAIT {
            tokio::time::sleep(Duration::from_millis(20)).await;
            answer = self.get("/healthcheck").await;
        }
        assert_eq!((answer.status, answer.text().as_str()), (200, "Healthy"));
    }
}

/// The first answer in what was heard, and what follows it.
pub(crate) fn parsed(bytes: &[u8]) -> Option<(Answer, &[u8])> {
    let end = bytes.windows(4).position(|window| window == b"\r\n\r\n")?;
    let head = String::from_utf8_lossy(&bytes[..end]).into_owned();
    let mut lines = head.lines();
    let status = lines.next()?.split(' ').nth(1)?.parse().ok()?;
    let headers: HashMap<String, String> = lines
        .filter_map(|line| line.split_once(':'))
        .map(|(name, value)| (name.to_lowercase(), value.trim().to_owned()))
        .collect();
    let rest = &bytes[end + 4..];
    let length = headers.get("content-length").map_or(rest.len(), |length| length.parse().unwrap());
    let length = if status == 204 { 0 } else { length };
    let body = rest.get(..length)?.to_vec();
    Some((Answer { status, headers, body }, &rest[length..]))
}

/// The next answer on a connection that stays.
pub(crate) async fn next(stream: &mut TcpStream, heard: &mut Vec<u8>) -> Answer {
    loop {
        if let Some((answer, rest)) = parsed(heard) {
            *heard = rest.to_vec();
            return answer;
        }
        let mut piece = [0; 65_536];
        let read = timeout(WAIT, stream.read(&mut piece)).await.expect("an answer in time").unwrap();
        assert!(read > 0, "the connection is closed: {}", String::from_utf8_lossy(heard));
        heard.extend_from_slice(&piece[..read]);
    }
}

pub(crate) fn base64(bytes: impl AsRef<[u8]>) -> String {
    BASE64_STANDARD.encode(bytes)
}

/// The values of one input.
pub(crate) fn input(name: &str, path: &str, data: &[Value]) -> Value {
    let items: Vec<Value> = data.iter().map(|data| json!({ "data": data })).collect();
    json!({"ParamName": name, "InnerTree": {path: items}})
}
