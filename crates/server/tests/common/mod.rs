//! A server on a free port, and a client that talks to it as the page does.

#![allow(dead_code, reason = "each test file uses a part of it")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]

use std::collections::HashMap;
use std::time::Duration;

use futures_util::{SinkExt, StreamExt};
use katydid_server::{Config, Server};
use katydid_session::protocol::{Ask, DocumentState, Edit, Event, ObjectView, Request, ResultView, Setting};
use tempfile::TempDir;
use tokio::io::{AsyncReadExt, AsyncWriteExt};
use tokio::net::TcpStream;
use tokio::time::{Instant, timeout};
use tokio_tungstenite::tungstenite::Message;
use tokio_tungstenite::tungstenite::client::IntoClientRequest;
use tokio_tungstenite::tungstenite::http::HeaderValue;
use tokio_tungstenite::tungstenite::protocol::WebSocketConfig;
use tokio_tungstenite::{MaybeTlsStream, WebSocketStream};
use uuid::Uuid;

/// Nothing takes so long.
pub(crate) const WAIT: Duration = Duration::from_secs(60);

pub(crate) struct Studio {
    pub(crate) server: Server,
    pub(crate) folder: TempDir,
    /// The token that every request brings; none where a test brings its own.
    token: Option<String>,
}

pub(crate) struct Answer {
    pub(crate) status: u16,
    pub(crate) head: String,
    pub(crate) body: Vec<u8>,
}

impl Answer {
    pub(crate) fn json(&self) -> serde_json::Value {
        serde_json::from_slice(&self.body)
            .unwrap_or_else(|_| panic!("{}", String::from_utf8_lossy(&self.body)))
    }
}

impl Studio {
    pub(crate) async fn start() -> Self {
        Self::start_with(|config| config).await
    }

    pub(crate) async fn start_with(change: impl FnOnce(Config) -> Config) -> Self {
        let folder = tempfile::tempdir().unwrap();
        let state = Some(folder.path().join("state"));
        let config = change(Config { port: 0, state, ..Config::default() });
        let is_own = config.token.is_some();
        let server = katydid_server::start(config).await.unwrap();
        let token = server.url().rsplit_once("token=").map(|(_, token)| token.to_owned());
        Self { server, folder, token: token.filter(|_| !is_own) }
    }

    /// A line of a request's head that brings the token.
    pub(crate) fn cookie(&self) -> String {
        let port = self.server.address().port();
        self.token
            .as_ref()
            .map(|token| format!("Cookie: katydid_token_{port}={token}\r\n"))
            .unwrap_or_default()
    }

    /// The address of the socket of a document, with the token.
    pub(crate) fn socket(&self, document: &str) -> String {
        let token = self.token.as_ref().map(|token| format!("&token={token}")).unwrap_or_default();
        format!("ws://{}/socket?document={document}{token}", self.host())
    }

    pub(crate) fn host(&self) -> String {
        format!("127.0.0.1:{}", self.server.address().port())
    }

    /// Sends a request as it is, and reads until the server closes.
    pub(crate) async fn raw(&self, request: &[u8]) -> Answer {
        let mut stream = TcpStream::connect(self.server.address()).await.unwrap();
        stream.write_all(request).await.unwrap();
        let mut bytes = Vec::new();
        let _ = timeout(WAIT, stream.read_to_end(&mut bytes)).await.expect("an answer in time");
        let end = bytes.windows(4).position(|w| w == b"\r\n\r\n").expect("a head");
        let head = String::from_utf8_lossy(&bytes[..end]).into_owned();
        let status = head.split(' ').nth(1).unwrap().parse().unwrap();
        Answer { status, head, body: bytes[end + 4..].to_vec() }
    }

    pub(crate) async fn ask(&self, method: &str, path: &str, headers: &str, body: &[u8]) -> Answer {
        let (host, cookie) = (self.host(), self.cookie());
        let length = body.len();
        let head = format!(
            "{method} {path} HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\nContent-Length: {length}\r\n{cookie}{headers}\r\n"
        );
        self.raw(&[head.as_bytes(), body].concat()).await
    }

    pub(crate) async fn get(&self, path: &str) -> Answer {
        self.ask("GET", path, "", b"").await
    }

    pub(crate) async fn post_json(&self, path: &str, body: &str) -> Answer {
        self.ask("POST", path, "Content-Type: application/json\r\n", body.as_bytes()).await
    }

