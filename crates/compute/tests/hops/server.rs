//! A server on a port of its own, which answers as it is told.

use std::io::{BufRead, BufReader, Read, Write};
use std::net::{TcpListener, TcpStream};
use std::time::Duration;

use serde_json::Value as Json;

/// What came.
pub(crate) struct Asked {
    pub(crate) method: String,
    pub(crate) path: String,
    /// What the header `RhinoComputeKey` says.
    pub(crate) key: Option<String>,
    pub(crate) body: Json,
}

/// A type of content and a body, or no answer at all.
pub(crate) type Reply = Option<(&'static str, Vec<u8>)>;

/// Starts one, and gives its port.
pub(crate) fn serve(answer: impl Fn(&Asked) -> Reply + Clone + Send + 'static) -> u16 {
    let listener = TcpListener::bind("127.0.0.1:0").unwrap();
    let port = listener.local_addr().unwrap().port();
    std::thread::spawn(move || {
        for stream in listener.incoming().flatten() {
            let answer = answer.clone();
            std::thread::spawn(move || talk(stream, answer));
        }
    });
    port
}

fn talk(stream: TcpStream, answer: impl Fn(&Asked) -> Reply) -> Option<()> {
    let mut reader = BufReader::new(stream.try_clone().ok()?);
    loop {
        let mut first = String::new();
        reader.read_line(&mut first).ok().filter(|n| *n > 0)?;
        let (mut length, mut key) = (0, None);
        loop {
            let mut line = String::new();
            reader.read_line(&mut line).ok()?;
            let Some((name, value)) = line.trim().split_once(':') else { break };
            match name.to_ascii_lowercase().as_str() {
                "content-length" => length = value.trim().parse().ok()?,
                "rhinocomputekey" => key = Some(value.trim().to_owned()),
                _ => {}
            }
        }
        let mut body = vec![0; length];
        reader.read_exact(&mut body).ok()?;
        let mut words = first.split(' ').map(str::to_owned);
        let (method, path) = (words.next()?, words.next()?);
        let body = serde_json::from_slice(&body).unwrap_or(Json::Null);
        let Some((kind, text)) = answer(&Asked { method, path, key, body }) else {
            std::thread::sleep(Duration::from_secs(60));
            return None;
        };
        let head =
            format!("HTTP/1.1 200 OK\r\nContent-Type: {kind}\r\nContent-Length: {}\r\n\r\n", text.len());
        (&stream).write_all(&[head.as_bytes(), &text].concat()).ok()?;
    }
}
