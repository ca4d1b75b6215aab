//! Writes down what happens, soon but not at once: a drag is written a few times a second.

use std::fmt;
use std::io;
use std::sync::Arc;
use std::time::Duration;

use katydid_definition::document::{Difference, Document};
use web_time::{Instant, SystemTime};

use super::record::{Begin, MAGIC, Record, Step, write};
use super::{Source, Store};

/// How long an edit of a gesture may wait to be written.
const SOON: Duration = Duration::from_millis(150);
/// A journal that has grown past this is written anew, shorter.
const LARGE: usize = 64 << 20;

/// A journal that is being written.
pub(crate) struct Journal {
    store: Box<dyn Store>,
    source: Source,
    /// Whether the document that it begins with is the one that was saved.
    saved: bool,
    /// How many bytes it has; 0 before it begins.
    length: usize,
    /// How many bytes it had when it was written anew.
    least: usize,
    /// The gesture that goes on, with the document as the journal knows it.
    waiting: Option<Waiting>,
    written: Moment,
    failure: Option<String>,
}

struct Waiting {
    name: String,
    gesture: u64,
    from: Arc<Document>,
    to: Arc<Document>,
}

/// A step to be written down again, when the journal is made shorter.
pub(crate) struct Kept {
    pub(crate) name: String,
    pub(crate) forth: Arc<Difference>,
    /// Whether it is undone.
    pub(crate) undone: bool,
}

impl fmt::Debug for Journal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Journal")
            .field("source", &self.source)
            .field("length", &self.length)
            .finish_non_exhaustive()
    }
}

impl Journal {
    /// A journal that goes on where the store has one of `length` bytes, or begins when there is something to write.
    pub(crate) fn new(store: Box<dyn Store>, source: Source, saved: bool, length: usize) -> Self {
        Self {
            store,
            source,
            saved,
            length,
            least: length,
            waiting: None,
            written: Moment::long_ago(),
            failure: None,
        }
    }

    /// Why it could not be written, if it could not; it is not tried again.
    pub(crate) fn failure(&self) -> Option<&str> {
        self.failure.as_deref()
    }

    /// Whether it has grown so long that it should be written anew.
    pub(crate) fn is_long(&self) -> bool {
        self.length > LARGE.max(self.least.saturating_mul(2))
    }

    /// Takes note of a step from one state to another.
    pub(crate) fn step(
        &mut self,
        name: &str,
        gesture: Option<u64>,
        difference: &Arc<Difference>,
        before: &Arc<Document>,
        after: &Arc<Document>,
    ) {
        if let (Some(waiting), Some(gesture)) = (&mut self.waiting, gesture)
            && waiting.gesture == gesture
        {
            waiting.to = Arc::clone(after);
            self.tick();
            return;
        }
        let recently = !self.written.is_past(SOON);
        match gesture {
            Some(gesture) if recently && self.length > 0 => {
                self.flush();
                self.waiting = Some(Waiting {
                    name: name.to_owned(),
                    gesture,
                    from: Arc::clone(before),
                    to: Arc::clone(after),
                });
            }
            _ => {
                let step =
                    Step { name: name.to_owned(), gesture, at: now(), difference: Arc::clone(difference) };
                self.note(&Record::Step(step), before);
            }
        }
    }

    /// Takes note that the last step was taken back. `before` is the document before that.
    pub(crate) fn undo(&mut self, before: &Arc<Document>) {
        self.note(&Record::Undo, before);
    }

    /// Takes note that the last step that was taken back was made again.
    pub(crate) fn redo(&mut self, before: &Arc<Document>) {
        self.note(&Record::Redo, before);
    }

    /// Takes note that the last step was taken back for good.
    pub(crate) fn abandon(&mut self, before: &Arc<Document>) {
        self.note(&Record::Abandon, before);
    }

    /// Writes what has waited long enough.
    pub(crate) fn tick(&mut self) {
        if self.waiting.is_some() && self.written.is_past(SOON) {
            self.flush();
        }
    }

    /// Writes what waits.
    pub(crate) fn flush(&mut self) {
        let Some(Waiting { name, gesture, from, to }) = self.waiting.take() else { return };
        let difference = Arc::new(Difference::between(&from, &to));
        let step = Step { name, gesture: Some(gesture), at: now(), difference };
        self.append(&Record::Step(step));
    }

