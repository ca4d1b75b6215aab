//! What is looked at beneath the HTTP library: clients that do not take what they are sent, and requests that say twice
//! how long they are, by `Content-Length` and by `Transfer-Encoding`.
//!
//! Two servers behind each other may believe different ones, and then take different bytes for the next request (RFC
//! 9112, section 6.1). The HTTP library believes the one and drops the other before anybody can see it, so the bytes are
//! followed on their way in: heads are read for these two fields, bodies are passed over by their length.

use std::pin::Pin;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::task::{Context, Poll};
use std::time::Duration;

use tokio::io::{AsyncRead, AsyncWrite, ReadBuf};
use tokio::time::{Sleep, sleep};

/// So many bytes of a line are kept: the two fields are shorter.
const LINE: usize = 256;

/// A client that takes nothing of what is sent for so long is gone.
const SILENCE: Duration = Duration::from_secs(60);

/// A connection whose requests are followed.
#[derive(Debug)]
pub(crate) struct Followed<S> {
    stream: S,
    requests: Requests,
    is_doubtful: Arc<AtomicBool>,
    /// When the other side has taken nothing for too long, while something is to be sent.
    given_up: Option<Pin<Box<Sleep>>>,
}

impl<S> Followed<S> {
    /// The connection, and whether one of its requests has said its length twice.
    pub(crate) fn new(stream: S) -> (Self, Arc<AtomicBool>) {
        let is_doubtful = Arc::new(AtomicBool::new(false));
        let requests = Requests::default();
        (Self { stream, requests, is_doubtful: Arc::clone(&is_doubtful), given_up: None }, is_doubtful)
    }

    /// What came of sending; an error when the other side has taken nothing for too long.
    fn sent<T>(&mut self, cx: &mut Context<'_>, sent: Poll<std::io::Result<T>>) -> Poll<std::io::Result<T>> {
        if sent.is_ready() {
            self.given_up = None;
            return sent;
        }
        let given_up = self.given_up.get_or_insert_with(|| Box::pin(sleep(SILENCE)));
        given_up.as_mut().poll(cx).map(|()| Err(std::io::ErrorKind::TimedOut.into()))
    }
}

impl<S: AsyncRead + Unpin> AsyncRead for Followed<S> {
    fn poll_read(
        mut self: Pin<&mut Self>,
        cx: &mut Context<'_>,
        buf: &mut ReadBuf<'_>,
    ) -> Poll<std::io::Result<()>> {
        let before = buf.filled().len();
        let read = Pin::new(&mut self.stream).poll_read(cx, buf);
        if self.requests.follow(buf.filled().get(before..).unwrap_or_default()) {
            self.is_doubtful.store(true, Ordering::Release);
        }
        read
    }
}

impl<S: AsyncWrite + Unpin> AsyncWrite for Followed<S> {
    fn poll_write(
        mut self: Pin<&mut Self>,
        cx: &mut Context<'_>,
        bytes: &[u8],
    ) -> Poll<std::io::Result<usize>> {
        let sent = Pin::new(&mut self.stream).poll_write(cx, bytes);
        self.sent(cx, sent)
    }

    fn poll_flush(mut self: Pin<&mut Self>, cx: &mut Context<'_>) -> Poll<std::io::Result<()>> {
        Pin::new(&mut self.stream).poll_flush(cx)
    }

    fn poll_shutdown(mut self: Pin<&mut Self>, cx: &mut Context<'_>) -> Poll<std::io::Result<()>> {
        Pin::new(&mut self.stream).poll_shutdown(cx)
    }

    fn poll_write_vectored(
        mut self: Pin<&mut Self>,
        cx: &mut Context<'_>,
        parts: &[std::io::IoSlice<'_>],
    ) -> Poll<std::io::Result<usize>> {
        let sent = Pin::new(&mut self.stream).poll_write_vectored(cx, parts);
        self.sent(cx, sent)
    }

    fn is_write_vectored(&self) -> bool {
        self.stream.is_write_vectored()
    }
}

/// Where in the requests of a connection the bytes have come to.
#[derive(Debug, Default)]
struct Requests {
    place: Place,
    /// The beginning of the line that is read.
    line: Vec<u8>,
    length: Option<u64>,
    has_encoding: bool,
}

#[derive(Debug, Default, Clone, Copy, PartialEq, Eq)]
enum Place {
    /// Before a request, where empty lines do not count.
    #[default]
    Before,
    Head,
    /// So many bytes are left of a body, or of a piece of one.
    Body(u64),
    Piece(u64),
    /// The line with the length of a piece.
    Size,
    /// The lines behind the last piece.
    Trailer,
    /// The bytes make no sense: the HTTP library refuses them.
    Lost,
}

impl Requests {
    /// Follows more bytes; whether a head among them says its length twice.
    fn follow(&mut self, mut bytes: &[u8]) -> bool {
        let mut is_doubtful = false;
        while !bytes.is_empty() {
            match self.place {
                Place::Lost => break,
                Place::Body(left) | Place::Piece(left) => {
                    let skipped = usize::try_from(left).map_or(bytes.len(), |left| left.min(bytes.len()));
                    bytes = bytes.get(skipped..).unwrap_or_default();
                    self.pass(left - skipped as u64);
                }
                _ => {
                    let end = bytes.iter().position(|byte| *byte == b'\n');
                    let (part, rest) = bytes.split_at(end.map_or(bytes.len(), |end| end + 1));
                    let room = LINE - self.line.len();
                    self.line.extend_from_slice(part.get(..room).unwrap_or(part));
                    bytes = rest;
                    if end.is_some() {
                        is_doubtful |= self.line();
                        self.line.clear();
                    }
                }
            }
        }
        is_doubtful
    }

