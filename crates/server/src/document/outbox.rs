//! What one client has yet to hear.
//!
//! Answers and patches go out in order. Results, geometry and progress are kept by object, the newest over the one
//! before: a client that reads slowly misses what lies between, and memory does not grow. When too many patches wait, they
//! are dropped, and the client gets the whole document instead.

use std::collections::{HashMap, VecDeque};
use std::sync::{Arc, Mutex};
use std::time::Duration;

use bytes::Bytes;
use katydid_session::protocol::{Event, ResultView};
use katydid_studio::About;
use tokio::sync::Notify;
use uuid::Uuid;

use crate::geometry::Geometry;
use crate::lock::held;

/// So many patches may wait.
const MOST_PATCHES: usize = 256;
/// Geometry up to this goes through the socket; larger is fetched, which browsers do faster.
const LARGEST_FRAME: usize = 512 << 10;
/// Geometry that goes through the socket at once; the rest is fetched.
const MOST_FRAMES: usize = 4 << 20;

/// A message as it goes through the socket.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Message {
    /// An event.
    Text(String),
    /// Geometry.
    Binary(Bytes),
}

/// What one client has yet to hear.
#[derive(Debug, Default)]
pub(crate) struct Outbox {
    waiting: Mutex<Waiting>,
    bell: Notify,
}

#[derive(Debug, Default)]
struct Waiting {
    ordered: VecDeque<Event>,
    patches: usize,
    progress: Option<Event>,
    results: Results,
    previews: Drawings,
    analyses: Drawings,
    about: Option<About>,
    probed: Option<Event>,
    /// Whether patches were dropped.
    is_late: bool,
    /// Whether the document was told so.
    is_told: bool,
    is_closed: bool,
}

/// Geometry, the newest of each object.
#[derive(Debug, Default)]
struct Drawings {
    by_object: HashMap<Uuid, Option<Arc<Geometry>>>,
    solution: u64,
    is_draft: bool,
}

impl Drawings {
    fn put(&mut self, solution: u64, is_draft: bool, changes: &[(Uuid, Option<Arc<Geometry>>)]) {
        (self.solution, self.is_draft) = (solution, is_draft);
        self.by_object.extend(changes.iter().cloned());
    }

    /// The objects with the hashes of their geometry.
    fn names(&self) -> Vec<(Uuid, Option<String>)> {
        let hash = |geometry: &Option<Arc<Geometry>>| geometry.as_ref().map(|geometry| geometry.hash.clone());
        self.by_object.iter().map(|(id, geometry)| (*id, hash(geometry))).collect()
    }
}

#[derive(Debug, Default)]
struct Results {
    solution: u64,
    within: Vec<Uuid>,
    order: Vec<Uuid>,
    by_object: HashMap<Uuid, ResultView>,
    end: Option<End>,
}

/// How a solve ended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct End {
    pub(crate) cancelled: bool,
    pub(crate) took: Duration,
}

/// What is to be sent.
#[derive(Debug, Default)]
pub(crate) struct Parcel {
    pub(crate) messages: Vec<Message>,
    /// How many answers are among them.
    pub(crate) answers: usize,
    /// Whether the client must be given the whole document.
    pub(crate) is_late: bool,
    /// Whether nothing will come any more.
    pub(crate) is_closed: bool,
}

fn is_answer(event: &Event) -> bool {
    matches!(
        event,
        Event::Done { .. }
            | Event::Refused { .. }
            | Event::Rows { .. }
            | Event::Copied { .. }
            | Event::Explained { .. }
            | Event::Nurbs { .. }
            | Event::Effects { .. }
            | Event::Solved { .. }
            | Event::Motion { .. }
    )
}

impl Outbox {
    /// Puts an event in line.
    pub(crate) fn put(&self, event: Event) {
        let mut waiting = held(&self.waiting);
        match &event {
            Event::Document(_) => {
                // All that was said of the document before is in it.
                waiting.forget_document();
                waiting.is_late = false;
                waiting.is_told = false;
            }
            Event::Patch { .. } if waiting.is_late => return,
            Event::Patch { .. } => {
                waiting.patches += 1;
                if waiting.patches > MOST_PATCHES {
                    waiting.forget_document();
                    waiting.is_late = true;
                    drop(waiting);
                    return self.bell.notify_one();
                }
            }
            _ => {}
        }
        waiting.ordered.push_back(event);
        drop(waiting);
        self.bell.notify_one();
    }

