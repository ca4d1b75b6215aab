//! What goes out to the client, in order.

use katydid_session::protocol::Event;
use katydid_studio::write_frame;
use uuid::Uuid;

/// A message as a socket would have it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Message {
    /// An event, as JSON.
    Text(String),
    /// Geometry.
    Binary(Vec<u8>),
}

/// Geometry with the hash that names it.
#[derive(Debug, Clone)]
pub(crate) struct Named {
    pub(crate) hash: String,
    pub(crate) bytes: Vec<u8>,
}

/// Messages that wait to be taken.
#[derive(Debug, Default)]
pub(crate) struct Outgoing(Vec<Message>);

impl Outgoing {
    pub(crate) fn say(&mut self, event: &Event) {
        // Events are plain data: they always have a text.
        self.0.extend(serde_json::to_string(event).map(Message::Text));
    }

    /// Geometry goes before the event that names it, all of it in one frame.
    pub(crate) fn show<'a>(&mut self, geometries: impl Iterator<Item = &'a Named>) {
        let mut frame = Vec::new();
        for geometry in geometries {
            write_frame(&geometry.hash, &geometry.bytes, &mut frame);
        }
        if !frame.is_empty() {
            self.0.push(Message::Binary(frame));
        }
    }

    pub(crate) fn take(&mut self) -> Vec<Message> {
        std::mem::take(&mut self.0)
    }
}

/// What a client is told of geometry: objects with the hashes of theirs.
pub(crate) type Hashes = Vec<(Uuid, Option<String>)>;
