//! The socket between a client and a document.

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Duration;

use axum::Extension;
use axum::body::Bytes;
use axum::extract::rejection::QueryRejection;
use axum::extract::ws::rejection::WebSocketUpgradeRejection;
use axum::extract::ws::{Message as Frame, WebSocket, WebSocketUpgrade};
use axum::extract::{Query, State as Extract};
use axum::http::HeaderMap;
use axum::response::{IntoResponse, Response};
use futures_util::stream::{SplitSink, SplitStream};
use futures_util::{SinkExt, StreamExt};
use katydid_session::protocol::{Event, Notice, Request};
use serde::Deserialize;
use tokio::sync::Semaphore;
use tokio::time::{Instant, interval, timeout};

use super::State;
use super::answer::Refused;
use crate::document::{ClientId, Command, Handle, Message, Outbox, Source, Standing, id_of, left_behind};
use crate::listen::Peer;

/// A request has no more bytes: what is pasted is the largest.
const LARGEST: usize = 16 << 20;
/// So many requests of a client may wait for their answers; it is not heard until it has read some.
const MOST_WAITING: usize = 64;
/// Who does not take what is sent for so long is gone.
const SEND_TIME: Duration = Duration::from_secs(30);
/// How often a client is asked whether it is still there, and how long it may take to say so.
const PING: Duration = Duration::from_secs(20);
const SILENCE: Duration = Duration::from_secs(70);

/// Which document.
#[derive(Debug, Deserialize)]
pub(crate) struct Joining {
    document: String,
}

pub(crate) async fn join(
    Extract(state): Extract<Arc<State>>,
    query: Result<Query<Joining>, QueryRejection>,
    peer: Option<Extension<Peer>>,
    headers: HeaderMap,
    upgrade: Result<WebSocketUpgrade, WebSocketUpgradeRejection>,
) -> Response {
    let Ok(Query(Joining { document })) = query else {
        return Refused::bad("say which document").into_response();
    };
    let standing = standing(peer.map(|Extension(peer)| peer), &headers);
    let upgrade = match upgrade {
        Ok(upgrade) => upgrade,
        Err(error) => return Refused::bad(error.to_string()).into_response(),
    };
    let Some(handle) = find(&state, &document).await else {
        return Refused::missing("document").into_response();
    };
    upgrade
        .max_message_size(LARGEST)
        .max_frame_size(LARGEST)
        .on_upgrade(move |socket| serve(socket, handle, standing))
}

/// Whose page asks. A program of this machine that passes the requests of others on says so, as a rule.
pub(super) fn standing(peer: Option<Peer>, headers: &HeaderMap) -> Standing {
    let is_here = peer.is_some_and(|Peer(peer)| peer.ip().to_canonical().is_loopback());
    let is_passed_on =
        ["forwarded", "x-forwarded-for", "x-real-ip", "via"].iter().any(|name| headers.contains_key(*name));
    if is_here && !is_passed_on { Standing::Owner } else { Standing::Guest }
}

/// A document that is open; or one of the recent files, or one that was never saved and left its journal: a page asks
/// for them by their ids after the server was started anew.
async fn find(state: &Arc<State>, id: &str) -> Option<Handle> {
    if let Some(handle) = state.documents.get(id) {
        return Some(handle);
    }
    if !state.shared.trust.names_paths() {
        return None;
    }
    let (shared, wanted) = (Arc::clone(&state.shared), id.to_owned());
    let found = tokio::task::spawn_blocking(move || {
        let recent = shared.recent.as_ref().and_then(|recent| recent.find(|path| id_of(path) == wanted));
        if let Some(path) = recent {
            return Source::file(&path).ok();
        }
        let left = left_behind(shared.journals.as_deref()?);
        left.contains(&wanted).then(|| Source::left(&wanted))
    });
    let id = state.documents.open(found.await.ok()??).ok()?;
    state.documents.get(&id)
}