    /// How far a solve has come.
    pub(crate) fn progress(&self, event: Event) {
        held(&self.waiting).progress = Some(event);
        self.bell.notify_one();
    }

    /// Results of a solve; `end` with the last.
    pub(crate) fn results(&self, solution: u64, within: &[Uuid], results: &[ResultView], end: Option<End>) {
        let mut waiting = held(&self.waiting);
        let all = &mut waiting.results;
        if all.within != within {
            *all = Results { within: within.to_vec(), ..Results::default() };
        }
        all.solution = solution;
        for result in results {
            if all.by_object.insert(result.id, result.clone()).is_none() {
                all.order.push(result.id);
            }
        }
        all.end = end;
        if end.is_some() {
            waiting.progress = None;
        }
        drop(waiting);
        self.bell.notify_one();
    }

    /// Geometry that has changed.
    pub(crate) fn previews(&self, solution: u64, is_draft: bool, previews: &[(Uuid, Option<Arc<Geometry>>)]) {
        if previews.is_empty() {
            return;
        }
        held(&self.waiting).previews.put(solution, is_draft, previews);
        self.bell.notify_one();
    }

    /// An analysis that has changed.
    pub(crate) fn analysed(
        &self,
        solution: u64,
        is_draft: bool,
        changes: &[(Uuid, Option<Arc<Geometry>>)],
        about: &About,
    ) {
        let mut waiting = held(&self.waiting);
        waiting.analyses.put(solution, is_draft, changes);
        waiting.about = Some(about.clone());
        drop(waiting);
        self.bell.notify_one();
    }

    /// What is at the places that were asked about.
    pub(crate) fn probed(&self, event: Event) {
        held(&self.waiting).probed = Some(event);
        self.bell.notify_one();
    }

    /// Nothing more will come.
    pub(crate) fn close(&self) {
        held(&self.waiting).is_closed = true;
        self.bell.notify_one();
    }

    /// Waits until there is something, and takes all of it.
    pub(crate) async fn take(&self) -> Parcel {
        loop {
            let parcel = held(&self.waiting).take();
            if !parcel.messages.is_empty() || parcel.is_late || parcel.is_closed {
                return parcel;
            }
            self.bell.notified().await;
        }
    }
}

impl Waiting {
    fn forget_document(&mut self) {
        self.ordered.retain(|event| !matches!(event, Event::Document(_) | Event::Patch { .. }));
        self.patches = 0;
        self.results = Results::default();
        self.previews = Drawings::default();
        (self.analyses, self.about) = (Drawings::default(), None);
        self.progress = None;
    }

    fn take(&mut self) -> Parcel {
        let is_late = self.is_late && !std::mem::replace(&mut self.is_told, self.is_late);
        let mut parcel = Parcel { is_late, is_closed: self.is_closed, ..Parcel::default() };
        self.patches = 0;
        for event in self.ordered.drain(..) {
            parcel.answers += usize::from(is_answer(&event));
            parcel.say(&event);
        }
        if let Some(event) = self.progress.take() {
            parcel.say(&event);
        }
        // What a picture is made of comes before what is said about it.
        if !self.previews.by_object.is_empty() {
            let previews = std::mem::take(&mut self.previews);
            parcel.frames(&previews);
            let objects = previews.names();
            parcel.say(&Event::Preview { solution: previews.solution, draft: previews.is_draft, objects });
        }
        let mut results = std::mem::take(&mut self.results);
        if !results.order.is_empty() || results.end.is_some() {
            let order = std::mem::take(&mut results.order);
            parcel.say(&Event::Results {
                solution: results.solution,
                within: results.within.clone(),
                results: order.iter().filter_map(|id| results.by_object.remove(id)).collect(),
                finished: results.end.is_some(),
                cancelled: results.end.is_some_and(|end| end.cancelled),
                milliseconds: results.end.map_or(0.0, |end| end.took.as_secs_f64() * 1e3),
            });
        }
        if let Some(About { comb, left_out }) = self.about.take() {
            let analyses = std::mem::take(&mut self.analyses);
            parcel.frames(&analyses);
            let (solution, draft, objects) = (analyses.solution, analyses.is_draft, analyses.names());
            parcel.say(&Event::Analysed { solution, draft, objects, comb, left_out });
        }
        if let Some(event) = self.probed.take() {
            parcel.say(&event);
        }
        parcel
    }
}