    /// Sends a definition; gives the document's id.
    pub(crate) async fn upload(&self, text: &str) -> String {
        let answer = self.ask("POST", "/api/upload?name=test.kd", "", text.as_bytes()).await;
        assert_eq!(answer.status, 200, "{}", String::from_utf8_lossy(&answer.body));
        answer.json()["document"].as_str().unwrap().to_owned()
    }

    pub(crate) async fn join(&self, document: &str) -> Client {
        self.join_through(document, None).await
    }

    /// Joins as somebody at another machine does, whose words a proxy of this one passes on.
    pub(crate) async fn join_from(&self, document: &str, address: &'static str) -> Client {
        self.join_through(document, Some(address)).await
    }

    async fn join_through(&self, document: &str, address: Option<&'static str>) -> Client {
        let mut url = self.socket(document).into_client_request().unwrap();
        if let Some(address) = address {
            url.headers_mut().insert("x-forwarded-for", HeaderValue::from_static(address));
        }
        let config = WebSocketConfig::default().max_message_size(None).max_frame_size(None);
        let (socket, _) =
            tokio_tungstenite::connect_async_with_config(url, Some(config), false).await.unwrap();
        Client {
            socket,
            seq: 0,
            state: None,
            objects: HashMap::new(),
            results: HashMap::new(),
            hashes: HashMap::new(),
            given: HashMap::new(),
            frames: Vec::new(),
            finished: 0,
            cancelled: false,
            notices: Vec::new(),
            heard: String::new(),
        }
    }

    /// A document and a client that has heard of its first solve.
    pub(crate) async fn with(&self, text: &str) -> Client {
        let id = self.upload(text).await;
        let mut client = self.join(&id).await;
        client.solved(1).await;
        client
    }
}

pub(crate) struct Client {
    socket: WebSocketStream<MaybeTlsStream<TcpStream>>,
    seq: u64,
    pub(crate) state: Option<DocumentState>,
    pub(crate) objects: HashMap<Uuid, ObjectView>,
    pub(crate) results: HashMap<Uuid, ResultView>,
    pub(crate) hashes: HashMap<Uuid, Option<String>>,
    /// The geometry that `drawn` gave last.
    given: HashMap<Uuid, Option<String>>,
    pub(crate) frames: Vec<Vec<u8>>,
    /// How many solves have ended.
    pub(crate) finished: u64,
    pub(crate) cancelled: bool,
    pub(crate) notices: Vec<String>,
    /// All texts that came, as they came.
    pub(crate) heard: String,
}

impl Client {
    /// The next event or frame.
    pub(crate) async fn hear(&mut self) -> Option<Event> {
        let next = timeout(WAIT, self.socket.next()).await.expect("something in time");
        match next.expect("the socket is open").expect("a frame") {
            Message::Text(text) => {
                let event: Event = serde_json::from_str(text.as_str()).unwrap();
                self.heard.push_str(text.as_str());
                self.take(&event);
                Some(event)
            }
            Message::Binary(bytes) => {
                self.take_frame(&bytes);
                None
            }
            _ => None,
        }
    }

    /// Takes a frame apart: each geometry behind its hash.
    fn take_frame(&mut self, frame: &[u8]) {
        let mut at = 0;
        while at < frame.len() {
            let length = u32::from_le_bytes(frame[at + 16..at + 20].try_into().unwrap()) as usize;
            let bytes = &frame[at + 24..at + 24 + length];
            self.frames.push([&frame[at..at + 16], bytes].concat());
            at += (24 + length).next_multiple_of(8);
        }
        assert_eq!(at, frame.len(), "geometry fills its frame");
    }

    fn take(&mut self, event: &Event) {
        match event {
            Event::Document(state) => {
                self.objects = state.objects.iter().map(|object| (object.id, object.clone())).collect();
                self.state = Some(state.clone());
            }
            Event::Patch { put, removed, document, revision, .. } => {
                self.objects.extend(put.iter().map(|object| (object.id, object.clone())));
                removed.iter().for_each(|id| drop(self.objects.remove(id)));
                if let Some(state) = &mut self.state {
                    state.revision = *revision;
                    if let Some(document) = document {
                        state.document = document.clone();
                    }
                }
            }
            Event::Results { results, finished, cancelled, .. } => {
                self.results.extend(results.iter().map(|result| (result.id, result.clone())));
                self.finished += u64::from(*finished);
                self.cancelled = *cancelled;
            }
            Event::Preview { objects, .. } => self.hashes.extend(objects.iter().cloned()),
            Event::Notice(notice) => self.notices.push(notice.text.clone()),
            _ => {}
        }
    }