async fn serve(socket: WebSocket, handle: Handle, standing: Standing) {
    static NEXT: AtomicU64 = AtomicU64::new(1);
    let client: ClientId = NEXT.fetch_add(1, Ordering::Relaxed);
    let outbox = Arc::new(Outbox::default());
    let room = Arc::new(Semaphore::new(MOST_WAITING));
    let (writer, reader) = socket.split();
    if !handle.tell(Command::Join(client, Arc::clone(&outbox), standing)) {
        return;
    }
    let writing = write(writer, Arc::clone(&outbox), Arc::clone(&room), &handle, client);
    let reading = read(reader, &outbox, &room, &handle, client);
    tokio::select! {
        () = writing => {}
        () = reading => {}
    }
    handle.tell(Command::Leave(client));
}

/// Hears a client until it goes.
async fn read(
    mut reader: SplitStream<WebSocket>,
    outbox: &Outbox,
    room: &Semaphore,
    handle: &Handle,
    client: ClientId,
) {
    let mut heard = Instant::now();
    loop {
        let frame = match timeout(SILENCE.saturating_sub(heard.elapsed()), reader.next()).await {
            Ok(Some(Ok(frame))) => frame,
            _ => return,
        };
        heard = Instant::now();
        let text = match frame {
            Frame::Text(text) => text,
            Frame::Ping(_) | Frame::Pong(_) => continue,
            Frame::Binary(_) => {
                let text = "only text is understood here".to_owned();
                outbox.put(Event::Notice(Notice { level: "error".to_owned(), text }));
                continue;
            }
            Frame::Close(_) => return,
        };
        // The answer gives the place back when it is sent.
        match room.acquire().await {
            Ok(place) => place.forget(),
            Err(_) => return,
        }
        match serde_json::from_str::<Request>(text.as_str()) {
            Ok(request) => {
                if !handle.tell(Command::Ask(client, Box::new(request))) {
                    return;
                }
            }
            Err(error) => outbox.put(Event::Refused { seq: seq(text.as_str()), reason: error.to_string() }),
        }
    }
}

/// The number of a request that is not understood otherwise; 0 where it has none.
fn seq(text: &str) -> u64 {
    #[derive(Deserialize)]
    struct Numbered {
        seq: u64,
    }
    serde_json::from_str::<Numbered>(text).map_or(0, |numbered| numbered.seq)
}

/// Tells a client what there is until it goes.
async fn write(
    mut writer: SplitSink<WebSocket, Frame>,
    outbox: Arc<Outbox>,
    room: Arc<Semaphore>,
    handle: &Handle,
    client: ClientId,
) {
    let mut ping = interval(PING);
    ping.tick().await;
    loop {
        let parcel = tokio::select! {
            parcel = outbox.take() => parcel,
            _ = ping.tick() => {
                if send(&mut writer, Frame::Ping(Bytes::new())).await.is_none() {
                    return;
                }
                continue;
            }
        };
        if parcel.is_late && !handle.tell(Command::Refresh(client)) {
            return;
        }
        for message in parcel.messages {
            let frame = match message {
                Message::Text(text) => Frame::Text(text.into()),
                Message::Binary(bytes) => Frame::Binary(bytes),
            };
            if send(&mut writer, frame).await.is_none() {
                return;
            }
        }
        room.add_permits(parcel.answers);
        if parcel.is_closed {
            let _ = timeout(SEND_TIME, writer.close()).await;
            return;
        }
    }
}

async fn send(writer: &mut SplitSink<WebSocket, Frame>, frame: Frame) -> Option<()> {
    timeout(SEND_TIME, writer.send(frame)).await.ok()?.ok()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test may fail")]

    use super::*;

    #[test]
    fn only_whoever_is_at_the_machine_is_its_owner() {
        let peer = |text: &str| Some(Peer(text.parse().unwrap()));
        let plain = HeaderMap::new();
        assert_eq!(standing(peer("127.0.0.1:5000"), &plain), Standing::Owner);
        assert_eq!(standing(peer("[::1]:5000"), &plain), Standing::Owner);
        assert_eq!(standing(peer("[::ffff:127.0.0.1]:5000"), &plain), Standing::Owner);
        assert_eq!(standing(peer("192.168.1.7:5000"), &plain), Standing::Guest);
        assert_eq!(standing(None, &plain), Standing::Guest);
        let mut passed_on = HeaderMap::new();
        passed_on.insert("x-forwarded-for", "192.168.1.7".parse().unwrap());
        assert_eq!(standing(peer("127.0.0.1:5000"), &passed_on), Standing::Guest);
    }
}
