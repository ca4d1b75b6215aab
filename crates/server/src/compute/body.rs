//! What a client sends, taken in within bounds of size, time and memory.

use std::io::Read;
use std::sync::Arc;
use std::time::Duration;

use axum::body::{Body, BodyDataStream};
use axum::http::header::{CONTENT_ENCODING, CONTENT_LENGTH, EXPECT};
use axum::http::{HeaderMap, StatusCode};
use bytes::Bytes;
use flate2::read::{MultiGzDecoder, ZlibDecoder};
use futures_util::StreamExt;
use tokio::sync::{OwnedSemaphorePermit, Semaphore};
use tokio::time::{Instant, timeout, timeout_at};

use super::refusal::Refusal;

/// Memory for bodies is handed out in pieces of this size.
const PIECE: usize = 64 << 10;
/// A client that sends nothing for so long is gone.
const SILENCE: Duration = Duration::from_secs(15);
/// How long a body may wait for memory.
const WAIT: Duration = Duration::from_secs(10);
/// What is refused is still heard for so long: most clients listen only when they have said all.
const HEAR: Duration = Duration::from_secs(10);

/// The memory that all bodies together may take.
#[derive(Debug, Clone)]
pub(crate) struct Room {
    pieces: Arc<Semaphore>,
    /// The most bytes of one body.
    most: usize,
    /// How long a body may take to arrive.
    time: Duration,
}

/// A body as it came. Copies share it.
#[derive(Debug, Clone)]
pub(crate) struct Received {
    bytes: Bytes,
    packing: Packing,
    /// Given back when the body is no longer needed.
    _room: Option<Arc<OwnedSemaphorePermit>>,
    most: usize,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Packing {
    None,
    Gzip,
    Zlib,
}

impl Room {
    pub(crate) fn new(most: usize, time: Duration) -> Self {
        let all = most.saturating_mul(8).max(512 << 20);
        Self { pieces: Arc::new(Semaphore::new(all.div_ceil(PIECE))), most, time }
    }

    fn too_large(&self) -> Refusal {
        Refusal::too_large(format!("the request has more than {} bytes", self.most))
    }

    /// Takes in a body.
    pub(crate) async fn receive(&self, headers: &HeaderMap, body: Body) -> Result<Received, Refusal> {
        let mut stream = body.into_data_stream();
        let packing = packing(headers)?;
        let told = headers.get(CONTENT_LENGTH).and_then(|length| length.to_str().ok()?.parse::<u64>().ok());
        if told.is_some_and(|length| length > self.most as u64) {
            if !headers.contains_key(EXPECT) && told.is_some_and(|n| n <= 4 * self.most as u64) {
                self.hear_out(&mut stream).await;
            }
            return Err(self.too_large());
        }
        let mut bytes = Vec::new();
        let mut room: Option<OwnedSemaphorePermit> = None;
        let end = Instant::now() + self.time;
        loop {
            let next = timeout(SILENCE, timeout_at(end, stream.next())).await;
            let Ok(Ok(next)) = next else { return Err(Refusal::late("the request did not arrive in time")) };
            let Some(chunk) = next else { break };
            let chunk = chunk.map_err(|_| Refusal::bad("the request broke off"))?;
            if bytes.len() + chunk.len() > self.most {
                self.hear_out(&mut stream).await;
                return Err(self.too_large());
            }
            let pieces = (bytes.len() + chunk.len()).div_ceil(PIECE);
            let missing = pieces.saturating_sub(room.as_ref().map_or(0, OwnedSemaphorePermit::num_permits));
            if missing > 0 {
                let more = self.more(missing).await?;
                match &mut room {
                    Some(room) => room.merge(more),
                    None => room = Some(more),
                }
            }
            bytes.extend_from_slice(&chunk);
        }
        Ok(Received { bytes: bytes.into(), packing, _room: room.map(Arc::new), most: self.most })
    }

    async fn more(&self, pieces: usize) -> Result<OwnedSemaphorePermit, Refusal> {
        let pieces = u32::try_from(pieces).unwrap_or(u32::MAX);
        match timeout(WAIT, Arc::clone(&self.pieces).acquire_many_owned(pieces)).await {
            Ok(Ok(more)) => Ok(more),
            _ => Err(Refusal::busy("there is no memory for this request now", 5)),
        }
    }

    /// Lets a client finish its sentence, so that it hears the answer.
    async fn hear_out(&self, stream: &mut BodyDataStream) {
        let mut left = self.most.saturating_mul(4);
        let hear = async {
            while let Some(Ok(chunk)) = stream.next().await {
                left = left.saturating_sub(chunk.len());
                if left == 0 {
                    return;
                }
            }
        };
        let _ = timeout(HEAR, hear).await;
    }
}

fn packing(headers: &HeaderMap) -> Result<Packing, Refusal> {
    let Some(value) = headers.get(CONTENT_ENCODING) else { return Ok(Packing::None) };
    match value.to_str().unwrap_or_default().trim().to_ascii_lowercase().as_str() {
        "" | "identity" => Ok(Packing::None),
        "gzip" | "x-gzip" => Ok(Packing::Gzip),
        "deflate" => Ok(Packing::Zlib),
        _ => Err(Refusal::new(
            StatusCode::UNSUPPORTED_MEDIA_TYPE,
            "not-supported",
            "the request is packed in a way that is not known here: gzip, deflate or not at all",
        )),
    }
}

impl Received {
    /// The bytes as they came, to be sent on.
    pub(crate) fn as_sent(&self) -> Bytes {
        self.bytes.clone()
    }

    /// Whether reading it takes a while.
    pub(crate) fn is_large(&self) -> bool {
        const LARGE: usize = 1 << 18;
        let packed = if self.packing == Packing::None { 1 } else { 16 };
        self.bytes.len().saturating_mul(packed) > LARGE
    }

    /// The bytes, unpacked. Not for a thread that serves: it may take a while.
    pub(crate) fn unpacked(mut self) -> Result<Unpacked, Refusal> {
        let packed = match self.packing {
            Packing::None => return Ok(Unpacked(self)),
            Packing::Gzip => unpack(MultiGzDecoder::new(&*self.bytes), self.most),
            Packing::Zlib => unpack(ZlibDecoder::new(&*self.bytes), self.most),
        };
        self.bytes = packed?.into();
        Ok(Unpacked(self))
    }
}

/// A body that can be read. It keeps its room until it is dropped.
#[derive(Debug)]
pub(crate) struct Unpacked(Received);

impl std::ops::Deref for Unpacked {
    type Target = [u8];

    fn deref(&self) -> &[u8] {
        &self.0.bytes
    }
}

/// Unpacks no more than `most` bytes.
pub(crate) fn unpack(reader: impl Read, most: usize) -> Result<Vec<u8>, Refusal> {
    let mut bytes = Vec::new();
    let read = reader.take(most as u64 + 1).read_to_end(&mut bytes);
    if bytes.len() > most {
        return Err(Refusal::too_large(format!("unpacked, it has more than {most} bytes")));
    }
    read.map_err(|_| Refusal::bad("it is not packed as it says"))?;
    Ok(bytes)
}