impl Parcel {
    fn say(&mut self, event: &Event) {
        // Events are plain data: they always have a text.
        if let Ok(text) = serde_json::to_string(event) {
            self.messages.push(Message::Text(text));
        }
    }

    /// Small geometry goes before the event that names it, all of it in one frame: who hears of it has it. A frame for
    /// each object would cost the page more than what is in them.
    fn frames(&mut self, drawings: &Drawings) {
        let mut frame = Vec::new();
        for geometry in drawings.by_object.values().flatten() {
            let is_small = geometry.bytes.len() <= LARGEST_FRAME;
            if is_small && frame.len() + geometry.framed_size() <= MOST_FRAMES {
                geometry.write(&mut frame);
            }
        }
        if !frame.is_empty() {
            self.messages.push(Message::Binary(frame.into()));
        }
    }
}

#[cfg(test)]
mod tests {
    use katydid_session::protocol::Notice;

    use super::*;

    fn patch(revision: u64) -> Event {
        Event::Patch { revision, within: vec![], put: vec![], removed: vec![], order: None, document: None }
    }

    fn result(id: u128, milliseconds: f64) -> ResultView {
        ResultView {
            id: Uuid::from_u128(id),
            status: "ok".to_owned(),
            messages: vec![],
            lacks: vec![],
            milliseconds,
            outputs: vec![],
            panel: None,
        }
    }

    #[test]
    fn the_newest_result_of_an_object_takes_the_place_of_the_one_before() {
        let outbox = Outbox::default();
        for k in 0..1000 {
            outbox.results(k, &[], &[result(1, k as f64), result(2, 0.0)], None);
        }
        let parcel = held(&outbox.waiting).take();
        let [Message::Text(text)] = parcel.messages.as_slice() else { unreachable!("{:?}", parcel.messages) };
        assert!(text.contains("\"solution\":999") && text.contains("999.0") && !text.contains("998.0"));
    }

    #[test]
    fn who_is_late_gets_the_whole_document() {
        let outbox = Outbox::default();
        outbox.put(Event::Done { seq: 1, revision: 1, made: vec![] });
        for k in 0..10_000 {
            outbox.put(patch(k));
        }
        let parcel = held(&outbox.waiting).take();
        assert!(parcel.is_late && parcel.messages.len() == 1 && parcel.answers == 1);
        outbox.put(patch(10_001));
        let parcel = held(&outbox.waiting).take();
        assert!(parcel.messages.is_empty() && !parcel.is_late, "it is said once");
    }

    #[test]
    fn small_geometry_goes_along_and_large_is_named() {
        let outbox = Outbox::default();
        let geometry = |hash: &str, size: usize| {
            Some(Arc::new(Geometry { hash: hash.repeat(16), bytes: vec![7; size].into() }))
        };
        let all = [
            (Uuid::from_u128(1), geometry("0a", 100)),
            (Uuid::from_u128(2), geometry("ff", 1 << 20)),
            (Uuid::from_u128(3), None),
        ];
        outbox.previews(7, true, &all);
        outbox.put(Event::Notice(Notice { level: "remark".to_owned(), text: "hello".to_owned() }));
        let parcel = held(&outbox.waiting).take();
        assert_eq!(parcel.messages.len(), 3);
        let [_, Message::Binary(frame), Message::Text(text)] = parcel.messages.as_slice() else {
            unreachable!("{:?}", parcel.messages)
        };
        assert_eq!(frame[..16], [10; 16], "the frame says its hash");
        assert_eq!(frame[16..24], [100, 0, 0, 0, 0, 0, 0, 0], "and its length");
        assert_eq!(frame[24..124], [7; 100]);
        assert_eq!(frame[124..], [0; 4]);
        assert!(text.contains(&"0a".repeat(16)) && text.contains(&"ff".repeat(16)));
    }
}
