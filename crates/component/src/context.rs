use std::any::Any;
use std::cell::{OnceCell, RefCell};

use katydid_data::{Path, cast::Rules, text};
use katydid_definition::archive::Chunk;
use katydid_geometry::Tolerance;

use crate::{Call, Kept, Message, Notes, RhinoModel};

/// What a component's function may ask and tell besides its data.
#[derive(Debug)]
pub struct Context<'a> {
    call: &'a Call<'a>,
    /// The most bytes that an item of one of the outputs takes.
    item_bytes: usize,
    notes: RefCell<Notes>,
    path: RefCell<Path>,
    iteration: std::cell::Cell<usize>,
    prepared: OnceCell<Result<Box<dyn Any>, Message>>,
}

impl<'a> Context<'a> {
    pub(crate) fn new(call: &'a Call<'a>, item_bytes: usize) -> Self {
        Self {
            call,
            item_bytes,
            notes: RefCell::default(),
            path: RefCell::default(),
            iteration: std::cell::Cell::new(0),
            prepared: OnceCell::new(),
        }
    }

    pub(crate) fn into_notes(self) -> Notes {
        self.notes.into_inner()
    }

    pub(crate) fn enter_branch(&self, path: &Path) {
        self.path.replace(path.clone());
    }

    pub(crate) fn enter_iteration(&self, i: usize) {
        self.iteration.set(i);
    }

    /// The path of the branch that is being worked on.
    pub fn path(&self) -> Path {
        self.path.borrow().clone()
    }

    /// The number of this iteration in its branch.
    pub fn iteration(&self) -> usize {
        self.iteration.get()
    }

    /// Tells the user something; the component goes on.
    pub fn tell(&self, message: Message) {
        self.notes.borrow_mut().add(message);
    }

    /// Warns the user; the component goes on.
    pub fn warn(&self, text: impl Into<String>) {
        self.tell(Message::warning(text));
    }

    /// Something made once and used in every iteration: a formula parsed, a mask read.
    ///
    /// # Errors
    /// The message of `make`, in every iteration.
    pub fn prepared<T: 'static>(&self, make: impl FnOnce() -> Result<T, Message>) -> Result<&T, Message> {
        let made = self.prepared.get_or_init(|| make().map(|made| Box::new(made) as Box<dyn Any>));
        match made {
            Ok(made) => made.downcast_ref().ok_or_else(|| Message::error("Internal error: prepared twice")),
            Err(message) => Err(message.clone()),
        }
    }

    /// What the object has stored besides its ports.
    pub fn settings(&self) -> &'a Chunk {
        self.call.settings
    }

    /// The nickname of input `i`.
    pub fn input_name(&self, i: usize) -> &'a str {
        self.call.input_names.get(i).map_or("", String::as_str)
    }

    /// The number of inputs the object has.
    pub fn input_count(&self) -> usize {
        self.call.inputs.len()
    }

    /// Whether input `i` has any data at all.
    pub fn has_data(&self, i: usize) -> bool {
        self.call.inputs.get(i).is_some_and(|tree| !tree.is_empty())
    }

    /// The number of outputs the object has.
    pub fn output_count(&self) -> usize {
        self.call.output_count
    }

    /// Whether anybody reads output `i`; what nobody reads need not be made.
    pub fn is_wanted(&self, i: usize) -> bool {
        self.call.wanted.get(i).copied().unwrap_or(true)
    }

    /// The contents of a file that the user named.
    ///
    /// # Errors
    /// The message to give back when it may not or cannot be read, or is too large.
    pub fn read_file(&self, path: &str) -> Result<Vec<u8>, Message> {
        /// Larger files are hardly what a definition means to read.
        const MOST: u64 = 1 << 28;
        let bytes = self.call.files.read(path, MOST)?;
        self.bytes(bytes.len())?;
        Ok(bytes)
    }

    /// Writes a file, of whose path only the name counts; gives that name. Where whoever runs the definition wants no files, a
    /// warning says so, and nothing is written.
    ///
    /// # Errors
    /// The message to give back when the path has no name of a file, or the file is too large.
    pub fn write_file(&self, path: &str, bytes: Vec<u8>) -> Result<Option<String>, Message> {
        let Some(outbox) = self.call.outbox else {
            self.warn(
                "The file is not written: `katydid run --write FOLDER` writes the files of a definition",
            );
            return Ok(None);
        };
        self.bytes(bytes.len())?;
        outbox.put(path, bytes).map(Some)
    }

    /// Whether files that are written are wanted: making them may be left out else.
    pub fn writes_files(&self) -> bool {
        self.call.outbox.is_some()
    }

    /// What components keep from one solve to the next, where somebody looks on.
    pub fn kept(&self) -> Option<&'a Kept> {
        self.call.kept
    }

    /// The Rhino model that the definition looks into, when one is given.
    pub fn model(&self) -> Option<&'a RhinoModel> {
        self.call.model
    }

    /// How near is near enough in this document.
    pub fn tolerance(&self) -> Tolerance {
        self.call.rules.tolerance
    }

    /// Units and tolerances for casts.
    pub fn rules(&self) -> &'a Rules {
        &self.call.rules
    }

    /// Units and tolerances for texts.
    pub fn style(&self) -> text::Style {
        text::Style { units: self.call.rules.units, tolerance: self.call.rules.tolerance }
    }

    /// Asks whether `n` more items of the outputs may be made, before they are: for how many they are, and for the bytes
    /// that they take.
    ///
    /// # Errors
    /// The message to give back when that is more than the object may put out.
    pub fn items(&self, n: usize) -> Result<(), Message> {
        self.call.budget.fits(n)?;
        self.call.budget.asked(n.saturating_mul(self.item_bytes))
    }

    /// Asks for `n` more bytes before they are made.
    ///
    /// # Errors
    /// The message to give back when that is more than the object may put out.
    pub fn bytes(&self, n: usize) -> Result<(), Message> {
        self.call.budget.bytes(n)
    }

    /// To be asked now and then in long loops.
    ///
    /// # Errors
    /// The message to give back when the work shall stop.
    pub fn check(&self) -> Result<(), Message> {
        self.call.budget.check()
    }

    /// The same as a question that other threads may ask: whether the work shall stop.
    pub fn stop(&self) -> impl Fn() -> bool + Sync + use<'a> {
        let budget = self.call.budget;
        move || budget.check().is_err()
    }
}