    pub(crate) async fn send(&mut self, message: Message) {
        self.socket.send(message).await.unwrap();
    }

    /// Asks without waiting for the answer; gives the number of the request.
    pub(crate) async fn tell(&mut self, ask: Ask) -> u64 {
        self.seq += 1;
        let request = Request { seq: self.seq, ask };
        self.send(Message::Text(serde_json::to_string(&request).unwrap().into())).await;
        self.seq
    }

    /// Asks, and waits for the answer.
    pub(crate) async fn ask(&mut self, ask: Ask) -> Event {
        let mine = self.tell(ask).await;
        loop {
            match self.hear().await {
                Some(
                    event @ (Event::Done { seq, .. }
                    | Event::Refused { seq, .. }
                    | Event::Effects { seq, .. }
                    | Event::Solved { seq, .. }
                    | Event::Motion { seq, .. }
                    | Event::Rows { seq, .. }
                    | Event::Pictures { seq, .. }
                    | Event::Scripts { seq, .. }
                    | Event::Copied { seq, .. }),
                ) if seq == mine => return event,
                _ => {}
            }
        }
    }

    pub(crate) async fn edit(&mut self, edit: Edit) -> Event {
        self.ask(Ask::Edit { edit, gesture: None, within: vec![] }).await
    }

    /// Waits until so many solves have ended.
    pub(crate) async fn solved(&mut self, times: u64) {
        let start = Instant::now();
        while self.finished < times {
            assert!(start.elapsed() < WAIT, "solved {} of {times} times", self.finished);
            self.hear().await;
        }
    }

    /// Waits for geometry of an object other than what this gave last: it comes before the results of its solve.
    pub(crate) async fn drawn(&mut self, id: Uuid) -> Option<String> {
        let start = Instant::now();
        loop {
            if let Some(now) = self.hashes.get(&id).cloned()
                && self.given.insert(id, now.clone()).as_ref() != Some(&now)
            {
                return now;
            }
            assert!(start.elapsed() < WAIT, "no geometry");
            self.hear().await;
        }
    }

    /// The object of that nickname.
    pub(crate) fn named(&self, name: &str) -> Uuid {
        self.objects.values().find(|object| object.nickname == name).unwrap_or_else(|| panic!("no {name}")).id
    }

    pub(crate) async fn set(&mut self, name: &str, value: f64) -> Event {
        let object = self.named(name);
        self.edit(Edit::Set { object, to: Setting::Number { value } }).await
    }

    /// Waits until a panel shows this.
    pub(crate) async fn shows(&mut self, name: &str, texts: &[&str]) {
        let start = Instant::now();
        while self.texts(name) != texts {
            assert!(start.elapsed() < WAIT, "{:?}, not {texts:?}", self.texts(name));
            self.hear().await;
        }
    }

    pub(crate) fn texts(&self, name: &str) -> Vec<String> {
        use katydid_session::protocol::Row;
        let page = self.results.get(&self.named(name)).and_then(|result| result.panel.clone());
        let rows = page.map(|page| page.rows).unwrap_or_default();
        rows.into_iter()
            .filter_map(|row| if let Row::Item { text, .. } = row { Some(text) } else { None })
            .collect()
    }
}

/// Whether an event says that a request was carried out.
pub(crate) fn is_done(event: &Event) -> bool {
    matches!(event, Event::Done { .. })
}

pub(crate) fn refusal(event: &Event) -> &str {
    match event {
        Event::Refused { reason, .. } => reason,
        other => panic!("{other:?}"),
    }
}

impl Client {
    /// What a panel shows; nothing while it is not known.
    pub(crate) fn texts_or_nothing(&self, name: &str) -> Vec<String> {
        if self.objects.values().any(|object| object.nickname == name) {
            self.texts(name)
        } else {
            Vec::new()
        }
    }
}

impl Client {
    /// Sends what the server may refuse.
    pub(crate) async fn send_or_fail(&mut self, message: Message) {
        let _ = self.socket.send(message).await;
        while let Some(Ok(_)) = self.socket.next().await {}
    }
}