    fn pass(&mut self, left: u64) {
        self.place = match (self.place, left) {
            (Place::Body(_), 0) => Place::Before,
            (Place::Piece(_), 0) => Place::Size,
            (Place::Body(_), left) => Place::Body(left),
            (_, left) => Place::Piece(left),
        };
    }

    /// Takes in a whole line; whether it ends a head that says its length twice.
    fn line(&mut self) -> bool {
        let text = String::from_utf8_lossy(&self.line);
        let text = text.trim_end();
        match self.place {
            Place::Before if text.is_empty() => {}
            Place::Before => (self.place, self.length, self.has_encoding) = (Place::Head, None, false),
            Place::Head if text.is_empty() => return self.head(),
            Place::Head => {
                if let Some((name, value)) = text.split_once(':') {
                    match name.trim_end().to_ascii_lowercase().as_str() {
                        "transfer-encoding" => self.has_encoding = true,
                        "content-length" => self.length = Some(value.trim().parse().unwrap_or(u64::MAX)),
                        _ => {}
                    }
                }
            }
            Place::Size => {
                let digits = text.split(';').next().unwrap_or_default().trim();
                self.place = match u64::from_str_radix(digits, 16) {
                    Ok(0) => Place::Trailer,
                    // The end of its line belongs to a piece.
                    Ok(size) => size.checked_add(2).map_or(Place::Lost, Place::Piece),
                    Err(_) => Place::Lost,
                };
            }
            Place::Trailer if text.is_empty() => self.place = Place::Before,
            _ => {}
        }
        false
    }

    fn head(&mut self) -> bool {
        self.place = match (self.has_encoding, self.length) {
            (true, Some(_)) => Place::Lost,
            (true, None) => Place::Size,
            (false, Some(1..)) => Place::Body(self.length.unwrap_or_default()),
            (false, _) => Place::Before,
        };
        self.has_encoding && self.length.is_some()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whether a stream has a doubtful request, however it is cut.
    fn doubtful(stream: &str) -> bool {
        let whole = Requests::default().follow(stream.as_bytes());
        for size in [1, 2, 3, 7, 50] {
            let mut requests = Requests::default();
            let found =
                stream.as_bytes().chunks(size).fold(false, |found, part| requests.follow(part) | found);
            assert_eq!(found, whole, "{size}: {stream}");
        }
        whole
    }

    #[test]
    fn both_lengths_in_one_head_are_seen() {
        let (length, pieces) = ("Content-Length: 5\r\n", "Transfer-Encoding: chunked\r\n");
        let plain = format!("POST / HTTP/1.1\r\n{length}\r\nhello");
        let chunked = format!("POST / HTTP/1.1\r\n{pieces}\r\n5;x=1\r\nhello\r\n0\r\nA: b\r\n\r\n");
        let get = "\r\nGET / HTTP/1.1\nHost: x\n\n";
        let twice = format!("POST / HTTP/1.1\r\n{length}{pieces}\r\n0\r\n\r\n");
        for good in [&plain, &chunked, get, &format!("{plain}{chunked}{get}{plain}"), "", "\u{1}\u{2}"] {
            assert!(!doubtful(good), "{good}");
            assert!(good.starts_with('\u{1}') || doubtful(&format!("{good}{twice}")), "{good}");
        }
        let turned = format!("POST / HTTP/1.1\r\n{}{}\r\n", pieces.to_uppercase(), length.to_lowercase());
        assert!(doubtful(&turned));
        // What stands in a body is no field.
        let body = format!("{length}{pieces}\r\n\r\n");
        let inner = format!("POST / HTTP/1.1\r\nContent-Length: {}\r\n\r\n{body}{get}", body.len());
        assert!(!doubtful(&inner));
        let piece = format!("POST / HTTP/1.1\r\n{pieces}\r\n{:x}\r\n{body}\r\n0\r\n\r\n{get}", body.len());
        assert!(!doubtful(&piece));
        let long = format!("GET / HTTP/1.1\r\nX: {}\r\n{length}{pieces}\r\n", "a".repeat(1000));
        assert!(doubtful(&long));
        for odd in ["zz", "ffffffffffffffff", "-1", ""] {
            doubtful(&format!("POST / HTTP/1.1\r\n{pieces}\r\n{odd}\r\n{twice}"));
        }
    }
}
