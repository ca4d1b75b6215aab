//! A connection that stays, and what is said over it.

use std::io::{ErrorKind, Read, Write};
use std::net::TcpStream;
use std::time::Duration;

use serde_json::Value;

use crate::Outcome;

/// Nothing takes so long: who hears nothing is not answered any more.
const SILENCE: Duration = Duration::from_secs(60);

pub(crate) struct Client {
    stream: TcpStream,
    heard: Vec<u8>,
}

/// An answer with its body.
pub(crate) struct Answer {
    pub(crate) status: u16,
    pub(crate) body: Vec<u8>,
    /// The milliseconds that the server says the solve took.
    pub(crate) solve: f64,
}

impl Answer {
    pub(crate) fn json(&self) -> Value {
        serde_json::from_slice(&self.body).unwrap_or_default()
    }
}

/// A request as bytes.
pub(crate) fn request(method: &str, host: &str, path: &str, body: &[u8]) -> Vec<u8> {
    let head = format!("{method} {path} HTTP/1.1\r\nHost: {host}\r\nContent-Length: {}\r\n\r\n", body.len());
    [head.as_bytes(), body].concat()
}

impl Client {
    pub(crate) fn new(host: &str) -> Outcome<Self> {
        let stream = TcpStream::connect(host)?;
        stream.set_nodelay(true)?;
        stream.set_read_timeout(Some(SILENCE))?;
        stream.set_write_timeout(Some(SILENCE))?;
        Ok(Self { stream, heard: Vec::new() })
    }

    pub(crate) fn ask(&mut self, request: &[u8]) -> Outcome<Answer> {
        self.say(request)?;
        self.hear()
    }

    pub(crate) fn say(&mut self, bytes: &[u8]) -> Outcome<()> {
        Ok(self.stream.write_all(bytes)?)
    }

    /// The next answer.
    pub(crate) fn hear(&mut self) -> Outcome<Answer> {
        self.heard.clear();
        let (head, start) = loop {
            self.more()?;
            if let Some(end) = self.heard.windows(4).position(|window| window == b"\r\n\r\n") {
                let head = String::from_utf8_lossy(self.heard.get(..end).unwrap_or_default()).to_lowercase();
                break (head, end + 4);
            }
        };
        let field = |name: &str| head.lines().find_map(|line| line.strip_prefix(name)).map(str::trim);
        let length: usize = field("content-length:").ok_or("no length")?.parse()?;
        let solve = field("server-timing:").and_then(|timing| timing.split("solve;dur=").nth(1));
        let solve = solve.and_then(|rest| rest.split(',').next()?.parse().ok()).unwrap_or(0.0);
        let status = head.split(' ').nth(1).and_then(|status| status.parse().ok()).ok_or("no status")?;
        while self.heard.len() < start + length {
            self.more()?;
        }
        let body = self.heard.get(start..start + length).unwrap_or_default().to_vec();
        Ok(Answer { status, body, solve })
    }

    fn more(&mut self) -> Outcome<()> {
        let mut piece = [0; 16_384];
        let read = match self.stream.read(&mut piece) {
            Err(error) if matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::TimedOut) => {
                return Err("no answer in time".into());
            }
            read => read?,
        };
        if read == 0 {
            return Err("the server has closed the connection".into());
        }
        self.heard.extend_from_slice(piece.get(..read).unwrap_or_default());
        Ok(())
    }
}