    fn note(&mut self, record: &Record, before: &Arc<Document>) {
        if self.length == 0 {
            self.begin(before);
        }
        self.flush();
        self.append(record);
    }

    fn begin(&mut self, document: &Document) {
        let mut bytes = MAGIC.to_vec();
        let done = head(document, &self.source, self.saved).and_then(|head| write(&head, &mut bytes));
        match done {
            Ok(()) => self.replace(&bytes),
            Err(error) => self.failure = Some(error.to_string()),
        }
    }

    fn replace(&mut self, bytes: &[u8]) {
        let done = self.store.replace(bytes);
        self.length = bytes.len();
        self.least = self.length;
        self.told(done);
    }

    fn append(&mut self, record: &Record) {
        if self.failure.is_some() {
            return;
        }
        let mut bytes = Vec::new();
        if let Err(error) = write(record, &mut bytes) {
            self.failure = Some(error.to_string());
            return;
        }
        let done = self.store.append(&bytes);
        self.length += bytes.len();
        self.told(done);
    }

    fn told(&mut self, done: io::Result<()>) {
        self.written = Moment::now();
        if let Err(error) = done {
            self.failure = Some(error.to_string());
        }
    }

    /// Writes the journal anew, from an earlier state of the document and the steps since; when they are too many, from
    /// a later one.
    pub(crate) fn shorten(&mut self, mut base: Document, steps: &[Kept]) {
        self.waiting = None;
        let mut records: Vec<Vec<u8>> = Vec::with_capacity(steps.len());
        for step in steps {
            let mut bytes = Vec::new();
            let gesture = None;
            let step =
                Step { name: step.name.clone(), gesture, at: now(), difference: Arc::clone(&step.forth) };
            if let Err(error) = write(&Record::Step(step), &mut bytes) {
                self.failure = Some(error.to_string());
                return;
            }
            records.push(bytes);
        }
        // The newest steps that fit in half the length that makes it long.
        let mut room = LARGE / 2;
        let fits = records.iter().rev().take_while(|bytes| {
            room = room.saturating_sub(bytes.len());
            room > 0
        });
        let undone = steps.iter().filter(|step| step.undone).count();
        let first = records.len() - fits.count().max(undone).min(records.len());
        for step in steps.iter().take(first) {
            self.saved = false;
            if base.apply(&step.forth).is_err() {
                self.failure = Some("the steps do not fit each other".to_owned());
                return;
            }
        }
        let mut bytes = MAGIC.to_vec();
        let mut done = head(&base, &self.source, self.saved).and_then(|head| write(&head, &mut bytes));
        bytes.extend(records.into_iter().skip(first).flatten());
        for _ in 0..undone {
            done = done.and_then(|()| write(&Record::Undo, &mut bytes));
        }
        match done {
            Ok(()) => self.replace(&bytes),
            Err(error) => self.failure = Some(error.to_string()),
        }
    }

    /// Begins anew: the document was saved.
    pub(crate) fn restart(&mut self, source: Option<Source>) {
        if let Some(source) = source {
            self.source = source;
        }
        self.waiting = None;
        self.saved = true;
        self.failure = None;
        self.replace(&[]);
    }
}

impl Drop for Journal {
    fn drop(&mut self) {
        self.flush();
    }
}

fn head(document: &Document, source: &Source, saved: bool) -> Result<Record, katydid_definition::Error> {
    Ok(Record::Begin(Box::new(Begin {
        source: source.clone(),
        saved,
        encoding: document.encoding,
        document: document.to_gh()?,
    })))
}

/// Seconds since 1970.
fn now() -> u64 {
    SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).map_or(0, |time| time.as_secs())
}

/// A moment, or none that is known: long ago.
#[derive(Debug, Clone, Copy)]
struct Moment(Option<Instant>);

impl Moment {
    fn long_ago() -> Self {
        Self(None)
    }

    fn now() -> Self {
        Self(Some(Instant::now()))
    }

    /// Whether so much time has gone by since.
    fn is_past(self, time: Duration) -> bool {
        self.0.is_none_or(|at| at.elapsed() >= time)
    }
}
