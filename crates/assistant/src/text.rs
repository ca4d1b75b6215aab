//! A definition as text, made once for each state: a large one takes a while to be written, and several calls look at it.

use std::sync::{Arc, OnceLock};

use katydid_definition::document::Document;
use katydid_definition::kd;
use katydid_session::Registry;
use katydid_studio::Form;

/// A state of a definition as text.
pub(crate) struct Text {
    /// The state that it is of.
    of: Arc<Document>,
    /// The text, and what it leaves out; why it cannot be written where it cannot.
    written: OnceLock<Result<kd::Written, String>>,
    /// What comes of the text when it is read again.
    again: OnceLock<Option<Document>>,
}

impl Text {
    pub(crate) fn new(of: Arc<Document>) -> Self {
        Self { of, written: OnceLock::new(), again: OnceLock::new() }
    }

    /// Whether it is the text of that state.
    pub(crate) fn is_of(&self, document: &Arc<Document>) -> bool {
        Arc::ptr_eq(&self.of, document)
    }

    /// The state that it is of.
    pub(crate) fn document(&self) -> &Arc<Document> {
        &self.of
    }

    /// The text, and what it leaves out.
    pub(crate) fn written(&self) -> Result<&kd::Written, String> {
        let made = || kd::write(&self.of, &Registry).map_err(|error| error.to_string());
        self.written.get_or_init(made).as_ref().map_err(Clone::clone)
    }

    /// The document that the text alone gives; none where it cannot be read.
    pub(crate) fn again(&self) -> Option<&Document> {
        let made = || {
            let written = self.written().ok()?;
            Some(katydid_studio::read(Form::Kd, written.text.as_bytes()).ok()?.0)
        };
        self.again.get_or_init(made).as_ref()
    }
}
